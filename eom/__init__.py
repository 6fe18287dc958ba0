"""Equations of motion of road vehicles with trailers, from one YAML file.

The public names are loaded on first use, so that importing the package costs nothing.
"""

from typing import TYPE_CHECKING, Any

from eom.errors import (
    DescriptionError as DescriptionError,
    EomError as EomError,
    EquilibriumError as EquilibriumError,
    OutputError as OutputError,
    SingularError as SingularError,
)

if TYPE_CHECKING:
    from eom.codegen import write_module as write_module
    from eom.model import LinearModel as LinearModel, assemble as assemble, linearise as linearise
    from eom.vehicle.load import Vehicle as Vehicle, load as load, loads as loads

PUBLIC = {
    "load": "eom.vehicle.load",
    "loads": "eom.vehicle.load",
    "Vehicle": "eom.vehicle.load",
    "assemble": "eom.model",
    "linearise": "eom.model",
    "LinearModel": "eom.model",
    "write_module": "eom.codegen",
}


def __getattr__(name: str) -> Any:
    """Import the module of a public name when it is first asked for."""
    import importlib  # noqa: PLC0415

    if name not in PUBLIC:
        message = f"module 'eom' has no attribute '{name}'"
        raise AttributeError(message)
    return getattr(importlib.import_module(PUBLIC[name]), name)


def __dir__() -> list[str]:
    """The public names."""
    return sorted([*PUBLIC, "EomError", "DescriptionError", "EquilibriumError", "OutputError", "SingularError"])
