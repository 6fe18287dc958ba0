"""Parameters of the tractor and semitrailer: thesis, Table A1 and Table 4.1."""

from dataclasses import dataclass
from typing import ClassVar

from eom.closed_form.parameters import Parameters


@dataclass(frozen=True, kw_only=True)
class TractorSemitrailer(Parameters):
    """A tractor with two axles and a semitrailer with one; the defaults are the thesis's nominal values.

    Table A1 gives places, masses and inertias, Table 4.1 the cornering stiffnesses. Values are numbers in SI units,
    or symbols for the functions that only write matrices.

    Attributes
    ----------
    m1, m2 : float
        Mass of tractor and semitrailer [kg].
    I_zz1, I_zz2 : float
        Yaw moments of inertia about their mass centres [kg m^2].
    a11 : float
        From the tractor's mass centre forward to its front axle [m].
    b12 : float
        From the tractor's mass centre back to its rear axle [m].
    l_c1 : float
        From the tractor's mass centre back to the fifth wheel [m].
    l_c21 : float
        From the semitrailer's mass centre forward to the fifth wheel [m].
    b23 : float
        From the semitrailer's mass centre back to its axle [m].
    C_f11, C_r12, C_r23 : float
        Cornering stiffness of the tractor's front axle, its rear axle and the semitrailer's axle, all wheels of the
        axle together [N/rad].

    Raises
    ------
    EomError
        If a number is not finite, or a mass, inertia or stiffness not positive.
    """

    POSITIVE: ClassVar[tuple[str, ...]] = ("m1", "m2", "I_zz1", "I_zz2", "C_f11", "C_r12", "C_r23")

    m1: float = 6525.0
    m2: float = 11665.0
    I_zz1: float = 20616.0
    I_zz2: float = 113580.0
    a11: float = 1.115
    b12: float = 2.585
    l_c1: float = 1.959
    l_c21: float = 5.493
    b23: float = 4.507
    C_f11: float = 242597.0
    C_r12: float = 578760.0
    C_r23: float = 554484.0
