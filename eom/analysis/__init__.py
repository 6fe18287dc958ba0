"""Studies of a vehicle: its linear model, alone and over parameters; loads of the trim; kinematics of suspensions."""

from eom.analysis.critical import CriticalValue, critical_values
from eom.analysis.frequency import FrequencyResponse, Peak, frequency_response
from eom.analysis.gains import SteadyGains, steady_gains
from eom.analysis.hankel import HankelValues, hankel_values
from eom.analysis.kinematics import KinematicSweep, kinematic_sweep
from eom.analysis.loads import TrimLoads, joint_loads, trim_loads
from eom.analysis.locus import RootLocus, root_locus
from eom.analysis.maps import Axis, StabilityMap, stability_map
from eom.analysis.measures import Measure
from eom.analysis.reach import ModalReach, modal_reach
from eom.analysis.ride import RoadResponse, road_response
from eom.analysis.road import displacement_psd, track_coherence
from eom.analysis.time_response import TimeResponse
from eom.analysis.transient import forced_response, impulse_response, sine_response, step_response
from eom.analysis.zeros import Zeros, transmission_zeros

__all__ = [
    "Axis",
    "CriticalValue",
    "FrequencyResponse",
    "HankelValues",
    "KinematicSweep",
    "Measure",
    "ModalReach",
    "Peak",
    "RoadResponse",
    "RootLocus",
    "StabilityMap",
    "SteadyGains",
    "TimeResponse",
    "TrimLoads",
    "Zeros",
    "critical_values",
    "displacement_psd",
    "forced_response",
    "frequency_response",
    "hankel_values",
    "impulse_response",
    "joint_loads",
    "kinematic_sweep",
    "modal_reach",
    "road_response",
    "root_locus",
    "sine_response",
    "stability_map",
    "steady_gains",
    "step_response",
    "track_coherence",
    "transmission_zeros",
    "trim_loads",
]
