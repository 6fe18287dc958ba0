"""Plain data against the schema: every mistake as a sentence at its place, and what remains valid."""

import difflib
from collections.abc import Callable, Collection
from functools import cache, lru_cache
from typing import Any

from pydantic import BaseModel, ValidationError
from pydantic_core import ErrorDetails

from eom.vehicle.description import Description
from eom.vehicle.expression import shorten
from eom.vehicle.mirror import other_side
from eom.vehicle.quantity import describe
from eom.vehicle.source import Path, Source

COLLECTIONS = ("bodies", "connectors", "loads", "actuators", "sensors", "tyres", "templates", "units", "couplings")
MAX_ROUNDS = 50


def did_you_mean(name: str, known: Collection[str]) -> str:
    """A suggestion to add to a message, empty if nothing known is close."""
    return suggest(closest(name, known))


def suggest(name: str) -> str:
    """The question whether a name was meant, empty without one."""
    return f"; did you mean '{name}'?" if name else ""


def closest(name: str, known: Collection[str]) -> str:
    """The known name that is most like another one, empty if none is."""
    if name in known:
        return ""
    by_lower_case = {key.lower(): key for key in sorted(known)}
    close = difflib.get_close_matches(name.lower(), by_lower_case, n=1, cutoff=0.6)
    return by_lower_case[close[0]] if close else ""


def validate(source: Source) -> tuple[Description | None, frozenset[str]]:
    """The valid part of the source's description, and the names of parts left out because of mistakes.

    Mistakes are added to the source. Leaving out what is wrong and going on lets one run report all of them.
    """
    data: dict[str, Any] = {key: value for key, value in source.data.items() if value is not None}
    broken: set[str] = set()
    emptied: set[Path] = set()
    for _ in range(MAX_ROUNDS):
        try:
            return Description.model_validate(data), frozenset(broken)
        except ValidationError as error:
            # the whole round first, as leaving out one part would hide the others' places
            found = [(file_path(item["loc"], data, item["type"]), item) for item in error.errors(include_url=False)]
            meant = {(*path[:-1], meant_at(data, path)) for path, item in found if item["type"] == "extra_forbidden"}
            for path, item in found:
                if item["type"] == "missing" and path in meant:
                    continue
                if not is_consequence(path, item, emptied):
                    about_key = item["type"] == "extra_forbidden" or item["loc"][-1] == "[key]"
                    (source.report_key if about_key else source.report)(*sentence(data, path, item))
            for path, item in found:
                emptied.add(leave_out(data, path, item["type"], broken))
    return None, frozenset(broken)


def is_consequence(path: Path, item: ErrorDetails, emptied: set[Path]) -> bool:
    """Whether an error follows from one that is reported already.

    A key without a value is, and a collection that is empty only because its parts were left out.
    """
    without_value = item.get("input") is None and item["type"] != "missing"
    return without_value or (item["type"] == "too_short" and path in emptied)


def file_path(location: tuple[str | int, ...], data: object, kind: str) -> Path:
    """A pydantic location as a path in the file: without the names of the schema's alternatives."""
    path: list[str | int] = []
    here: Any = data
    told = False
    for k, step in enumerate(location):
        if not told and isinstance(here, dict) and step in (here.get("type"), here.get("kind")):
            # the type of a connector, the kind of a law stand before the key in it
            told = True
            continue
        if contains(here, step):
            here, told = here[step], False
        elif k + 1 < len(location) or (kind != "missing" and step in ALTERNATIVES):
            continue
        path.append(step)
    return tuple(path)


def contains(here: object, step: str | int) -> bool:
    """Whether a step of a location leads on from here."""
    if isinstance(here, list):
        return isinstance(step, int) and step < len(here)
    return isinstance(here, dict) and step in here


# what pydantic puts into locations for the alternatives of a union
ALTERNATIVES = frozenset(
    {
        "[key]",
        "unit",
        "use",
        "down",
        "vector",
        "products",
        "tensor",
        "described",
        "plain",
        "on_group",
        "on_bodies",
        "fitted",
        "from_file",
        "as_another",
    }
)


def sentence(data: dict[str, Any], path: Path, item: ErrorDetails) -> tuple[Path, str]:
    """Where a schema error is reported, and the sentence that says it."""
    kind, last = item["type"], path[-1] if path else ""
    if kind == "missing":
        count = len(item.get("input") or ())
        return path[:-1], f"has too few entries ({count})" if isinstance(last, int) else f"needs '{last}'"
    if kind == "extra_forbidden":
        return path, f"unknown key '{last}'{suggest(meant_at(data, path))}"
    say = SENTENCES.get(kind)
    came = describe(item.get("input"))
    return path, say(item.get("ctx", {}), came) if say else f"{item['msg'][0].lower()}{item['msg'][1:]}, got {came}"


def unknown_type(context: dict[str, Any], _: str) -> str:
    """The sentence for a connector of a type, or a law of a kind, that does not exist."""
    known = context["expected_tags"].replace("'", "").split(", ")
    guess = did_you_mean(context["tag"], known)
    word = context["discriminator"].strip("'")
    return f"unknown {word} '{shorten(context['tag'])}', expected one of {', '.join(known)}{guess}"


def wrong_length(context: dict[str, Any], _: str) -> str:
    """The sentence for a list or mapping with too many or too few entries."""
    if "max_length" in context:
        return f"has {context['actual_length'] or 'too many'} entries, expected at most {context['max_length']}"
    return f"has {context['actual_length'] or 'no'} entries, expected at least {context['min_length']}"


# per kind of pydantic error: its sentence from pydantic's context and from what came
SENTENCES: dict[str, Callable[[dict[str, Any], str], str]] = {
    "value_error": lambda context, _: str(context["error"]),
    "literal_error": lambda context, came: f"expected {context['expected']}, got {came}",
    "bool_type": lambda _, came: f"expected true or false, got {came}",
    "string_type": lambda _, came: f"expected text, got {came}",
    "string_pattern_mismatch": lambda _, came: f"{came} is no name: a letter, then letters, digits, underscores",
    "string_too_long": lambda context, _: f"is longer than {context['max_length']} characters",
    "too_long": wrong_length,
    "too_short": wrong_length,
    "union_tag_not_found": lambda context, _: f"needs {context['discriminator']}",
    "union_tag_invalid": unknown_type,
    "dict_type": lambda _, came: f"expected a mapping of keys, got {came}",
    "model_type": lambda _, came: f"expected a mapping of keys, got {came}",
    "model_attributes_type": lambda _, came: f"expected a mapping of keys, got {came}",
    "tuple_type": lambda _, came: f"expected a list, got {came}",
    "list_type": lambda _, came: f"expected a list, got {came}",
}


@cache
def vocabulary() -> tuple[frozenset[str], ...]:
    """The keys of every part of the schema."""
    keys: list[frozenset[str]] = []
    pending: list[type[BaseModel]] = [BaseModel]
    while pending:
        for model in pending.pop().__subclasses__():
            if model.__module__.startswith("eom."):
                keys.append(frozenset(field.alias or name for name, field in model.model_fields.items()))
            pending.append(model)
    return tuple(dict.fromkeys(keys))


@cache
def every_key() -> frozenset[str]:
    """Every key of the schema."""
    return frozenset().union(*vocabulary())


def meant_at(data: object, path: Path) -> str:
    """The key that an unknown one was probably meant to be, judged by the keys beside it; empty if none is close."""
    here: Any = data
    for step in path[:-1]:
        here = here[step] if contains(here, step) else {}
    beside = every_key().intersection(here if isinstance(here, dict) else ())
    return meant_key(str(path[-1]), beside)


@lru_cache(maxsize=2000)
def meant_key(name: str, beside: frozenset[str]) -> str:
    """The closest key of the parts that share most keys with those *beside* it, empty if none is close."""
    shared = max(len(keys & beside) for keys in vocabulary())
    return closest(name, frozenset().union(*(keys for keys in vocabulary() if len(keys & beside) == shared)))


def leave_out(data: dict[str, Any], path: Path, kind: str, broken: set[str]) -> Path:
    """Remove what *path* makes unusable: an unknown key alone, else the part it belongs to; return where from."""
    if path == ("name",):
        data["name"] = "unnamed"
        return ()
    depth = len(path) if kind == "extra_forbidden" else part_depth(path)
    here: Any = data
    for step in path[: depth - 1]:
        here = here.get(step) if isinstance(here, dict) else None
    if isinstance(here, dict) and path[depth - 1] in here:
        del here[path[depth - 1]]
        if kind != "extra_forbidden":
            name = str(path[depth - 1])
            broken.update({name, other_side(name)})
        elif depth == 1:
            # a whole section under a mistyped key
            broken.add(meant_at(data, path))
    return path[: depth - 1]


def part_depth(path: Path) -> int:
    """Length of the path of the innermost named part (a body, an axle ...) that *path* lies in."""
    parts = ("suspensions", "axle_groups", "axles", "bodies", "connectors")
    if len(path) > 3 and path[0] in {"units", "templates"} and path[2] in parts:
        return 4
    return 2 if len(path) > 1 and path[0] in {*COLLECTIONS, "parameters"} else 1
