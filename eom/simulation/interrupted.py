"""What an interrupt from the keyboard leaves."""

from typing import Generic, TypeVar

Computed = TypeVar("Computed")


class RunInterrupted(KeyboardInterrupt, Generic[Computed]):
    """A run, or many, that was interrupted from the keyboard; ``partial`` is what was computed until then."""

    def __init__(self, partial: Computed, message: str) -> None:
        self.partial = partial
        super().__init__(message)
