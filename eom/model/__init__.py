"""Models of a vehicle: what `eom.assemble` and `eom.linearise` return."""

from eom.model.assembly import Assembly as Assembly
from eom.model.assembly import assemble as assemble
from eom.model.linear import LinearModel as LinearModel
from eom.model.linear import linearise as linearise
from eom.model.modes import Modes as Modes
