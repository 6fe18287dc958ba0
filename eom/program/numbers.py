"""The numbers of a model as parameters of a program: which may differ from case to case, which are structure."""

import dis
import hashlib
from collections.abc import Iterator, Sequence
from numbers import Real
from types import FunctionType, SimpleNamespace
from typing import Any, NamedTuple

import numpy as np

from eom.assembly.vectors import Array
from eom.program.arrays import as_nodes
from eom.program.operations import Op
from eom.program.tape import Tape

PACKAGE = "eom"
STRUCTURAL = (0.0, 1.0, -1.0, np.inf, -np.inf)
"""Numbers that make an operation trivial: where all cases have the same one, it is none of the parameters."""


class Numbers(NamedTuple):
    """Numbers of several cases with the same structure.

    Attributes
    ----------
    like : object
        The first case as it was given.
    fixed : NDArray
        Whether each number is structural, (all,).
    values : Array
        The parameters, (parameters, cases).
    signature : str
        Hash of the structure.
    """

    like: Any
    fixed: np.ndarray[Any, np.dtype[np.bool_]]
    values: Array
    signature: str


class Coefficients(SimpleNamespace):
    """Coefficients of a function over lanes, by the names that it reads."""

    names: tuple[str, ...]
    formula: Any


def coefficient_names(item: Any) -> tuple[str, ...]:
    """Names of the numbers of an object that its ``formula`` reads; empty for an object without formula."""
    formula = getattr(item, "formula", None)
    if formula is None:
        return ()
    read = sorted({name for function in reached(formula) for name in loaded(function, "LOAD_ATTR")})
    return tuple(name for name in read if isinstance(getattr(item, name, None), (Real, np.ndarray)))


def reached(function: Any) -> Iterator[Any]:
    """A function and all functions of this package that it calls."""
    yield function
    for name in loaded(function, "LOAD_GLOBAL"):
        value = function.__globals__.get(name)
        if isinstance(value, FunctionType) and value.__module__.startswith(PACKAGE):
            yield from reached(value)


def loaded(function: Any, instruction: str) -> set[str]:
    """The names that a function loads by a kind of instruction."""
    return {item.argval for item in dis.get_instructions(function) if item.opname == instruction}


def leaves(item: Any) -> Iterator[Any]:
    """All numbers, arrays and else that a structure of tuples holds."""
    names = coefficient_names(item)
    if isinstance(item, tuple):
        for part in item:
            yield from leaves(part)
    elif names:
        yield f"{item.formula.__module__}.{item.formula.__qualname__}{names}"
        for name in names:
            yield np.asarray(getattr(item, name), dtype=float)
    else:
        yield item


def is_number(item: Any) -> bool:
    """Whether a leaf is one or more real numbers."""
    return isinstance(item, float) or (isinstance(item, np.ndarray) and item.dtype.kind == "f")


def gathered(cases: Sequence[Any]) -> Numbers:
    """The numbers of cases; raises ``ValueError`` if they differ in more than numbers."""
    every = [list(leaves(case)) for case in cases]
    digests = {digest(own) for own in every}
    if len(digests) > 1:
        raise ValueError("cases differ in structure")
    values = np.array(
        [np.concatenate([np.empty(0), *(np.ravel(leaf) for leaf in own if is_number(leaf))]) for own in every]
    )
    fixed = np.isin(values[0], STRUCTURAL) & np.all(values == values[0], axis=0)
    # what stands alone may be asked for its sign
    signs = [float(np.sign(leaf)) for leaf in every[0] if isinstance(leaf, float)]
    text = f"{digests.pop()}{fixed.tobytes().hex()}{values[0][fixed].tolist()}{signs}"
    signature = hashlib.sha256(text.encode()).hexdigest()
    return Numbers(cases[0], fixed, np.ascontiguousarray(values[:, ~fixed].T), signature)


def digest(own: Sequence[Any]) -> str:
    """Hash of what is no number, and of the shapes of what is."""
    result = hashlib.sha256()
    for leaf in own:
        if is_number(leaf):
            result.update(f"numbers{np.shape(leaf)}".encode())
        elif isinstance(leaf, np.ndarray):
            result.update(f"{leaf.dtype}{leaf.shape}{leaf.tolist()}".encode())
        else:
            result.update(repr(leaf).encode())
    return result.hexdigest()


def lifted(numbers: Numbers, tape: Tape) -> Any:
    """The first case with its numbers as nodes."""
    fixed = iter(numbers.fixed)
    tape.samples.extend(numbers.values[:, 0])
    tape.vanishing.update(np.flatnonzero(np.any(numbers.values == 0.0, axis=1)).tolist())
    count = iter(range(len(tape.samples)))

    def node(value: float) -> Any:
        """A number as a constant or parameter."""
        return tape.constant(value) if next(fixed) else tape.node(Op.PARAMETER, next(count))

    def array(values: Any) -> Any:
        """An array of them."""
        result = np.empty(np.shape(values), dtype=object)
        for place, value in np.ndenumerate(values):
            result[place] = node(float(value))
        return as_nodes(result)

    def walk(item: Any) -> Any:
        """A structure of tuples."""
        names = coefficient_names(item)
        if isinstance(item, tuple):
            parts = [walk(part) for part in item]
            return type(item)(*parts) if hasattr(item, "_fields") else tuple(parts)
        if names:
            own = {name: array(getattr(item, name)) for name in names}
            return Coefficients(names=names, formula=item.formula, **own)
        if isinstance(item, float):
            alone = node(item)
            tape.alone.add(alone.place)
            return alone
        return array(item) if is_number(item) else item

    return walk(numbers.like)
