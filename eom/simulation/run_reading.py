"""Parts of a run file against their forms: values in SI units, every mistake at its place."""

from functools import cache
from typing import Any, NotRequired, get_args, get_origin, get_type_hints

from pydantic import TypeAdapter, ValidationError

from eom.vehicle.expression import evaluate, names
from eom.vehicle.quantity import Quantity, describe
from eom.vehicle.source import Data, Path, Source
from eom.vehicle.validate import closest, did_you_mean, sentence


@cache
def adapters(form: type) -> dict[str, TypeAdapter[Any]]:
    """What validates each key of a form."""
    hints = get_type_hints(form, include_extras=True).items()
    return {name: TypeAdapter(get_args(hint)[0] if get_origin(hint) is NotRequired else hint) for name, hint in hints}


def required(form: type) -> frozenset[str]:
    """The keys that a form cannot do without."""
    found: frozenset[str] = form.__dict__["__required_keys__"]
    return found


def read(form: type, data: Data, path: Path, source: Source) -> dict[str, Any]:
    """The valid values of a part at a path, by key; mistakes are added to the source, and their keys left out.

    *form* is a TypedDict whose entries are validated one by one, so that a mistake in one hides none in others.
    """
    if not isinstance(data, dict):
        if data is not None:
            source.report(path, f"expected a mapping of keys, got {describe(data)}")
        return {}
    known = adapters(form)
    unknown = [name for name in data if name not in known]
    for name in unknown:
        source.report_key((*path, name), f"unknown key '{name}'{did_you_mean(name, known)}")
    meant = {closest(name, known) for name in unknown}
    for name in known:
        if name in required(form) and name not in data and name not in meant:
            source.report(path, f"needs '{name}'")
    given = {name: value for name, value in data.items() if name in known and value is not None}
    found = {name: valid(known[name], value, (*path, name), source) for name, value in given.items()}
    return {name: value for name, value in found.items() if value is not None}


def valid(adapter: TypeAdapter[Any], value: Data, path: Path, source: Source) -> Any:
    """A valid value; without one what remains of a mapping, else None. Mistakes are added to the source."""
    try:
        return adapter.validate_python(value)
    except ValidationError as error:
        found = error.errors(include_url=False)
    for item in found:
        where, about_key = item["loc"], item["loc"][-1:] == ("[key]",)
        # a key without a value is reported already
        if item.get("input") is not None:
            _, what = sentence({}, where, item)
            here = (*path, *(where[:-1] if about_key else where))
            (source.report_key if about_key else source.report)(here, what)
    wrong = {item["loc"][0] for item in found if item["loc"]}
    if not isinstance(value, dict) or not wrong:
        return None
    return adapter.validate_python({name: part for name, part in value.items() if name not in wrong})


def number(quantity: Quantity, path: Path, source: Source) -> float | None:
    """The value of a quantity in SI units, None with a mistake, which is added to the source."""
    unknown = dict.fromkeys(names(quantity.expression))
    if unknown:
        listed = ", ".join(f"'{name}'" for name in unknown)
        word = "names" if len(unknown) > 1 else "name"
        source.report(
            path, f"unknown {word} {listed}: a run file has numbers, with units of measure, and no parameters"
        )
        return None
    try:
        return evaluate(quantity.expression, {})
    except ValueError as error:
        source.report(path, str(error))
        return None


def positive(values: dict[str, Any], name: str, path: Path, source: Source) -> float | None:
    """The number that a key holds, more than zero; None without the key or with a mistake, added to the source."""
    quantity = values.get(name)
    value = None if quantity is None else number(quantity, (*path, name), source)
    if value is None or value > 0.0:
        return value
    source.report((*path, name), f"is {value:g}: expected more than zero")
    return None
