"""A system whose wheels have linear tyres at the trim: what the linear kernel assembles."""

from eom.splice.closure import slip_speed_slope, slopes_at_trim
from eom.splice.contact import FORWARD, LATERAL, wheel_connection
from eom.splice.prepare import Prepared
from eom.splice.trim import wheel_forces
from eom.vehicle.elements import Slip, System

ALPHA, KAPPA = 0, 1
FX, FY = 0, 1


def with_linear_tyres(system: System, prepared: Prepared) -> System:
    """The system with the forces of its wheels at the trim as loads, and their slopes there as slip elements.

    A wheel's rows are named after it, ``axle_1.left.lateral`` and, where its spin is a state, ``.longitudinal``, which
    here is that of a spin that does not change.
    """
    trim = prepared.trim
    slopes = slopes_at_trim(prepared)
    over, change = slip_speed_slope(trim.speed)
    slips = []
    for k, wheel in enumerate(system.wheels):
        lateral = wheel_connection(wheel, LATERAL)._replace(name=f"{wheel.name}.lateral")
        slips.append(Slip(lateral, ((float(-slopes[ALPHA, FY, k]) / over,),)))
        if wheel.spin_inertia > 0.0:
            forward = wheel_connection(wheel, FORWARD)._replace(name=f"{wheel.name}.longitudinal")
            stiffness = float(slopes[KAPPA, FX, k] * (1.0 + change * trim.slip[k]))
            slips.append(Slip(forward, ((stiffness / over,),)))
    return system._replace(loads=(*system.loads, *wheel_forces(system, trim)), slip=(*system.slip, *slips))
