"""Names of the values in a text, so few that memory is used again soon."""

from collections.abc import Iterable, Mapping


class Names:
    """Names of values; one that is not used any more is given to another, so that its memory is used again soon.

    Made of statements: the place of the value, if it is one, and those that it takes. Values may have names of their
    own.
    """

    def __init__(
        self, statements: Iterable[tuple[int | None, Iterable[int]]], form: str, own: Mapping[int, str]
    ) -> None:
        self.form, self.own, self.made = form, own, 0
        self.of: dict[int, str] = {}
        self.free: list[str] = []
        last: dict[int, int] = {}
        self.order: dict[int, int] = {}
        for k, (place, takes) in enumerate(statements):
            last.update(dict.fromkeys(takes, k))
            if place is not None:
                self.order[place] = k
        self.ends: dict[int, list[int]] = {}
        for place, k in last.items():
            if place in self.order and place not in own:
                self.ends.setdefault(k, []).append(place)
        self.done = 0

    def given(self, place: int) -> str:
        """The name of a value whose statement is next; it may be that of a value which the statement takes."""
        for k in range(self.done, self.order[place] + 1):
            self.free += [self.of[old] for old in self.ends.get(k, ())]
        self.done = self.order[place] + 1
        if place in self.own:
            self.of[place] = self.own[place]
        elif self.free:
            self.of[place] = self.free.pop()
        else:
            self.of[place] = self.form.format(self.made)
            self.made += 1
        return self.of[place]
