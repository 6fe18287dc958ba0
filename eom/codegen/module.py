"""The generated module: the kernel that `eom` itself runs, and the vehicle as data for it."""

import keyword
import re
import sys
import textwrap
from collections.abc import Sequence
from importlib.metadata import version
from pathlib import Path
from typing import Any, cast

import jinja2

from eom.codegen.carried import carried
from eom.codegen.source import Writer, literal, make_writer, parameter_text
from eom.codegen.tyres import named_files, tyre_fields
from eom.model.assembly import Assembly, assemble
from eom.model.linear import LinearModel, linearise
from eom.model.tyre import TyreModel, build_tyre_model
from eom.vehicle.elements import System
from eom.vehicle.expression import Expression, Number, evaluate, python_text
from eom.vehicle.expression import names as parameter_names
from eom.vehicle.load import Vehicle
from eom.vehicle.registry import Live
from eom.vehicle.values import in_order

LINEAR_FILES = tuple(
    f"eom.{name}"
    for name in (
        "vehicle.elements",
        "assembly.checks",
        "assembly.matrices",
        "assembly.massless",
        "assembly.reduction",
        "assembly.state_space",
        "assembly.statics",
    )
)
TYRE_FILES = tuple(
    f"eom.{name}"
    for name in (
        "vehicle.elements",
        "assembly.checks",
        "assembly.reduction",
        "assembly.vectors",
        "splice.closure",
        "splice.kinds",
        "splice.limits",
        "splice.linear_outputs",
        "splice.outputs",
        "splice.prepare",
        "splice.rates",
        "splice.signals",
        "splice.steady",
        "splice.trim",
        "tyre.interface",
        "tyre.mf.coefficients",
    )
)
SECTIONS = ("bodies", "constraints", "rolling", "elastic", "slip", "loads", "inputs", "outputs")
ADDITIONS = ("bushings", "beams", "triangles")
WHEELS = ("wheels", "tyres", "drags", "units")


def write_module(vehicle: Vehicle | Assembly, folder: str | Path) -> Path:
    """Write a vehicle's module into a folder, which is made if missing; return the file's path.

    Its name is that of the vehicle file. Errors as `eom.linearise`.
    """
    target = Path(folder)
    target.mkdir(parents=True, exist_ok=True)
    owner = vehicle.vehicle if isinstance(vehicle, Assembly) else vehicle
    path = target / f"{module_name(owner)}.py"
    path.write_text(module_text(vehicle), encoding="utf-8")
    return path


def module_name(vehicle: Vehicle) -> str:
    """A Python identifier from the vehicle file's name."""
    stem = re.sub(r"\W", "_", Path(vehicle.file).stem) or "vehicle"
    # a module called numpy or class could not be imported, or would hide what it needs
    taken = keyword.iskeyword(stem) or stem in sys.stdlib_module_names or stem in {"numpy", "numba", "eom"}
    return f"vehicle_{stem}" if taken or not stem.isidentifier() else stem


def module_text(vehicle: Vehicle | Assembly) -> str:
    """Source of the module of a vehicle: nonlinear where its axles' tyres are wheels alone, else linear."""
    assembly = vehicle if isinstance(vehicle, Assembly) else assemble(vehicle)
    owner = assembly.vehicle
    writer, variables = make_writer(owner.draft)
    model: LinearModel | TyreModel
    if assembly.prepared is None:
        model, pivots = linearise(assembly), assembly.pivots
        name, modules, own = "linear.py.jinja", LINEAR_FILES, system_fields(owner.draft.system(), writer)
    else:
        model, pivots = build_tyre_model(owner), assembly.prepared.pivots
        system, files = named_files(owner.draft.system())
        name, modules = "tyre.py.jinja", TYRE_FILES
        own = {**system_fields(system, writer, WHEELS), **tyre_fields(model, files)}
    environment = jinja2.Environment(
        loader=jinja2.PackageLoader("eom.codegen"),
        autoescape=False,  # noqa: S701  Python source; every text of the file goes through `literal` or `one_line`
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        undefined=jinja2.StrictUndefined,
    )
    template = environment.get_template(name)
    fields = {
        **vehicle_fields(owner),
        **own,
        "variables": variables,
        "pivots": writer.text(pivots, 0, len("PIVOTS = ")),
        "signals": [
            (kind, [(literal(a), literal(b)) for a, b in zip(names, units, strict=True)])
            for kind, names, units in (
                ("STATES", model.states, model.state_units),
                ("INPUTS", model.inputs, model.input_units),
                ("OUTPUTS", model.outputs, model.output_units),
            )
        ],
    }
    sections, imports = carried(template.render(**fields, kernel=[], imports=""), modules)
    return template.render(**fields, kernel=sections, imports=imports)


def vehicle_fields(owner: Vehicle) -> dict[str, Any]:
    """What the module says of the vehicle and its parameters."""
    draft = owner.draft
    speed = cast("Expression", draft.speed)
    live = draft.registry.parameters
    given = {key: item for key, item in live.items() if isinstance(item.default, Number)}
    order, _ = in_order({key: list(parameter_names(item.default)) for key, item in live.items()})
    computed = {key: live[key] for key in order if key not in given}
    return {
        "title": one_line(owner.name),
        "source": "\n".join(textwrap.wrap(one_line(f"Source: {owner.description.source or 'not given.'}"), 108)),
        "version": version("eom-vehicle"),
        "name": literal(owner.name),
        "file": literal(Path(owner.file).name),
        "digest": literal(owner.digest),
        "given": [parameter_entry(key, item, literal(evaluate(item.default, {}))) for key, item in given.items()],
        "computed": [
            parameter_entry(key, item, python_text(item.default, parameter_text)) for key, item in computed.items()
        ],
        "bounds": [
            (literal(key), bound_text(item.minimum, "-math.inf"), bound_text(item.maximum, "math.inf"))
            for key, item in live.items()
            if item.minimum is not None or item.maximum is not None
        ],
        "zeros": [
            (python_text(item, parameter_text), literal(f"{path[1]}: {what}")) for item, path, what in draft.zeros
        ],
        "floors": list(
            dict.fromkeys(
                (python_text(item, parameter_text), zero, literal(".".join(map(str, path))))
                for item, path, zero in draft.registry.floors
                if not isinstance(item, Number)
            )
        ),
        "speed": "" if isinstance(speed, Number) else python_text(speed, parameter_text),
        "fixed_speed": literal(owner.speed),
    }


def system_fields(draft: System, writer: Writer, further: Sequence[str] = ()) -> dict[str, Any]:
    """The elements as source; *further* names those that vehicles with wheels have."""
    added = [key for key in (*ADDITIONS, *further) if getattr(draft, key)]
    return {
        "bodies": [(name, k) for k, name in enumerate(writer.bodies)],
        "gravity": writer.text(draft.gravity, 8, len("gravity=,")),
        "sections": [(key, [writer.text(item, 12, 1) for item in getattr(draft, key)]) for key in (*SECTIONS, *added)],
        "drive": writer.text(draft.drive, 8, len("drive=,")) if further else "",
    }


def one_line(text: str) -> str:
    """Text of the file as it may stand in a docstring: one line, nothing that could end it."""
    return " ".join(text.split()).replace("\\", "/").replace('"""', "''").rstrip('"')


def parameter_entry(name: str, item: Live, value: str) -> tuple[str, str, str, str]:
    """Name, value, SI unit and description of a parameter, as source."""
    return (
        literal(name),
        value,
        literal(item.si_unit),
        literal(one_line(item.description) if item.path[0] == "parameters" else ""),
    )


def bound_text(bound: Expression | None, default: str) -> str:
    """A bound as source."""
    return default if bound is None else python_text(bound, parameter_text)
