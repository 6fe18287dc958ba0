"""Equations of motion of road vehicles with trailers, from one YAML file.

The public names are loaded on first use, so that importing the package costs nothing.
"""

from typing import TYPE_CHECKING, Any

from eom.errors import (
    AnalysisError as AnalysisError,
)
from eom.errors import (
    DescriptionError as DescriptionError,
)
from eom.errors import (
    EomError as EomError,
)
from eom.errors import (
    EquilibriumError as EquilibriumError,
)
from eom.errors import (
    MechanismError as MechanismError,
)
from eom.errors import (
    OutputError as OutputError,
)
from eom.errors import (
    SimulationError as SimulationError,
)
from eom.errors import (
    SingularError as SingularError,
)
from eom.errors import (
    TyreError as TyreError,
)

if TYPE_CHECKING:
    from eom.analysis import KinematicSweep as KinematicSweep
    from eom.analysis import critical_values as critical_values
    from eom.analysis import kinematic_sweep as kinematic_sweep
    from eom.analysis import root_locus as root_locus
    from eom.analysis import stability_map as stability_map
    from eom.codegen import write_module as write_module
    from eom.model import LinearModel as LinearModel
    from eom.model import assemble as assemble
    from eom.model import linearise as linearise
    from eom.model.reformulation import Reformulation as Reformulation
    from eom.model.reformulation import reformulate as reformulate
    from eom.model.tyre import TyreModel as TyreModel
    from eom.model.tyre import build as build
    from eom.simulation import Run as Run
    from eom.simulation import simulate as simulate
    from eom.simulation import simulate_many as simulate_many
    from eom.vehicle.load import Vehicle as Vehicle
    from eom.vehicle.load import load as load
    from eom.vehicle.load import loads as loads

PUBLIC = {
    "load": "eom.vehicle.load",
    "loads": "eom.vehicle.load",
    "Vehicle": "eom.vehicle.load",
    "assemble": "eom.model",
    "linearise": "eom.model",
    "build": "eom.model.tyre",
    "TyreModel": "eom.model.tyre",
    "reformulate": "eom.model.reformulation",
    "Reformulation": "eom.model.reformulation",
    "LinearModel": "eom.model",
    "simulate": "eom.simulation",
    "simulate_many": "eom.simulation",
    "Run": "eom.simulation",
    "write_module": "eom.codegen",
    "kinematic_sweep": "eom.analysis",
    "KinematicSweep": "eom.analysis",
    "root_locus": "eom.analysis",
    "critical_values": "eom.analysis",
    "stability_map": "eom.analysis",
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
    errors = (name for name in globals() if name.endswith("Error"))
    return sorted([*PUBLIC, *errors])
