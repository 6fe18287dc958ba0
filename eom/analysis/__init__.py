"""Studies of a vehicle: kinematics of suspension and steering, responses and measures of the linear model, loads."""

from eom.analysis.frequency import FrequencyResponse, Peak, frequency_response
from eom.analysis.gains import SteadyGains, steady_gains
from eom.analysis.hankel import HankelValues, hankel_values
from eom.analysis.kinematics import KinematicSweep, kinematic_sweep
from eom.analysis.loads import TrimLoads, joint_loads, trim_loads
from eom.analysis.measures import Measure
from eom.analysis.reach import ModalReach, modal_reach
from eom.analysis.ride import RoadResponse, road_response
from eom.analysis.road import displacement_psd, track_coherence
from eom.analysis.transient import TimeResponse, forced_response, impulse_response, sine_response, step_response
from eom.analysis.zeros import Zeros, transmission_zeros

__all__ = [
    "FrequencyResponse",
    "HankelValues",
    "KinematicSweep",
    "Measure",
    "ModalReach",
    "Peak",
    "RoadResponse",
    "SteadyGains",
    "TimeResponse",
    "TrimLoads",
    "Zeros",
    "displacement_psd",
    "forced_response",
    "frequency_response",
    "hankel_values",
    "impulse_response",
    "joint_loads",
    "kinematic_sweep",
    "modal_reach",
    "road_response",
    "sine_response",
    "steady_gains",
    "step_response",
    "track_coherence",
    "transmission_zeros",
    "trim_loads",
]
