"""Cases that end: their blocks, the others, what is told of them."""

import contextlib
from typing import Any

import numpy as np
import pytest

from eom.assembly.vectors import Array
from eom.program.compiled import without_compiler
from eom.program.make import ready
from eom.simulation import Case, RunInterrupted, Sine, Table, simulate, simulate_many
from eom.simulation import batch as batches
from eom.simulation import memory as of
from eom.simulation.equations import Equations
from eom.simulation.fleet_start import fleet
from eom.simulation.signal_pieces import driven, told
from eom.splice.limits import Limit
from tests.simulation.block_samples import Function
from tests.simulation.small import named_for_its_text
from tests.splice.shared import model

TRAIN, STEER = "tractor_semitrailer_nonlinear", "axle_1.steer"
ANGLE = "semitrailer_frame.yaw_from_tractor_frame"
JACKKNIFED = Case(start={ANGLE: 1.1})


class Growing:
    """A block whose memory doubles every sample, and grows with what it reads."""

    name, period = "grows", 0.01
    inputs, outputs, units = (f"state:{ANGLE}",), ("out",), (None,)

    def reset(self) -> None:
        """Nothing yet."""
        self.sum: Any = 0.0

    def update(self, t: float, y: Array) -> Array:
        """Finite only where nothing is read, from 10.23 s on."""
        del t
        self.sum = 2.0 * self.sum + y
        return np.asarray(self.sum)


def test_what_blocks_make_of_a_case_that_has_ended_ends_no_other() -> None:
    found = model(TRAIN)
    with np.errstate(over="ignore"):
        runs = simulate_many(found, [Case(), JACKKNIFED], 10.5, blocks=[Growing()], keep=(STEER,), sample=0.1)
    assert runs.ended[0] == ""
    assert runs.ended[1] == simulate(found, {}, 10.5, start=JACKKNIFED.start, blocks=[Growing()]).ended
    assert np.all(np.isfinite(runs.values[0]))


def test_what_blocks_read_of_a_case_that_has_ended_is_finite_whatever_they_gave_it() -> None:
    """Its inputs are those with which it ended."""
    read: list[Array] = []

    def steer(t: float, y: Array) -> Array:
        read.append(y.copy())
        return np.where((np.arange(y.shape[-1]) == 1) & (t > 0.2), np.inf, 0.0 * y)

    block, wires = Function("late", ("tractor.ay",), steer, units=("rad",)), {STEER: "late.out"}
    runs = simulate_many(model(TRAIN), [Case(), JACKKNIFED], 1.0, blocks=[block], wires=wires, keep=(STEER,))
    assert runs.ended[0] == ""
    assert np.all(runs.of(STEER)[0] == 0.0)
    assert len(read) == 10
    assert np.all(np.isfinite(read))


@pytest.mark.parametrize("compiled", [True, False])
def test_an_input_that_ends_with_the_run_does_not_end_it(compiled: bool) -> None:
    case = Case({STEER: Table(np.array([0.0, 0.3]), np.array([0.0, 0.01]))})

    def ends(duration: float) -> tuple[str, ...]:
        return simulate_many(model(TRAIN), [case, Case()], duration, method="rk4", step=0.01, keep=(STEER,)).ended

    if compiled:
        assert ends(0.3) == ("", "")
        assert ends(0.4) == ("input axle_1.steer ends at 0.3 s", "")
        return
    with without_compiler():
        assert ends(0.3) == ("", "")


def test_a_batch_whose_cases_have_all_ended_asks_no_block_again() -> None:
    block = Function("counts", ("tractor.ay",), lambda _, y: y, period=0.01, units=("m/s^2",))
    runs = simulate_many(model(TRAIN), [JACKKNIFED] * 2, 100.0, blocks=[block], keep=(STEER,), sample=1.0)
    assert all("jackknife" in ended or "articulation" in ended for ended in runs.ended)
    assert len(block.times) <= 2


@pytest.mark.parametrize("period", [None, 50.0])
def test_cases_of_a_batch_go_on_side_by_side_also_between_samples_of_slow_blocks(
    period: float | None, monkeypatch: pytest.MonkeyPatch
) -> None:
    """An interrupt after some slices finds all of them under way, and says how far the slowest has come."""
    monkeypatch.setattr(batches, "SLICE", 0.02)
    blocks = [] if period is None else [Function("slow", ("tractor.ay",), lambda _, y: y, period, units=("m/s^2",))]

    def impatient(_: object, now: float) -> None:
        if now > 0.0:
            raise KeyboardInterrupt

    simulate_many(model(TRAIN), [Case()], 0.1, keep=(STEER,))
    monkeypatch.setattr("eom.simulation.progress.Progress.reached", impatient)
    cases = [Case({STEER: Sine(0.01, 0.2 + 0.01 * k, cycles=20.0)}) for k in range(4)]
    with pytest.raises(RunInterrupted, match=r"^interrupted at [\d.]+ s$") as stopped:
        simulate_many(model(TRAIN), cases, 50.0, blocks=blocks, keep=(STEER,), threads=1)
    partial: Any = stopped.value.partial
    taken = np.sum(np.isfinite(partial.of(STEER)), axis=1)
    assert np.all((taken > 0) & (taken < 5001))


def sawtooth(x: Any, u: Any, _numbers: Any) -> tuple[Any, Any, Any]:
    """Nothing moves; the limit is where the input vanishes."""
    return [0.0 * x[0] + 0.0 * u[0]], [u[0]], [x[0]]


@pytest.mark.parametrize("compiled", [True, False])
def test_events_of_a_step_and_of_the_jump_at_its_end_both_have_room(compiled: bool) -> None:
    """An input that rises through zero within every step of 0.1 s, and falls below it at every end."""
    made = ready(named_for_its_text(sawtooth), (np.array([2.0]),), 1, 1)
    limits = (Limit("limit", "limit", "it is crossed", ends=False),)
    equations = Equations(made, limits, np.ones(1), np.ones(1))
    own = driven({"u": told(lambda t: t % 0.1 - 0.05, "u", 20.0)}, ("u",), np.zeros(1))
    parameters = np.repeat(made.parameters[:, np.newaxis], 2, axis=1)
    settings = (of.RUNGE_KUTTA, 0.5, 1e-6)
    with contextlib.nullcontext() if compiled else without_compiler():
        found = fleet(
            equations, parameters, [np.zeros(1)] * 2, [own, own], np.array([0.0, 20.0]), np.array([0]), settings, 1
        )
        found.go_on(20.0, np.inf, closed=True)
    assert np.all(found.clock[:, of.TIME] == 20.0)
    # below zero from the beginning, then above at each middle and below at each jump but the last
    assert [sum(map(len, parts)) for parts in found.events] == [400, 400]
