"""Parameters of the B-train double with roll: thesis, Appendix B."""

from dataclasses import dataclass
from typing import ClassVar

from eom.closed_form.b_train_parameters import BTrainYawPlane

MASSES = ("m_s1", "m_s2", "m_s3", "m_u1", "m_u2", "m_u3")
INERTIAS = ("I_sxx1", "I_sxx2", "I_sxx3", "I_u1xx", "I_u2xx", "I_u3xx")


@dataclass(frozen=True, kw_only=True)
class BTrainYawRoll(BTrainYawPlane):
    """The B-train with a sprung and an unsprung mass per unit; the defaults are the thesis's nominal values.

    All from Appendix B. Its K_r is taken as the stiffness of the suspension alone, in series with the tyres' K_t, as
    (3.21) to (3.23) do, although it calls K_r "adjusted with the tire vertical stiffness". Its I_sxx = 6879 kg m^2 for
    all units is the tractor's value; it is low for a trailer of 15 927 kg.

    The unsprung masses follow from the whole and the sprung ones, and their places from the condition that a11, l_c21
    and l_c3 are measured from the whole-mass centres.

    Attributes
    ----------
    m_s1, m_s2, m_s3 : float
        Sprung masses [kg].
    a11s : float
        From the tractor's sprung mass centre forward to its front axle [m].
    a2s, a3s : float
        From the semitrailers' sprung mass centres forward to the first, the second coupling [m].
    h_r1, h_r2, h_r3 : float
        Height of the roll axes [m].
    h_s1, h_s2, h_s3, h_u1, h_u2, h_u3 : float
        Height of the sprung and unsprung mass centres [m].
    h_cr1, h_cr2, h_cr3 : float
        Height of the couplings above the roll axes [m]: 1.1 - 0.705. Both couplings of the first semitrailer are at
        h_cr2.
    I_sxx1, I_sxx2, I_sxx3, I_u1xx, I_u2xx, I_u3xx : float
        Roll moments of inertia about the mass centres of the sprung and unsprung masses [kg m^2].
    I_sxz1, I_sxz2, I_sxz3, I_u1xz, I_u2xz, I_u3xz : float
        Their products of inertia, the positive integrals of x z in SAE axes [kg m^2].
    K_r1f, K_r1r, K_r2, K_r3 : float
        Roll stiffness of the suspensions: tractor front and rear, semitrailers [N m/rad].
    L_r1f, L_r1r, L_r2, L_r3 : float
        Roll damping of the suspensions [N m s/rad].
    K_t1f, K_t1r, K_t2, K_t3 : float
        Roll stiffness of the tyres [N m/rad].
    K_12, K_23 : float
        Roll stiffness of the couplings [N m/rad].
    g : float
        Gravity [m/s^2]; not printed, 9.8 gives the thesis's static wheel loads (29 395 N and 17 824 N).

    Raises
    ------
    EomError
        If a number is not finite, or a mass, moment of inertia or cornering stiffness not positive.
    """

    POSITIVE: ClassVar[tuple[str, ...]] = (*BTrainYawPlane.POSITIVE, *MASSES, *INERTIAS)

    m_s1: float = 6308.0
    m_s2: float = 15927.0
    m_s3: float = 15927.0
    a11s: float = 1.384
    a2s: float = 6.385
    a3s: float = 6.385
    h_r1: float = 0.705
    h_r2: float = 0.705
    h_r3: float = 0.705
    h_s1: float = 1.019
    h_s2: float = 1.555
    h_s3: float = 1.555
    h_u1: float = 0.519
    h_u2: float = 0.51
    h_u3: float = 0.51
    h_cr1: float = 0.395
    h_cr2: float = 0.395
    h_cr3: float = 0.395
    I_sxx1: float = 6879.0
    I_sxx2: float = 6879.0
    I_sxx3: float = 6879.0
    I_sxz1: float = 130.0
    I_sxz2: float = 130.0
    I_sxz3: float = 130.0
    I_u1xx: float = 867.0
    I_u2xx: float = 798.0
    I_u3xx: float = 798.0
    I_u1xz: float = 0.0
    I_u2xz: float = 0.0
    I_u3xz: float = 0.0
    K_r1f: float = 700e3
    K_r1r: float = 1100e3
    K_r2: float = 2000e3
    K_r3: float = 2200e3
    L_r1f: float = 50e3
    L_r1r: float = 80e3
    L_r2: float = 120e3
    L_r3: float = 120e3
    K_t1f: float = 900e3
    K_t1r: float = 1500e3
    K_t2: float = 6000e3
    K_t3: float = 5200e3
    K_12: float = 550e3
    K_23: float = 550e3
    g: float = 9.8

    @property
    def m_u1(self) -> float:
        """Unsprung mass of the tractor [kg]."""
        return self.m1 - self.m_s1

    @property
    def m_u2(self) -> float:
        """Unsprung mass of the first semitrailer [kg]."""
        return self.m2 - self.m_s2

    @property
    def m_u3(self) -> float:
        """Unsprung mass of the second semitrailer [kg]."""
        return self.m3 - self.m_s3
