"""Runs that nobody simulated: numbers that are hard to keep, and the B-train's outputs along a made motion."""

from functools import cache
from pathlib import Path

import numpy as np

import eom
from eom.assembly.vectors import Array
from eom.model.tyre import TyreModel
from eom.simulation.run import Channels, Event, Run

VEHICLES = Path(__file__).parents[2] / "vehicles"
HARD = (0.1, 1.0 / 3.0, -0.0, 5e-324, 1.7976931348623157e308, np.nan, np.inf, -np.inf, 2.0**53 + 2.0)
"""Numbers that a careless file changes."""


def channels(named: dict[str, str], values: Array) -> Channels:
    """Signals of names with units, and descriptions of some."""
    names = tuple(named)
    descriptions = tuple(f"what {name} is, in µm" if k % 2 else "" for k, name in enumerate(names))
    return Channels(names, tuple(named.values()), descriptions, values)


def numbers(rng: np.random.Generator, samples: int, signals: int) -> Array:
    """Numbers of all sizes."""
    return rng.standard_normal((samples, signals)) * 10.0 ** rng.integers(-12, 12, (samples, signals))


def small_run(
    *,
    inputs: tuple[str, ...] = ("axle_1.steer",),
    outputs: tuple[str, ...] = ("tractor.ay", "tractor_frame.roll", "axle_1.left.kappa"),
    blocks: tuple[str, ...] = ("gyro.measured",),
    events: tuple[Event, ...] = (),
    samples: int = 23,
) -> Run:
    """A run of a few signals with random numbers and the hard ones; one name is that of an output and of a state."""
    rng = np.random.default_rng(7)
    y = numbers(rng, samples, len(outputs))
    y[: len(HARD), 0] = HARD[:samples]
    units = ("m/s^2", "rad", "")
    return Run(
        name="Test train, 5 µm",
        time=np.cumsum(rng.random(samples)),
        inputs=channels(dict.fromkeys(inputs, "rad"), numbers(rng, samples, len(inputs))),
        states=channels(
            {"tractor_frame.roll": "rad", "tractor_frame.v_x": "m/s", "axle_1.left.spin": "rad/s"},
            numbers(rng, samples, 3),
        ),
        outputs=channels({name: units[k % 3] for k, name in enumerate(outputs)}, y),
        blocks=channels(dict.fromkeys(blocks, "rad/s"), numbers(rng, samples, len(blocks))),
        events=events,
        method="Runge-Kutta of order 5 with its own step",
        ended="",
        identity={"vehicle": "Test train", "file": "straße.yaml", "sha256": "0" * 64, "parameters": "U = 30\nm = 2"},
    )


@cache
def b_train() -> TyreModel:
    """The B-train with nonlinear tyres."""
    model = eom.build(eom.load(VEHICLES / "b_train.yaml"))
    assert isinstance(model, TyreModel)
    return model


@cache
def b_train_run() -> Run:
    """The B-train's outputs along a made swerve: a wave of steer that the units follow later, by yaw rate and roll."""
    model, samples = b_train(), 81
    time = np.linspace(0.0, 4.0, samples)
    trim, steady = model.trim()
    x, u = np.tile(trim, (samples, 1)), np.tile(steady, (samples, 1))
    u[:, model.inputs.index("axle_1.steer")] = wave(time, 0.0, 0.02)
    for k, name in enumerate(model.states):
        body, _, quantity = name.partition(".")
        late = 0.4 * sum(body.startswith(unit) for unit in ("semitrailer", "semitrailer_2"))
        size = {"roll": 0.03, "yaw_rate": 0.2, "yaw_from_tractor_frame": 0.1}.get(quantity, 0.0)
        x[:, k] += wave(time, 0.3 + late, 0.5 * size if body.endswith("axles") else size)
    y = np.array([model.output(t, *at) for t, *at in zip(time, x, u, strict=True)])
    return Run(
        name=model.vehicle.name,
        time=time,
        inputs=Channels(model.inputs, model.input_units, ("",) * len(model.inputs), u),
        states=Channels(model.states, model.state_units, ("",) * len(model.states), x),
        outputs=Channels(model.outputs, model.output_units, ("",) * len(model.outputs), y),
        blocks=Channels((), (), (), np.zeros((samples, 0))),
        events=(),
        method="made",
        ended="",
        identity={},
    )


def wave(time: Array, start: float, size: float) -> Array:
    """One cycle of a sine of 0.5 Hz."""
    since = time - start
    return np.where((since > 0.0) & (since < 2.0), size * np.sin(np.pi * since), 0.0)


def event(kind: str, owner: str, time: float, until: float | None = None) -> Event:
    """A limit that was reached."""
    return Event(kind, owner, time, until, "it does what it must not", np.zeros(3))


def without(group: Channels, *endings: str) -> Channels:
    """The group without signals of these endings."""
    kept = [k for k, name in enumerate(group.names) if not name.endswith(endings)]
    pick = (tuple(part[k] for k in kept) for part in (group.names, group.units, group.descriptions))
    names, units, descriptions = pick
    return Channels(names, units, descriptions, group.values[:, kept])
