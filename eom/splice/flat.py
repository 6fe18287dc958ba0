"""A model's numbers laid out for compiled loops: plain arrays, and only the entries that are not zero."""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from eom.assembly.vectors import Array
from eom.splice.state import Model, sizes

Indices = NDArray[np.intp]


class Entries(NamedTuple):
    """The entries of a matrix that are not zero: row, column, value."""

    row: Indices
    column: Indices
    value: Array


class Entries3(NamedTuple):
    """The entries of an array of three dimensions that are not zero: layer, row, column, value."""

    layer: Indices
    row: Indices
    column: Indices
    value: Array


class FlatBody(NamedTuple):
    """`eom.splice.multibody.Multibody` as loops take it; ``supports`` are reactions of supports alone."""

    mass: Array
    inertia: Array
    M: Entries
    C: Entries
    C_slip: Entries
    K: Entries
    T: Entries
    W: Array
    W_turn: Entries3
    rate: Entries
    react: Entries
    react_turn: Entries3
    f: Array
    planar: Array
    B: Entries
    steering: Indices
    speed: float
    lead: Indices
    held: bool
    rows: int


class FlatWheels(NamedTuple):
    """`eom.splice.contact.Contact` as loops take it: each wheel's rows over its own body."""

    body: Indices
    rows: Array
    lean: Entries
    number: Array
    radius: Array
    lever: Array
    heave: Array
    nominal: Array
    base: Array
    carried: Array
    share: Array
    most: Array
    alone: Array
    sprung: Entries
    damped: Entries
    spin: Indices
    side: Indices
    relaxation: Array
    supports: Indices
    load_gain: Array


class FlatControl(NamedTuple):
    """`eom.splice.state.Control` as loops take it."""

    steer: Entries
    brake: Entries
    demand: Array
    drive: Array
    drive_lag: float
    brake_lag: float
    spin: Entries
    drags: Array
    drag_factor: Array


class Flat(NamedTuple):
    """All of them; ``starts`` of the parts of the state, and ``tyres`` of the groups of laws."""

    body: FlatBody
    wheels: FlatWheels
    control: FlatControl
    starts: Indices
    tyres: Any


def entries(matrix: Array) -> Entries:
    """The entries of a matrix that are not zero."""
    row, column = np.nonzero(matrix)
    return Entries(row, column, np.ascontiguousarray(matrix[row, column]))


def entries3(array: Array) -> Entries3:
    """The entries of an array of three dimensions that are not zero."""
    layer, row, column = np.nonzero(array)
    return Entries3(layer, row, column, np.ascontiguousarray(array[layer, row, column]))


def places(among: Indices, count: int) -> Indices:
    """For each of *count* numbers its place among some of them, -1 for none."""
    result = np.full(count, -1, dtype=np.intp)
    result[among] = np.arange(len(among))
    return result


def flat(p: Model, tyres: Any) -> Flat:
    """A model's numbers for loops, with what they take for its tyres."""
    body, c, control = p.body, p.contact, p.control
    rows = len(body.react)
    turn = body.react_turn.reshape(-1, rows, rows)
    own = np.array([np.flatnonzero(np.any(c.rows[:, k] != 0.0, axis=0))[0] // 6 for k in range(len(c.number))])
    local = np.array([c.rows[:, k, 6 * b : 6 * b + 6] for k, b in enumerate(own)])
    return Flat(
        FlatBody(
            mass=body.mass,
            inertia=body.inertia,
            M=entries(body.M),
            C=entries(body.C),
            C_slip=entries(body.C_slip),
            K=entries(body.K),
            T=entries(body.T),
            W=np.ascontiguousarray(body.W),
            W_turn=entries3(body.W_turn.reshape(-1, *body.W.shape)),
            rate=entries(body.rate),
            react=entries(body.react),
            react_turn=entries3(turn[:, c.supports]),
            f=body.f,
            planar=body.planar,
            B=entries(body.B),
            steering=body.steering,
            speed=body.speed,
            lead=body.lead,
            held=body.held,
            rows=rows,
        ),
        FlatWheels(
            body=own,
            rows=np.ascontiguousarray(local),
            lean=entries(c.lean),
            number=c.number,
            radius=c.radius,
            lever=c.lever,
            heave=c.heave,
            nominal=c.nominal,
            base=c.base,
            carried=c.carried,
            share=c.share,
            most=c.most,
            alone=c.alone,
            sprung=entries(c.sprung),
            damped=entries(c.damped),
            spin=places(c.spinning, len(c.number)),
            side=places(c.relaxing, len(c.number)),
            relaxation=c.relaxation,
            supports=c.supports,
            load_gain=np.ascontiguousarray(p.load_gain),
        ),
        FlatControl(
            steer=entries(control.steer),
            brake=entries(control.brake),
            demand=control.demand,
            drive=control.drive,
            drive_lag=control.drive_lag,
            brake_lag=control.brake_lag,
            spin=entries(control.spin),
            drags=control.drags,
            drag_factor=control.drag_factor,
        ),
        np.cumsum((0, *sizes(p)))[:-1],
        tyres,
    )
