"""Parameters of the B-train double in the yaw plane: thesis, Appendix B."""

from dataclasses import dataclass
from typing import ClassVar

from eom.closed_form.parameters import Parameters
from eom.closed_form.tyre_derivatives import Axle


@dataclass(frozen=True, kw_only=True)
class BTrainYawPlane(Parameters):
    """A tractor and two semitrailers with three axles each; the defaults are the thesis's nominal values.

    All from Appendix B, but m3, which it leaves out: the sum of its sprung and unsprung mass. Values are numbers in SI
    units, or symbols for the functions that only write matrices. A unit's mass centre is that of its whole mass.

    Attributes
    ----------
    m1, m2, m3 : float
        Mass of tractor, first and second semitrailer [kg].
    I_zz1, I_zz2, I_zz3 : float
        Yaw moments of inertia about the mass centres [kg m^2].
    a11 : float
        From the tractor's mass centre forward to its front axle [m].
    b12, b13 : float
        From the tractor's mass centre back to its rear axles [m].
    b24, b25, b26, b37, b38, b39 : float
        From the mass centre of the first, the second semitrailer back to its axles [m].
    l_c1 : float
        From the tractor's mass centre back to the first coupling [m].
    l_c21, l_c22 : float
        From the first semitrailer's mass centre forward to the first, back to the second coupling [m].
    l_c3 : float
        From the second semitrailer's mass centre forward to the second coupling [m].
    C1, C2, C3, C4, C5, C6, C7, C8, C9 : float
        Cornering stiffness of the axles, front to rear, all wheels of the axle together [N/rad].

    Raises
    ------
    EomError
        If a number is not finite, or a mass, inertia or stiffness not positive.
    """

    POSITIVE: ClassVar[tuple[str, ...]] = (
        *("m1", "m2", "m3", "I_zz1", "I_zz2", "I_zz3"),
        *("C1", "C2", "C3", "C4", "C5", "C6", "C7", "C8", "C9"),
    )

    m1: float = 8258.0
    m2: float = 17997.0
    m3: float = 17997.0
    I_zz1: float = 43996.0
    I_zz2: float = 490940.0
    I_zz3: float = 490940.0
    a11: float = 1.999
    b12: float = 3.001
    b13: float = 4.271
    b24: float = 3.257
    b25: float = 4.527
    b26: float = 5.797
    b37: float = 3.257
    b38: float = 4.527
    b39: float = 5.797
    l_c1: float = 3.636
    l_c21: float = 6.973
    l_c22: float = 5.597
    l_c3: float = 6.973
    C1: float = 424000.0
    C2: float = 420200.0
    C3: float = 420200.0
    C4: float = 581900.0
    C5: float = 581900.0
    C6: float = 581900.0
    C7: float = 346500.0
    C8: float = 346500.0
    C9: float = 346500.0

    @property
    def axles(self) -> tuple[tuple[Axle, ...], ...]:
        """The axles of each unit, front to rear."""
        return (
            (Axle(self.C1, self.a11), Axle(self.C2, -self.b12), Axle(self.C3, -self.b13)),
            (Axle(self.C4, -self.b24), Axle(self.C5, -self.b25), Axle(self.C6, -self.b26)),
            (Axle(self.C7, -self.b37), Axle(self.C8, -self.b38), Axle(self.C9, -self.b39)),
        )


@dataclass(frozen=True, kw_only=True)
class BTrainBraked(BTrainYawPlane):
    """The B-train with what longitudinal motion and brakes add: thesis, Appendix B.

    Appendix B gives r_w for the semitrailers; the tractor's wheels are taken to be the same.

    Attributes
    ----------
    f_r : float
        Rolling resistance per weight [-].
    g : float
        Gravity [m/s^2]; not printed, 9.8 gives the thesis's static wheel loads (29 395 N and 17 824 N).
    r_w : float
        Rolling radius of the wheels [m].
    K_b : float
        Brake torque per pressure of each wheel [N m/Pa]; 14 286 N m/MPa in Appendix B.
    d2, d3 : float
        Track of the first, the second semitrailer [m].
    """

    POSITIVE: ClassVar[tuple[str, ...]] = (*BTrainYawPlane.POSITIVE, "g", "r_w", "K_b", "d2", "d3")

    f_r: float = 0.02
    g: float = 9.8
    r_w: float = 0.51
    K_b: float = 0.014286
    d2: float = 1.65
    d3: float = 1.65
