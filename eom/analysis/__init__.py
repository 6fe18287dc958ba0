"""Studies of a vehicle by itself: the kinematics of its suspension and steering."""

from eom.analysis.kinematics import KinematicSweep, Measure, kinematic_sweep

__all__ = ["KinematicSweep", "Measure", "kinematic_sweep"]
