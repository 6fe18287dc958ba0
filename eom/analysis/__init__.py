"""Studies of a vehicle: kinematics of its suspension and steering, and how its modes change with parameters."""

from eom.analysis.critical import CriticalValue, critical_values
from eom.analysis.kinematics import KinematicSweep, kinematic_sweep
from eom.analysis.locus import RootLocus, root_locus
from eom.analysis.maps import Axis, StabilityMap, stability_map
from eom.analysis.measures import Measure

__all__ = [
    "Axis",
    "CriticalValue",
    "KinematicSweep",
    "Measure",
    "RootLocus",
    "StabilityMap",
    "critical_values",
    "kinematic_sweep",
    "root_locus",
    "stability_map",
]
