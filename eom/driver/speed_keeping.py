"""Speed keeping: a sampled PI controller of the drive torque.

Zhu's thesis leaves the speed to "a longitudinal driver model" (sections 3.3.1.3 and 6.1) and shows the torque that
one gives (figures 3.16 and 3.17), but neither its law nor its gains. This is the textbook's controller (Åström and
Hägglund, PID Controllers, 1995, chapter 3): proportional to the error of the speed and to its integral, which stands
still while the torque is at a limit and the error pushes on (conditional integration).
"""

from dataclasses import dataclass, field

import numpy as np

from eom.assembly.vectors import Array
from eom.simulation.blocks import BlockError
from eom.simulation.sampling_times import SMALLEST
from eom.vehicle.draft_drive import TORQUE

UNLIMITED = float("inf")


@dataclass
class SpeedKeeping:
    """Drive torque that keeps a speed; port ``torque`` [N*m], positive forwards.

    At a sample with the error e = speed - signal the torque is I + kp e within its limits. Then I grows by
    ki period e, unless the torque is at a limit and e pushes it further, and stays within the limits itself. So the
    torque leaves a limit at the first sample at which e has changed its sign, however long it was there.

    With a vehicle of mass m, a wheel radius r and a drag that grows by c [N*s/m] the poles of the closed loop are, for
    short periods, the roots of s^2 + (kp / r + c) / m s + ki / (r m): kp = 2 d w r m - c r and ki = w^2 r m give the
    frequency w [rad/s] and the damping ratio d.

    Numbers may be arrays, (cases,), in a batch.

    Attributes
    ----------
    speed : float or Array
        To be kept [m/s].
    kp : float or Array
        Torque per error of the speed [N*s], positive.
    ki : float or Array
        Torque per time integral of the error [N], not negative.
    lowest, highest : float or Array
        Limits of the torque [N*m]; without them there are none.
    start : float, Array or None
        Torque at no error and no integral [N*m]; None: that of the trim, read from the model's input
        ``drive_torque`` at the first sample.
    signal : str
        The speed that is kept [m/s].
    period : float
        Time between samples [s].
    name : str

    Raises
    ------
    BlockError
        With a sentence for every value that cannot be.
    """

    speed: float | Array
    kp: float | Array
    ki: float | Array
    lowest: float | Array = -UNLIMITED
    highest: float | Array = UNLIMITED
    start: float | Array | None = None
    signal: str = "tractor.speed"
    period: float = 0.01
    name: str = "speed_keeping"
    outputs: tuple[str, ...] = field(default=("torque",), init=False)
    units: tuple[str, ...] = field(default=("N*m",), init=False)

    def __post_init__(self) -> None:
        wrong = {}
        if not np.all(np.isfinite(self.speed)):
            wrong["speed"] = f"is {self.speed}: expected a finite speed in m/s"
        if not (np.all(np.isfinite(self.kp)) and np.all(np.asarray(self.kp) > 0.0)):
            wrong["kp"] = f"is {self.kp}: expected more than zero"
        if not (np.all(np.isfinite(self.ki)) and np.all(np.asarray(self.ki) >= 0.0)):
            wrong["ki"] = f"is {self.ki}: expected no less than zero"
        if not np.all(np.asarray(self.lowest) < np.asarray(self.highest)):
            wrong["lowest"] = f"is {self.lowest}: expected less than 'highest', which is {self.highest}"
        if self.start is not None and not np.all(np.isfinite(self.start)):
            wrong["start"] = f"is {self.start}: expected a finite torque in N*m"
        if not (np.isfinite(self.period) and self.period >= SMALLEST):
            wrong["period"] = f"is {self.period:g} s: expected a time of at least {SMALLEST:g} s"
        if wrong:
            raise BlockError(self.name, wrong)
        self.reset()

    @property
    def inputs(self) -> tuple[str, ...]:
        """The speed, and the torque of the trim if it is to be read."""
        return (self.signal,) if self.start is not None else (self.signal, TORQUE)

    @property
    def input_units(self) -> tuple[str, ...]:
        """Units in which the inputs are taken."""
        return ("m/s", "N*m")[: len(self.inputs)]

    def reset(self) -> None:
        """Forget the integral."""
        self._integral: Array | None = None

    def update(self, t: float, y: Array) -> Array:
        """The torque [N*m], (1,), or in a batch (1, cases)."""
        del t
        integral = self._integral
        if integral is None:
            integral = np.clip(y[1] if self.start is None else self.start, self.lowest, self.highest)
        error = self.speed - y[0]
        wanted = integral + self.kp * error
        torque = np.clip(wanted, self.lowest, self.highest)
        pushing = ((wanted >= self.highest) & (error > 0.0)) | ((wanted <= self.lowest) & (error < 0.0))
        grown = integral + np.where(pushing, 0.0, self.ki * self.period * error)
        self._integral = np.clip(grown, self.lowest, self.highest)
        return np.asarray(torque)[np.newaxis]
