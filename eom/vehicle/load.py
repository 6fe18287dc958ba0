"""From a file to a vehicle: read, validate, draft, set parameters; every mistake at once."""

import hashlib
from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path as FilePath
from typing import cast

from eom.errors import DescriptionError, Mistake
from eom.vehicle.description import Description
from eom.vehicle.draft import Draft
from eom.vehicle.draft_description import make_draft
from eom.vehicle.elements import System
from eom.vehicle.expression import Expression, evaluate
from eom.vehicle.source import MAX_BYTES, Source, read_source
from eom.vehicle.validate import COLLECTIONS, validate
from eom.vehicle.values import check_expressions, check_floors, numbers, override, parameter_values


@dataclass(frozen=True)
class Vehicle:
    """A described system with values for all its parameters; nothing in it changes.

    Attributes
    ----------
    name : str
        As the file says.
    file : str
        The file's name as given.
    digest : str
        SHA-256 of the file's text.
    description : Description
        The validated file.
    draft : Draft
        The system with expressions for numbers, and what is known by role.
    system : System
        The system with numbers, SI units.
    values : Mapping
        Value of every parameter, SI units: declared ones by name, literals as ``object.quantity``.
    """

    name: str
    file: str
    digest: str
    description: Description
    draft: Draft
    system: System
    values: Mapping[str, float]
    source: Source

    def mistake(self, obj: str, what: str) -> Mistake:
        """A mistake that points at a named object of the file, or at what it belongs to (``joint.row``)."""
        own = obj.split(".", maxsplit=1)[0]
        path = self.draft.names.get(obj) or self.draft.names.get(own, ("trim",) if own == "trim" else ())
        return self.source.mistake(path, what)

    @property
    def speed(self) -> float:
        """Speed of the trim [m/s], zero without one."""
        return evaluate(cast("Expression", self.draft.speed), self.values)

    def with_values(self, **overrides: str | float) -> "Vehicle":
        """The same vehicle with other values of parameters, as `load` takes them; the file is not read again.

        Raises `DescriptionError` as `load`.
        """
        registry = replace(self.draft.registry, parameters=dict(self.draft.registry.parameters))
        draft, source = replace(self.draft, registry=registry), replace(self.source, mistakes=[])
        return with_numbers(self.description, draft, source, self.digest, overrides)


def load(path: str | FilePath, /, **overrides: str | float) -> Vehicle:
    """Read a vehicle file; any parameter can be overridden by keyword.

    Parameters
    ----------
    path : str or Path
        The YAML file.
    **overrides : str or float
        Values by parameter name, as numbers in SI units or texts such as ``"110 km/h"``. A literal of the file is
        a parameter too, named after its object: ``**{"tractor_frame.mass": "6.5 t"}``.

    Raises
    ------
    DescriptionError
        With every mistake of the file and the overrides.
    """
    try:
        with FilePath(path).open("rb") as file:
            raw = file.read(4 * MAX_BYTES + 1)
    except (OSError, ValueError) as error:
        what = f"cannot be read: {getattr(error, 'strerror', None) or error}"
        raise DescriptionError([Mistake(str(path), 0, 0, "", what)]) from None
    return loads(raw, str(path), **overrides)


def loads(text: str | bytes, file: str = "<text>", /, **overrides: str | float) -> Vehicle:
    """The vehicle that a text describes; see `load`. Names of files in it start from the folder of *file*."""
    try:
        raw = text.encode() if isinstance(text, str) else text
        source = read_source(raw.decode(), file)
    except (UnicodeDecodeError, UnicodeEncodeError) as error:
        what = f"not readable as UTF-8 text: {error.reason} at {error.start}"
        raise DescriptionError([Mistake(file, 0, 0, "", what)]) from None
    description, broken = validate(source)
    # without a whole section every reference into it would be one more mistake
    if description is None or broken & {"parameters", *COLLECTIONS}:
        raise DescriptionError(source.mistakes)
    draft = make_draft(description, broken, FilePath(file).parent)
    for where, what in draft.registry.mistakes:
        source.report(where, what)
    if not (draft.bodies or source.mistakes):
        source.report((), "describes no body: give 'bodies' or 'units'")
    return with_numbers(description, draft, source, hashlib.sha256(raw).hexdigest(), overrides)


def with_numbers(
    description: Description, draft: Draft, source: Source, digest: str, overrides: Mapping[str, str | float]
) -> Vehicle:
    """The vehicle of a draft, its parameters overridden; mistakes join those that the source already has."""
    source.mistakes += [Mistake(source.file, 0, 0, "", what) for what in override(draft.registry, overrides)]
    values = parameter_values(draft.registry, source)
    check_expressions(draft.registry, values, source)
    check_floors(draft.registry, values, source)
    if source.mistakes:
        raise DescriptionError(source.mistakes)
    system = numbers(draft.system(), values, draft, source)
    if (speed := evaluate(cast("Expression", draft.speed), values)) < 0.0:
        source.report(("trim", "speed"), f"is {speed:g} m/s: the trim runs forward, along +x")
    for expression, where, what in draft.zeros:
        if abs(evaluate(expression, values)) > 1e-9:
            source.report(where, what)
    if source.mistakes:
        raise DescriptionError(source.mistakes)
    return Vehicle(description.name, source.file, digest, description, draft, system, values, source)
