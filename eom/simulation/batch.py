"""``eom.simulate_many``: many cases of one model at once; parameters, inputs, starts and speeds differ."""

from collections.abc import Mapping, Sequence

import numpy as np

from eom.assembly.vectors import Array
from eom.errors import SimulationError
from eom.simulation.batch_results import told
from eom.simulation.batch_start import prepared
from eom.simulation.blocks import Block
from eom.simulation.case import Case, Vehicles, own_mistakes, requests
from eom.simulation.equations import Model, check_kind, every_name
from eom.simulation.fleet import Fleet
from eom.simulation.interrupted import RunInterrupted
from eom.simulation.progress import Progress
from eom.simulation.request import Request, check_size, checked
from eom.simulation.runs import Runs
from eom.simulation.sampling import begun, sample_times, updated
from eom.vehicle.validate import did_you_mean

SLICE = 0.5
"""Time [s] of the clock on the wall after which long runs let themselves be seen and interrupted."""


def simulate_many(
    model: Model,
    cases: Sequence[Case],
    duration: float,
    *,
    keep: Sequence[str] | None = None,
    blocks: Sequence[Block] = (),
    wires: Mapping[str, str] | None = None,
    sample: float = 0.01,
    method: str = "automatic",
    step: float | None = None,
    tolerance: float = 1e-6,
    threads: int | None = None,
) -> Runs:
    """Simulate many cases of one model; what a case gives depends on no other.

    With numba cases run in threads. Without it method ``rk4`` runs all of them at once in NumPy, others one by one.

    Parameters
    ----------
    model : TyreModel or LinearModel
    cases : sequence of Case
    duration, sample, method, step, tolerance
        As of `simulate`.
    keep : sequence of str, optional
        Signals to keep: outputs, inputs, ``state:NAME``; all of them if none are named.
    blocks, wires
        As of `simulate`; every block serves all cases: it gets and gives arrays (signals, cases), and its parameters
        may be arrays over the cases.
    threads : int, optional
        As many as there are cores if not given.

    Raises
    ------
    SimulationError
        For every mistake in what is asked, with the number of the case, and for a block that fails; ``partial`` is what
        was computed until then.
    RunInterrupted
        A KeyboardInterrupt; ``partial`` alike.
    EquilibriumError, SingularError
        If the parameters of a case, whose number is told, make a vehicle without straight run, or without mass.
    """
    check_kind(model)
    names = every_name(model)
    mistakes = list(own_mistakes(cases, keep, threads))
    if mistakes:
        raise SimulationError("\n".join(mistakes))
    mistakes = [
        f"keep {name}: there is no such signal{did_you_mean(name, names)}" for name in keep or () if name not in names
    ]
    vehicles: Vehicles = {}

    def request(own: Case) -> Request:
        """What is asked in a case."""
        return checked(
            model, own.inputs, duration, own.speed, own.start, blocks, wires or {}, sample, method, step, tolerance
        )

    with Progress(f"checking {len(cases)} cases"):
        asked = requests(model, cases, mistakes, request, vehicles)
    one = asked[0]
    columns = range(len(names)) if keep is None else [names.index(name) for name in keep]
    remedy = "name the signals to keep, take fewer samples, or fewer cases at a time"
    check_size(len(cases), len(one.times), len(columns) + len(one.wiring.signals), remedy)
    with Progress(f"preparing {len(cases)} cases"):
        ready = prepared(model, cases, asked, vehicles, columns, threads)
    kept = [(k, names[k]) for k in columns]
    held: list[tuple[float, Array]] = []
    try:
        go_through(ready, one, held)
    except KeyboardInterrupt:
        raise RunInterrupted(told(model, one, ready, kept, held), f"interrupted at {ready.time:.6g} s") from None
    except SimulationError as error:
        raise SimulationError(str(error), told(model, one, ready, kept, held)) from error.__cause__
    finally:
        ready.close()
    return told(model, one, ready, kept, held)


def go_through(own: Fleet, asked: Request, held: list[tuple[float, Array]]) -> None:
    """Go on with all cases to their ends; *held* gets instants with what the ports of blocks hold from then on."""
    wiring = asked.wiring
    with Progress(f"simulating {len(own.clock)} cases", asked.duration) as progress:
        if not wiring.blocks:
            reach(own, asked.duration, progress, closed=True)
            return
        ports = begun(wiring, len(own.clock))
        for time, due in sample_times(wiring):
            reach(own, min(time, asked.duration), progress, closed=time >= asked.duration)
            going = own.going(asked.duration)
            if not np.any(going):
                return
            ports = updated(wiring, due, time, own.observe(), ports, ~going)
            held.append((time, ports.acting))
            # what ended keeps the inputs with which it did
            own.work[np.ix_(going, wiring.inputs)] = ports.acting[np.ix_(wiring.sources, going)].T


def reach(own: Fleet, instant: float, progress: Progress, *, closed: bool) -> None:
    """Go on to an instant [s] with all cases, in slices that let progress be seen."""
    while np.any(own.going(instant)):
        own.go_on(instant, progress.next_stop(own.time, SLICE), closed=closed)
        progress.reached(min(own.time, instant))
