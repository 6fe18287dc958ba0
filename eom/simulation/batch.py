"""``eom.simulate_many``: many cases of one model at once; parameters, inputs, starts and speeds differ."""

from collections.abc import Mapping, Sequence

import numpy as np

from eom.assembly.vectors import Array
from eom.errors import SimulationError
from eom.simulation.batch_results import told
from eom.simulation.batch_start import prepared
from eom.simulation.blocks import Block
from eom.simulation.case import Case, requests
from eom.simulation.channels import STATE
from eom.simulation.equations import Model, check_kind
from eom.simulation.fleet import Fleet
from eom.simulation.interrupted import RunInterrupted
from eom.simulation.progress import Progress
from eom.simulation.request import Request, checked
from eom.simulation.runs import Runs
from eom.simulation.sampling import begun, sample_times, updated
from eom.vehicle.validate import did_you_mean

SLICE = 0.5
"""Time [s] of the clock on the wall after which long runs let themselves be seen and interrupted."""
LARGEST = 4e9
"""Bytes that results of a batch may take."""


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
    DescriptionError, EquilibriumError
        If the parameters of a case make no vehicle, or one without straight run.
    """
    check_kind(model)
    names = every_name(model)
    mistakes = [
        f"keep {name}: there is no such signal{did_you_mean(name, names)}" for name in keep or () if name not in names
    ]
    if threads is not None and threads < 1:
        mistakes.append(f"threads = {threads}: expected one or more")
    asked = requests(
        model,
        cases,
        mistakes,
        lambda own: checked(
            model, own.inputs, duration, own.start, blocks, wires or {}, sample, method, step, tolerance
        ),
    )
    one = asked[0]
    columns = range(len(names)) if keep is None else [names.index(name) for name in keep]
    size = 8.0 * len(cases) * len(one.times) * len(columns)
    if size > LARGEST:
        raise SimulationError(
            f"results of {size / 1e9:.3g} GB, expected at most {LARGEST / 1e9:g}: name the signals to keep, take fewer "
            "samples, or fewer cases at a time"
        )
    with Progress(f"preparing {len(cases)} cases"):
        ready = prepared(model, cases, asked, columns, threads)
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


def every_name(model: Model) -> list[str]:
    """What can be kept, in the order of the columns: states, inputs, outputs."""
    return [*(STATE + name for name in model.states), *model.inputs, *model.outputs]


def go_through(own: Fleet, asked: Request, held: list[tuple[float, Array]]) -> None:
    """Go on with all cases to their ends; *held* gets instants with what the ports of blocks hold from then on."""
    wiring = asked.wiring
    with Progress(f"simulating {len(own.clock)} cases", asked.duration) as progress:
        if not wiring.blocks:
            while own.going(asked.duration):
                own.go_on(asked.duration, progress.next_stop(own.time, SLICE), closed=True)
                progress.reached(own.time)
            return
        ports = begun(wiring, len(own.clock))
        for time, due in sample_times(wiring):
            own.go_on(min(time, asked.duration), np.inf, closed=time >= asked.duration)
            progress.reached(min(time, asked.duration))
            if time >= asked.duration:
                break
            ports = updated(wiring, due, time, own.observe(), ports)
            held.append((time, ports.acting))
            own.work[:, wiring.inputs] = ports.acting[wiring.sources].T
