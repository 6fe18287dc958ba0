"""The nonlinear equations in loops, for a compiler: what `eom.splice.rates` says in arrays, to rounding.

Plain functions of numbers and arrays; `eom.splice.compiled` makes machine code of them. Wheels' forces on bodies are,
as in `eom.splice.contact`: forward, lateral, roll, pitch, yaw, vertical.
"""

import math
from typing import Any

import numpy as np

from eom.splice.balance import LOAD_STEP
from eom.splice.flat import Flat, FlatBody, FlatWheels
from eom.splice.laws import forces as tyre_forces
from eom.splice.small_algebra import add_product, factorised, gauss, moved_by, product, projected, solved
from eom.splice.wheels import CREEP, LOW_SPEED


def turned(vectors: Any, yaw: Any, sense: float) -> Any:
    """Translational parts turned about z by each body's yaw, or against it."""
    result = vectors.copy()
    for i in range(len(vectors) // 6):
        cos, sin = math.cos(yaw[6 * i + 5]), sense * math.sin(yaw[6 * i + 5])
        x, y = vectors[6 * i], vectors[6 * i + 1]
        result[6 * i], result[6 * i + 1] = cos * x - sin * y, sin * x + cos * y
    return result


def kept(value: float, low: float) -> float:
    """`eom.tyre.contact.kept_above` of a real number."""
    x = min(value / low, 1.0)
    return max(value, 0.5 * low * (1.0 + x * x))


def sense(v: float, low: float) -> float:
    """`eom.tyre.contact.rolling_sense` of a real number."""
    x = min(max(v / low, -1.0), 1.0)
    return x * (1.5 - 0.5 * x * x)


def mass_factor(W: Any, body: FlatBody) -> Any:
    """Cholesky factor of W' M W."""
    moved = np.zeros_like(W)
    row, column, value = body.M.row, body.M.column, body.M.value
    for k in range(len(value)):
        for j in range(W.shape[1]):
            moved[row[k], j] += value[k] * W[column[k], j]
    mass = np.zeros((W.shape[1], W.shape[1]))
    for r in range(W.shape[0]):
        for i in range(W.shape[1]):
            if W[r, i] != 0.0:
                for j in range(i + 1):
                    mass[i, j] += W[r, i] * moved[r, j]
    factorised(mass, 1 if body.held else 0)
    return mass


def passive(u: Any, n: Any, w: Any, local: Any, displaced: Any, p: Flat) -> Any:
    """`eom.splice.balance.passive_forces` less what the drift of the velocities needs."""
    body, control = p.body, p.control
    v_x, yaw_rate = n[body.lead[0]], n[body.lead[2]]
    planar, drags, drag_factor = body.planar.copy(), control.drags, control.drag_factor
    for k in range(len(drag_factor)):
        along = 0.0
        for j in range(len(w)):
            along += drags[k, j] * local[j]
        for j in range(len(w)):
            planar[j] -= drags[k, j] * drag_factor[k] * along * abs(along)
    mass, inertia, drifting = body.mass, body.inertia, local.copy()
    for i in range(len(mass)):
        drifting[6 * i] -= body.speed
        drifting[6 * i + 2] += v_x * displaced[6 * i + 4]
    add_product(body.C_slip, drifting, planar, -1.0)
    result = body.f + turned(planar, displaced, 1.0)
    add_inputs(u, displaced, result, body)
    add_product(body.K, displaced, result, -1.0)
    add_product(body.C, w, result, -1.0)
    momentum = np.empty(3)
    for i in range(len(mass)):
        at = 6 * i
        result[at] += mass[i] * yaw_rate * w[at + 1]
        result[at + 1] -= mass[i] * yaw_rate * w[at]
        a, b, c = w[at + 3], w[at + 4], w[at + 5]
        for j in range(3):
            momentum[j] = inertia[i, j, 0] * a + inertia[i, j, 1] * b + inertia[i, j, 2] * c
        result[at + 3] -= b * momentum[2] - c * momentum[1]
        result[at + 4] -= c * momentum[0] - a * momentum[2]
        result[at + 5] -= a * momentum[1] - b * momentum[0]
    return result


def add_inputs(u: Any, displaced: Any, result: Any, body: FlatBody) -> None:
    """Add the forces of the multibody part's inputs, turned with the headings of the bodies that steer them."""
    row, column, value, steering = body.B.row, body.B.column, body.B.value, body.steering
    for k in range(len(value)):
        force = value[k] * u[column[k]]
        yaw = displaced[6 * steering[column[k]] + 5]
        if row[k] % 6 == 0:
            result[row[k]] += math.cos(yaw) * force
            result[row[k] + 1] += math.sin(yaw) * force
        elif row[k] % 6 == 1:
            result[row[k] - 1] -= math.sin(yaw) * force
            result[row[k]] += math.cos(yaw) * force
        else:
            result[row[k]] += force


def slips(arguments: Any, side: Any, omega: Any, steer: Any, x: Any, local: Any, p: Flat) -> None:
    """Fill slip angle, longitudinal slip and speed of the wheels, their kinematic slip angles and spins."""
    rows, body, radius = p.wheels.rows, p.wheels.body, p.wheels.radius
    spin, lagging, first_spin, first_side = p.wheels.spin, p.wheels.side, p.starts[3], p.starts[4]
    for k in range(len(omega)):
        at = 6 * body[k]
        v_x = v_y = 0.0
        for j in range(6):
            v_x += rows[k, 0, j] * local[at + j]
            v_y += rows[k, 1, j] * local[at + j]
        cos, sin = math.cos(steer[k]), math.sin(steer[k])
        forward, sideward = cos * v_x + sin * v_y, cos * v_y - sin * v_x
        speed = kept(abs(forward), LOW_SPEED)
        side[k] = math.atan(sideward / speed)
        omega[k] = x[first_spin + spin[k]] if spin[k] >= 0 else forward / radius[k]
        arguments[0, k] = x[first_side + lagging[k]] if lagging[k] >= 0 else side[k]
        arguments[1, k] = (omega[k] * radius[k] - forward) / speed
        arguments[4, k] = forward


def limits_of_load(free: Any, supports: Any, wheels: FlatWheels) -> Any:
    """Most that each wheel can carry; *free* is filled with its load if it cannot lift, less what is in it."""
    limit, share, most = wheels.alone.copy(), wheels.share, wheels.most
    for k in range(len(free)):
        carried = 0.0
        for s in range(len(supports)):
            free[k] += share[k, s] * supports[s]
            carried += most[k, s] * supports[s]
        limit[k] += max(carried, 0.0)
    return limit


def on_bodies(arguments: Any, load: Any, excess: Any, torque: Any, steer: Any, found: Any, p: Flat) -> Any:
    """Forces of the wheels on their bodies, (6, w), at given loads; *found* becomes those of the road, (5, w).

    *excess* is what the loads are beyond what supports and springs of the multibody part carry.
    """
    wheels = p.wheels
    arguments[2] = load
    found[:] = tyre_forces(p.tyres, wheels.number, arguments[0], arguments[1], load, arguments[3], arguments[4])
    result = np.zeros((6, len(load)))
    spin, radius, lever, heave = wheels.spin, wheels.radius, wheels.lever, wheels.heave
    for k in range(len(load)):
        spins = spin[k] >= 0
        if not spins:
            found[0, k] = (torque[k] + found[3, k]) / radius[k]
        cos, sin = math.cos(steer[k]), math.sin(steer[k])
        result[0, k] = cos * found[0, k] - sin * found[1, k]
        result[1, k] = sin * found[0, k] + cos * found[1, k]
        result[2, k] = cos * found[2, k] + lever[k] * excess[k]
        result[3, k] = sin * found[2, k] - (torque[k] if spins else -found[3, k])
        result[4, k] = found[4, k]
        result[5, k] = heave[k] * excess[k]
    return result


def generalised(on_body: Any, displaced: Any, p: Flat) -> Any:
    """Generalised forces of wheels' forces (6, w), turned by each body's heading."""
    rows, body, result = p.wheels.rows, p.wheels.body, np.zeros(len(displaced))
    for k in range(on_body.shape[1]):
        at = 6 * body[k]
        for kind in range(6):
            for j in range(6):
                result[at + j] += rows[k, kind, j] * on_body[kind, k]
    return turned(result, displaced, 1.0)


def support_reactions(q: Any, lacking: Any, p: Flat) -> Any:
    """Reactions of the supports that supply the *lacking* generalised forces."""
    body, supports = p.body, p.wheels.supports
    straight = product(body.react, lacking, body.rows)
    result = np.empty(len(supports))
    for s in range(len(supports)):
        result[s] = straight[supports[s]]
    layer, row, column, value = (
        body.react_turn.layer,
        body.react_turn.row,
        body.react_turn.column,
        body.react_turn.value,
    )
    for k in range(len(value)):
        result[row[k]] += q[layer[k]] * value[k] * straight[column[k]]
    return result


def torques_of(x: Any, u: Any, omega: Any, p: Flat) -> Any:
    """Torque of drive and brakes on each wheel, as `eom.splice.wheels.torques`."""
    control, radius, at = p.control, p.wheels.radius, p.starts[6]
    drive = x[p.starts[5]] if control.drive_lag > 0.0 else np.sum(control.demand * u)
    result = control.drive * drive
    pressed = product(control.brake, u, len(omega))
    for k in range(len(omega)):
        brake = x[at + k] if control.brake_lag > 0.0 else pressed[k]
        result[k] -= max(brake, 0.0) * sense(omega[k] * radius[k], CREEP)
    return result


def load_slopes(load: Any, limit: Any, slope: Any, p: Flat) -> Any:
    """Unit matrix less how supports' loads follow themselves, through slopes (6, w) of the wheels' forces."""
    wheels = p.wheels
    rows, body, share, most, gain = wheels.rows, wheels.body, wheels.share, wheels.most, wheels.load_gain
    lever = wheels.lever
    count = share.shape[1]
    result = np.eye(count)
    for k in range(len(load)):
        at = 6 * body[k]
        for s in range(count):
            follows = 0.0
            if load[k] > 0.0:
                follows = share[k, s] if load[k] < limit[k] else most[k, s]
            for j in range(6):
                change = rows[k, 2, j] * lever[k] * (follows - share[k, s])
                for kind in range(5):
                    change += rows[k, kind, j] * slope[kind, k] * follows
                for r in range(count):
                    result[r, s] -= gain[r, at + j] * change
    return result


def closed_loads(q: Any, W: Any, factor: Any, wheel: Any, applied: Any, displaced: Any, p: Flat) -> Any:
    """Loads of the supports, as `eom.splice.balance.support_loads`; *wheel* is what `on_bodies` takes."""
    wheels = p.wheels
    arguments, torque, steer, own, found = wheel
    supports, free = wheels.carried.copy(), own.copy()
    if len(supports) == 0:
        return supports
    limit = limits_of_load(free, supports, wheels)
    load = np.minimum(np.maximum(free, 0.0), limit)
    on_body = on_bodies(arguments, load, load - free, torque, steer, found, p)
    step = LOAD_STEP * wheels.nominal
    slope = (on_bodies(arguments, load + step, load - free, torque, steer, found, p) - on_body) / step
    force = applied + generalised(on_body, displaced, p)
    lacking = -force
    dn = solved(factor, projected(W, force), 1 if p.body.held else 0)
    add_product(p.body.M, moved_by(W, dn), lacking, 1.0)
    off = support_reactions(q, lacking, p) - supports
    return supports + gauss(load_slopes(load, limit, slope, p), off)


def fill_lags(result: Any, x: Any, u: Any, side: Any, forward: Any, p: Flat) -> None:
    """Rates of slip angles, drive torque and brake torques that lag."""
    wheels, control, starts = p.wheels, p.control, p.starts
    lagging, relaxation = wheels.side, wheels.relaxation
    for k in range(len(lagging)):
        if lagging[k] >= 0:
            at = starts[4] + lagging[k]
            result[at] = kept(abs(forward[k]), LOW_SPEED) / relaxation[lagging[k]] * (side[k] - x[at])
    if control.drive_lag > 0.0:
        result[starts[5]] = (np.sum(control.demand * u) - x[starts[5]]) / control.drive_lag
    if control.brake_lag > 0.0:
        pressed = product(control.brake, u, len(lagging))
        for k in range(len(lagging)):
            result[starts[6] + k] = (pressed[k] - x[starts[6] + k]) / control.brake_lag


def rates_by_loops(x: Any, u: Any, p: Flat) -> Any:
    """dx/dt at a real state x under inputs u, as `eom.splice.rates.rates`."""
    body, wheels, starts = p.body, p.wheels, p.starts
    q, n = x[starts[1] : starts[2]], x[starts[2] : starts[3]]
    N, count = len(body.f), len(wheels.number)
    dq, displaced = product(body.rate, n, len(q)), product(body.T, q, N)
    W, drift = body.W.copy(), np.zeros(N)
    layer, row, column, value = body.W_turn.layer, body.W_turn.row, body.W_turn.column, body.W_turn.value
    for k in range(len(value)):
        W[row[k], column[k]] += q[layer[k]] * value[k]
        drift[row[k]] += dq[layer[k]] * value[k] * n[column[k]]
    w = moved_by(W, n)
    local = turned(w, displaced, -1.0)
    factor = mass_factor(W, body)
    arguments, side, omega = np.empty((5, count)), np.empty(count), np.empty(count)
    steer = product(p.control.steer, u, count)
    arguments[3] = product(wheels.lean, displaced, count)
    slips(arguments, side, omega, steer, x, local, p)
    torque = torques_of(x, u, omega, p)
    rising = wheels.base + product(wheels.damped, product(body.T, dq, N), count)
    own = rising + product(wheels.sprung, displaced, count)
    # the drift of the velocities is a force of inertia
    applied = passive(u, n, w, local, displaced, p)
    add_product(body.M, drift, applied, -1.0)
    found = np.empty((5, count))
    wheel = (arguments, torque, steer, own, found)
    supports = closed_loads(q, W, factor, wheel, applied, displaced, p)
    limit = limits_of_load(own, supports, wheels)
    load = np.minimum(np.maximum(own, 0.0), limit)
    on_body = on_bodies(arguments, load, load - own, torque, steer, found, p)
    dn = solved(factor, projected(W, applied + generalised(on_body, displaced, p)), 1 if body.held else 0)
    result = np.empty(len(x))
    v_x, v_y, yaw = n[body.lead[0]], n[body.lead[1]], x[2]
    result[0] = math.cos(yaw) * v_x - math.sin(yaw) * v_y
    result[1] = math.sin(yaw) * v_x + math.cos(yaw) * v_y
    result[2] = n[body.lead[2]]
    result[starts[1] : starts[2]], result[starts[2] : starts[3]] = dq, dn
    rolling = torque + found[3] - wheels.radius * found[0]
    result[starts[3] : starts[4]] = product(p.control.spin, rolling, starts[4] - starts[3])
    fill_lags(result, x, u, side, arguments[4], p)
    return result
