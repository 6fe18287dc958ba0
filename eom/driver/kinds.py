"""The types of blocks that a run file may name."""

from collections.abc import Mapping
from typing import NotRequired, TypedDict

from eom.driver.speed_keeping import SpeedKeeping
from eom.simulation.run_form import SENSOR, Kind, SignalName
from eom.vehicle.quantity import Force, Impulse, Moment, Speed, Time


class SpeedKeepingForm(TypedDict):
    """A driver that keeps a speed."""

    speed: Speed
    kp: Impulse
    ki: Force
    lowest: NotRequired[Moment]
    highest: NotRequired[Moment]
    start: NotRequired[Moment]
    signal: NotRequired[SignalName]
    period: NotRequired[Time]


KINDS: Mapping[str, Kind] = {"sensor": SENSOR, "speed_keeping": Kind(SpeedKeepingForm, SpeedKeeping, {})}
