"""Progress of what takes long, on a terminal only."""

import sys
import time
from types import TracebackType
from typing import Any, Self

PATIENCE = 2.0
"""Time [s] on the wall before anything is shown."""


class Progress:
    """Shows how far a run is, if it takes long and someone is there to see it.

    As a context: what is shown ends with it.
    """

    def __init__(self, what: str, whole: float | None = None) -> None:
        self.what, self.whole = what, whole
        self.begun = time.perf_counter()
        self.bar: Any = None
        self.task: Any = None
        self.slice: float | None = None
        self.last = (0.0, self.begun)

    def __enter__(self) -> Self:
        # without a length it is shown at once: nothing will call while it waits
        if self.whole is None and sys.stderr.isatty():
            self.show()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if self.bar is not None:
            self.bar.stop()

    def show(self) -> None:
        """Begin to show."""
        from rich.console import Console  # noqa: PLC0415  slow to import
        from rich.progress import BarColumn, SpinnerColumn, TextColumn, TimeElapsedColumn  # noqa: PLC0415
        from rich.progress import Progress as Bar  # noqa: PLC0415

        length = [SpinnerColumn()] if self.whole is None else [BarColumn(), TextColumn("{task.percentage:3.0f} %")]
        columns = [TextColumn("{task.description}"), *length, TimeElapsedColumn()]
        self.bar = Bar(*columns, console=Console(stderr=True), transient=True)
        self.bar.start()
        self.task = self.bar.add_task(self.what, total=self.whole)

    def next_stop(self, now: float, slice_: float) -> float:
        """The time of the run [s] at which to look again, some *slice_* of time on the wall later."""
        then, wall = self.last
        if now > then:
            passed = time.perf_counter() - wall
            self.slice = min(max((now - then) * slice_ / max(passed, 1e-6), 1e-3), 16.0 * (self.slice or 1.0))
        self.last = now, time.perf_counter()
        return now + (self.slice or 1.0)

    def reached(self, now: float) -> None:
        """Show that the run reached a time [s]."""
        if self.bar is None and sys.stderr.isatty() and time.perf_counter() - self.begun > PATIENCE:
            self.show()
        if self.bar is not None:
            self.bar.update(self.task, completed=now)
