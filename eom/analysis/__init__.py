"""Studies of a vehicle by itself: the kinematics of its suspension and steering."""

from eom.analysis.kinematics import KinematicSweep, kinematic_sweep
from eom.analysis.measures import Measure

__all__ = ["KinematicSweep", "Measure", "kinematic_sweep"]
