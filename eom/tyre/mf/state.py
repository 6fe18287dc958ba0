"""What every equation of the Magic Formula needs of a working point."""

from typing import Any, NamedTuple

from eom.tyre.contact import contact, rolling_sense
from eom.tyre.elementary import cos, magnitude, sin, sqrt, tan
from eom.tyre.parameters import Values

A_MU = 10.0
"""Digressive friction of the book, E8: shifts fall with friction more slowly than friction itself."""


class WorkingPoint(NamedTuple):
    """A working point.

    Attributes
    ----------
    alpha, kappa, gamma : float or array
        Slip angle, longitudinal slip and camber as they enter the curves; the book takes tan(alpha), sin(gamma).
    camber : float or array
        Camber angle [rad] itself.
    load, share : float or array
        Load [N] at which to evaluate, and share of the result, see `eom.tyre.contact.contact`.
    Fz0, dfz : float or array
        Nominal load [N] with its scale, and the load's relative distance from it, E1, E2a.
    cosine : float or array
        Cosine of the slip angle, E6: a trail at right angles to the motion gives no moment.
    fade : float or array
        Zero at standstill, one above VXLOW: what does not come from slip fades with it.
    reverse : float or array
        The same with the sign of the speed.
    mu_x, mu_y : float or array
        Scale of friction, E7.
    shift_x, shift_y : float or array
        Scale of friction in vertical shifts, E8.
    """

    alpha: Any
    kappa: Any
    gamma: Any
    camber: Any
    load: Any
    share: Any
    Fz0: Any
    dfz: Any
    cosine: Any
    fade: Any
    reverse: Any
    mu_x: Any
    mu_y: Any
    shift_x: Any
    shift_y: Any


def tool_state(p: Any, alpha: Values, kappa: Values, Fz: Values, gamma: Values, speed: Values) -> WorkingPoint:
    """The working point as the MF-Tyre tool takes it: angles themselves, no digressive friction."""
    return state_of(p, (alpha, gamma), (alpha, kappa, Fz, gamma, speed), (p.LMUX, p.LMUY, p.LMUX, p.LMUY))


def book_state(p: Any, alpha: Values, kappa: Values, Fz: Values, gamma: Values, speed: Values) -> WorkingPoint:
    """The working point as the book takes it: E3, E4, E7, E8."""
    slope = tan(alpha)
    decay = 1.0 + p.LMUV * magnitude(speed) * sqrt(kappa * kappa + slope * slope) / p.LONGVL
    mu_x, mu_y = p.LMUX / decay, p.LMUY / decay
    return state_of(
        p, (slope, sin(gamma)), (alpha, kappa, Fz, gamma, speed), (mu_x, mu_y, digressive(mu_x), digressive(mu_y))
    )


def digressive(mu: Values) -> Any:
    """E8."""
    return A_MU * mu / (1.0 + (A_MU - 1.0) * mu)


def state_of(
    p: Any,
    curve: tuple[Values, Values],
    arguments: tuple[Values, Values, Values, Values, Values],
    scales: tuple[Values, Values, Values, Values],
) -> WorkingPoint:
    """What both forms share: *curve* are slip angle and camber as they enter the curves, *scales* those of friction."""
    alpha, kappa, Fz, camber, speed = arguments
    mu_x, mu_y, shift_x, shift_y = scales
    load, share = contact(Fz, p.FNOMIN)
    Fz0 = p.LFZO * p.FNOMIN
    sense = rolling_sense(speed, p.VXLOW)
    return WorkingPoint(
        alpha=curve[0],
        kappa=kappa,
        gamma=curve[1],
        camber=camber,
        load=load,
        share=share,
        Fz0=Fz0,
        dfz=(load - Fz0) / Fz0,
        cosine=cos(alpha),
        fade=sense * sense,
        reverse=sense * magnitude(sense),
        mu_x=mu_x,
        mu_y=mu_y,
        shift_x=shift_x,
        shift_y=shift_y,
    )
