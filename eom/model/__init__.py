"""Models of a vehicle: what `eom.assemble`, `eom.linearise`, `eom.build` and `eom.reformulate` return."""

from eom.model.assembly import Assembly as Assembly
from eom.model.assembly import assemble as assemble
from eom.model.linear import LinearModel as LinearModel
from eom.model.linear import linearise as linearise
from eom.model.modes import Modes as Modes
from eom.model.reformulation import Reformulation as Reformulation
from eom.model.reformulation import reformulate as reformulate
from eom.model.tyre import TyreModel as TyreModel
from eom.model.tyre import build as build
