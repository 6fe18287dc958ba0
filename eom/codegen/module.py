"""The generated module: the kernel that `eom` itself runs, and the vehicle as data for it."""

import ast
import inspect
import keyword
import re
import sys
import textwrap
from importlib.metadata import version
from pathlib import Path
from types import ModuleType
from typing import cast

import jinja2

from eom.assembly import (
    algebra,
    beam,
    checks,
    cyclic,
    elastic,
    inertia,
    loads,
    massless,
    matrices,
    reduction,
    state_space,
    statics,
    structure_checks,
    tangent,
    triangle,
    vectors,
)
from eom.assembly import rows as jacobian
from eom.codegen.source import literal, make_writer, parameter_text
from eom.model.assembly import Assembly, assemble
from eom.model.linear import linearise
from eom.vehicle import elements
from eom.vehicle.expression import Expression, Number, evaluate, python_text
from eom.vehicle.expression import names as parameter_names
from eom.vehicle.load import Vehicle
from eom.vehicle.registry import Live
from eom.vehicle.values import in_order

KERNEL = (
    elements,
    vectors,
    algebra,
    jacobian,
    inertia,
    beam,
    triangle,
    elastic,
    loads,
    tangent,
    reduction,
    statics,
    matrices,
    massless,
    cyclic,
    state_space,
    structure_checks,
    checks,
)
SECTIONS = ("bodies", "constraints", "rolling", "elastic", "slip", "loads", "inputs", "outputs")
ADDITIONS = ("bushings", "beams", "triangles")


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
    taken = keyword.iskeyword(stem) or stem in sys.stdlib_module_names or stem in {"numpy", "eom"}
    return f"vehicle_{stem}" if taken or not stem.isidentifier() else stem


def module_text(vehicle: Vehicle | Assembly) -> str:
    """Source of the module of a vehicle."""
    assembly = vehicle if isinstance(vehicle, Assembly) else assemble(vehicle)
    model = linearise(assembly)
    owner = assembly.vehicle
    draft, zeros = owner.draft.system(), owner.draft.zeros
    writer, variables = make_writer(owner.draft)
    speed = cast("Expression", owner.draft.speed)
    environment = jinja2.Environment(
        loader=jinja2.PackageLoader("eom.codegen"),
        autoescape=False,  # noqa: S701  Python source; every text of the file goes through `literal` or `one_line`
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        undefined=jinja2.StrictUndefined,
    )
    live = owner.draft.registry.parameters
    given = {key: item for key, item in live.items() if isinstance(item.default, Number)}
    order, _ = in_order({key: list(parameter_names(item.default)) for key, item in live.items()})
    computed = {key: live[key] for key in order if key not in given}
    return environment.get_template("module.py.jinja").render(
        title=one_line(owner.name),
        source="\n".join(textwrap.wrap(one_line(f"Source: {owner.description.source or 'not given.'}"), 108)),
        version=version("eom-vehicle"),
        name=literal(owner.name),
        file=literal(Path(owner.file).name),
        digest=literal(owner.digest),
        given=[parameter_entry(key, item, literal(evaluate(item.default, {}))) for key, item in given.items()],
        computed=[
            parameter_entry(key, item, python_text(item.default, parameter_text)) for key, item in computed.items()
        ],
        bounds=[
            (literal(key), bound_text(item.minimum, "-math.inf"), bound_text(item.maximum, "math.inf"))
            for key, item in live.items()
            if item.minimum is not None or item.maximum is not None
        ],
        zeros=[(python_text(item, parameter_text), literal(f"{path[1]}: {what}")) for item, path, what in zeros],
        bodies=[(name, k) for k, name in enumerate(writer.bodies)],
        speed="" if isinstance(speed, Number) else python_text(speed, parameter_text),
        variables=variables,
        gravity=writer.text(draft.gravity, 8, len("gravity=,")),
        sections=[
            (key, [writer.text(item, 12, 1) for item in getattr(draft, key)])
            for key in (*SECTIONS, *(key for key in ADDITIONS if getattr(draft, key)))
        ],
        signals=[
            (kind, [(literal(a), literal(b)) for a, b in zip(signals, units, strict=True)])
            for kind, signals, units in (
                ("STATES", model.states, model.state_units),
                ("INPUTS", model.inputs, model.input_units),
                ("OUTPUTS", model.outputs, model.output_units),
            )
        ],
        pivots=writer.text(assembly.pivots, 0, len("PIVOTS = ")),
        kernel=[kernel_section(module) for module in KERNEL],
    )


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


def kernel_section(module: ModuleType) -> tuple[str, str]:
    """First line of a kernel module's docstring, and its source without docstring and imports."""
    text = inspect.getsource(module)
    skipped = (ast.Import, ast.ImportFrom)
    body = ast.parse(text).body[1:]
    first = next(node for node in body if not isinstance(node, skipped))
    start = min([first.lineno, *(node.lineno for node in getattr(first, "decorator_list", []))])
    return (module.__doc__ or "").splitlines()[0], "\n".join(text.splitlines()[start - 1 :]).strip()
