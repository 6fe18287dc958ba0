"""The one family of exceptions: each message names the object, what was expected and what came."""

from collections.abc import Sequence
from dataclasses import dataclass


class EomError(Exception):
    """Base of every error that a user can cause or meet."""


@dataclass(frozen=True, order=True)
class Mistake:
    """One mistake in a description or tyre file, with the place where it stands.

    Attributes
    ----------
    file : str
        The file's name as the user gave it.
    line, column : int
        Position of the offending text, counted from 1; 0 if it stands outside the file.
    where : str
        Dotted path of the key, such as ``bodies.frame.mass``; empty for the file as a whole.
    what : str
        The sentence: what is wrong, what was expected, what to do.
    """

    file: str
    line: int
    column: int
    where: str
    what: str

    def __str__(self) -> str:
        where = f"{self.where}: " if self.where else ""
        place = f"{self.file}:{self.line}:{self.column}" if self.line else self.file
        return f"{place}: {where}{self.what}"


class DescriptionError(EomError):
    """A vehicle or tyre file that says something wrong; holds every mistake found, in reading order."""

    def __init__(self, mistakes: Sequence[Mistake]) -> None:
        self.mistakes = tuple(sorted(set(mistakes)))
        super().__init__("\n".join(map(str, self.mistakes)))


class EquilibriumError(EomError):
    """The drawn geometry, loads and trim are not in balance."""


class SingularError(EomError):
    """A matrix that must be regular is not: no mass, a locked loop, lost pivots."""


class OutputError(EomError):
    """An output that no proper state space can give."""


class AnalysisError(EomError):
    """An analysis that cannot be done as asked, or that has no result; a sentence for every mistake."""


class TyreError(EomError):
    """Coefficients of a tyre that cannot be, or a question that a tyre model has no answer to."""


class MechanismError(EomError):
    """A mechanism that cannot be driven as asked; ``partial`` holds what was computed until then, if anything."""

    def __init__(self, message: str, partial: object = None) -> None:
        self.partial = partial
        super().__init__(message)


class SimulationError(EomError):
    """A simulation that cannot go on or cannot be done as asked; ``partial`` holds the run until then, if any."""

    def __init__(self, message: str, partial: object = None) -> None:
        self.partial = partial
        super().__init__(message)


def raised(error: BaseException) -> str:
    """What an exception of someone else's code says, for a sentence of ours."""
    return f"raised {type(error).__name__}: {error}".removesuffix(": ")
