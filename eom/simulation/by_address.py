"""How compiled loops call a program: by its address, with pointers into the arrays of `eom.simulation.memory`."""

from functools import cache
from importlib import import_module
from typing import Any

from eom.program.value import constant, double, integer
from eom.simulation.memory import PARAMETERS, RESULTS, SCRATCH, STATES, U


@cache
def by_address() -> Any:
    """Numba's call of a program at an address, see `eom.simulation.steps.evaluate`."""
    extending, types, ir = (import_module(name) for name in ("numba.extending", "numba.types", "llvmlite.ir"))

    def code(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        program, _, _, row, _, level = args

        def data(k: int) -> Any:
            """Pointer to the elements of an array."""
            return context.make_array(signature.args[k])(context, builder, args[k]).data

        def offset(k: int) -> Any:
            """An entry of *at*."""
            place = builder.load(builder.gep(data(1), [constant(integer(), k)], inbounds=True))
            return builder.gep(data(4), [place], inbounds=True)

        states = builder.load(builder.gep(data(1), [constant(integer(), STATES)], inbounds=True))
        state = builder.gep(data(2), [builder.mul(row, states)], inbounds=True)
        form = ir.FunctionType(ir.VoidType(), [double().as_pointer()] * 5 + [integer()])
        pointers = [state, *map(offset, (U, PARAMETERS, SCRATCH, RESULTS))]
        builder.call(builder.inttoptr(program, form.as_pointer()), [*pointers, level])
        return context.get_dummy_value()

    def call(_typing: Any, program: Any, at: Any, v: Any, _row: Any, work: Any, _level: Any) -> Any:
        return types.void(program, at, v, types.int64, work, types.int64), code

    return extending.intrinsic(call)
