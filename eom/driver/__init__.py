"""Drivers: what steers and keeps speed, as blocks of a simulation."""

from eom.driver.kinds import KINDS
from eom.driver.speed_keeping import SpeedKeeping

__all__ = ["KINDS", "SpeedKeeping"]
