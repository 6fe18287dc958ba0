"""Limits that a run reached, as marks on its picture and lines of text."""

import textwrap
from collections.abc import Sequence

from eom.simulation.channels import Event

TOGETHER = 0.004
"""Share of the duration within which events are one mark."""
TOLD = 12
"""Marks that are numbered and told; what comes after them is a line without a number."""


def marked(events: Sequence[Event], duration: float) -> list[list[Event]]:
    """Events in order of time, those at about the same time together."""
    marks: list[list[Event]] = []
    for event in sorted(events, key=lambda event: event.time):
        if marks and event.time - marks[-1][0].time <= TOGETHER * duration:
            marks[-1].append(event)
        else:
            marks.append([event])
    return marks


def told(marks: Sequence[Sequence[Event]], width: int) -> list[str]:
    """Text for each mark that is numbered, and for all the others, in lines of at most *width* characters."""
    lines = []
    for number, mark in enumerate(marks[:TOLD], 1):
        kinds: dict[str, list[str]] = {}
        for event in mark:
            end = "" if event.until is None else f" until {event.until:.2f} s"
            kinds.setdefault(f"{event.kind}{end}", []).append(event.owner)
        what = "; ".join(f"{kind}: {', '.join(owners)}" for kind, owners in kinds.items())
        lines += textwrap.wrap(f"{number}   {mark[0].time:.2f} s   {what}", width, subsequent_indent=" " * 8)
    others = sum(map(len, marks[TOLD:]))
    return [*lines, f"and {others} more, as lines without a number"] if others else lines
