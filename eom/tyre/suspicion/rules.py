"""Sentences for what is suspicious about a tyre's coefficients; nothing is changed."""

import numpy as np

from eom.errors import TyreError
from eom.tyre.interface import Tyre
from eom.tyre.magic_formula import MagicFormula
from eom.tyre.mf.coefficients import MagicFormula52, MagicFormula61
from eom.tyre.parameters import coefficients
from eom.tyre.suspicion.behaviour import BEHAVIOUR
from eom.tyre.suspicion.coefficients import COEFFICIENTS
from eom.tyre.suspicion.combined import COMBINED
from eom.tyre.suspicion.curves import MAGIC_CURVES, THESIS_CURVES
from eom.tyre.suspicion.proportion import PROPORTIONS


# coefficients beyond all sense divide by zero; what is then no number is suspicious, or no matter for a rule
@np.errstate(divide="ignore", invalid="ignore", over="ignore")
def suspicions(tyre: Tyre) -> tuple[str, ...]:
    """A sentence for each suspicious thing about one tyre: the coefficient, its value, and why.

    A sane set of coefficients has none. A suspicion is no mistake: the tyre computes what its coefficients say.
    Looked at are loads, slips and camber in the tyre's range as far as it is usual (`eom.tyre.usual_range.range_of`).

    Raises
    ------
    TyreError
        For a stack of tyres.
    """
    if any(np.ndim(getattr(tyre, item.name)) for item in coefficients(tyre)):
        raise TyreError("suspicions: expected one tyre, not a stack")
    rules = [*BEHAVIOUR, *COMBINED]
    if isinstance(tyre, MagicFormula61 | MagicFormula52):
        rules += [*MAGIC_CURVES, *COEFFICIENTS, *PROPORTIONS]
    elif isinstance(tyre, MagicFormula):
        rules += THESIS_CURVES
    return tuple(sentence for rule in rules for sentence in rule(tyre))
