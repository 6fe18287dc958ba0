"""What a run in numbers is made of: settings, what it carries along, what it leaves behind."""

from typing import Any, NamedTuple

AUTOMATIC, RUNGE_KUTTA, DORMAND_PRINCE, ROSENBROCK = range(4)
DONE, TERMINAL, UNSTABLE, INACCURATE, COLLAPSED, DIVERGED, FULL = range(7)
"""How `eom.simulate.advance.advance` ends: at the instant asked for; at a limit that ends the run; with a fixed step
beyond stability; with one whose error is too large; with a step too small to go on; with numbers that are none; with
no room for more events."""
STEPS_REJECTED, SAMPLES, EVENTS = 4, 5, 6
"""Places in ``Clock.counts`` after those of steps taken by each method."""


class Settings(NamedTuple):
    """How to step.

    Attributes
    ----------
    method : int
    step : float
        Fixed step of the classical method, largest one of the others [s].
    tolerance : float
        Error of a step over the size of the states.
    size, growing : Array
        Size of each state that counts as one, and 1 where its own value adds to it, (n,).
    """

    method: int
    step: float
    tolerance: float
    size: Any
    growing: Any


class Clock(NamedTuple):
    """What a run carries along, in arrays that loops change.

    Attributes
    ----------
    time : Array
        Instant [s], step that comes next [s], fastest root [1/s], instant when it was looked for [s].
    x : Array
        The state, (n,).
    k : Array
        Rates, (stages, n); the first row belongs to x.
    direction : Array
        Along which the rates change fastest, (n,).
    margins : Array
        Of the limits at x.
    counts : NDArray
        Steps by each method, steps rejected, samples taken, events found.
    """

    time: Any
    x: Any
    k: Any
    direction: Any
    margins: Any
    counts: Any


class Record(NamedTuple):
    """What a run leaves behind.

    Attributes
    ----------
    times : Array
        Instants of the samples [s], (samples,).
    states, inputs, outputs : Array
        (samples, n), (samples, inputs), (samples, outputs).
    event_times, event_states : Array
        (events,), (events, n).
    events : NDArray
        Number of the limit, and 1 if it was reached or 0 if it was left, (events, 2).
    terminal : NDArray
        Whether reaching a limit ends the run, (limits,).
    """

    times: Any
    states: Any
    inputs: Any
    outputs: Any
    event_times: Any
    event_states: Any
    events: Any
    terminal: Any


class Implicit(NamedTuple):
    """What implicit steps need: Jacobian, its factors with the step, df/dt, memory; ``age`` holds the factors' step,
    the Jacobian's age in steps, and whether there is one."""

    jacobian: Any
    factors: Any
    pivots: Any
    drift: Any
    v: Any
    right: Any
    age: Any


def size_of(change: Any, x: Any, settings: Settings) -> float:
    """Root mean square of a change of state over the size of the states."""
    total = 0.0
    for k in range(len(x)):
        ratio = change[k] / (settings.size[k] + settings.growing[k] * abs(x[k]))
        total += ratio * ratio
    return float((total / len(x)) ** 0.5)
