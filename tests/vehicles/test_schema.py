"""The JSON Schema that editors use accepts what the loader accepts."""

import json

import jsonschema
import pytest
import yaml

from tests.vehicles.shipped import FOLDER, NAMES, text

SCHEMA = json.loads((FOLDER / "vehicle.schema.json").read_text(encoding="utf-8"))


@pytest.mark.parametrize("name", NAMES)
def test_shipped_vehicles_satisfy_the_schema_that_their_first_line_names(name: str) -> None:
    file = text(name)
    assert file.startswith("# yaml-language-server: $schema=vehicle.schema.json\n")
    jsonschema.Draft202012Validator(SCHEMA).validate(yaml.safe_load(file))


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("mass:", "mas:"),
        ("type: spring", "type: sprung"),
        ("forces: 2", "forces: 5"),
        ("measure: acceleration", "measure: jerk"),
    ],
)
def test_the_schema_marks_typos(old: str, new: str) -> None:
    validator = jsonschema.Draft202012Validator(SCHEMA)
    assert not validator.is_valid(yaml.safe_load(text("quarter_car").replace(old, new)))
