"""Four numbers that compiled code handles in one instruction: a vector at a point, or one number along three axes.

The compiler does not find this by itself in loops over the few nodes round a particle, and needs twice the time
without it. Lanes exist inside kernels only; their arithmetic is + - * / with lanes and numbers, `minimum`, `maximum`.
"""

import operator

from llvmlite import ir
from numba.core import cgutils, types
from numba.core.datamodel import PrimitiveModel, register_default
from numba.core.typing.templates import AbstractTemplate, infer_global, signature
from numba.extending import intrinsic, lower_builtin

WIDTH = 4
ALIGNMENT = 8  # bytes; arrays promise no more
_DOUBLE = ir.DoubleType()
_VECTOR = ir.VectorType(_DOUBLE, WIDTH)
_INDEX = ir.IntType(32)


class LanesType(types.Type):
    """Numba's type of lanes."""

    def __init__(self) -> None:
        super().__init__(name="MatpointLanes")


LANES = LanesType()


@register_default(LanesType)
class _LanesModel(PrimitiveModel):
    def __init__(self, dmm, fe_type) -> None:
        super().__init__(dmm, fe_type, _VECTOR)


def _together(builder, values):
    vector = ir.Constant(_VECTOR, ir.Undefined)
    for place, value in enumerate(values):
        vector = builder.insert_element(vector, value, ir.Constant(_INDEX, place))
    return vector


def _as_vector(context, builder, value, its_type):
    if its_type is LANES:
        return value
    return _together(builder, [context.cast(builder, value, its_type, types.float64)] * WIDTH)


def _pointer(context, builder, array_type, array, place):
    data = context.make_array(array_type)(context, builder, array).data
    return builder.bitcast(builder.gep(data, [place]), _VECTOR.as_pointer())


def _read(builder, pointer):
    vector = builder.load(pointer)
    vector.align = ALIGNMENT
    return vector


def _write(builder, vector, pointer):
    builder.store(vector, pointer).align = ALIGNMENT


@intrinsic
def lanes(typing, a, b, c, d):
    """Lanes (a, b, c, d)."""

    def generate(context, builder, sig, args):
        numbers = [context.cast(builder, *pair, types.float64) for pair in zip(args, sig.args, strict=True)]
        return _together(builder, numbers)

    return LANES(a, b, c, d), generate


@intrinsic
def lane(typing, vector, place):
    """Number in lane `place`, 0 ... 3."""

    def generate(context, builder, sig, args):
        return builder.extract_element(args[0], builder.trunc(args[1], _INDEX))

    return types.float64(LANES, types.intp), generate


@intrinsic
def load(typing, array, place):
    """Lanes from array[place : place + 4] of a flat array."""

    def generate(context, builder, sig, args):
        return _read(builder, _pointer(context, builder, sig.args[0], *args))

    return LANES(array, types.intp), generate


@intrinsic
def store(typing, array, place, vector):
    """Write lanes to array[place : place + 4] of a flat array."""

    def generate(context, builder, sig, args):
        _write(builder, args[2], _pointer(context, builder, sig.args[0], args[0], args[1]))

    return types.void(array, types.intp, LANES), generate


@intrinsic
def add_to(typing, array, place, vector):
    """Add lanes to array[place : place + 4] of a flat array."""

    def generate(context, builder, sig, args):
        pointer = _pointer(context, builder, sig.args[0], args[0], args[1])
        _write(builder, builder.fadd(_read(builder, pointer), args[2]), pointer)

    return types.void(array, types.intp, LANES), generate


def _call(builder, name, arguments):
    kind = ir.FunctionType(_VECTOR, [_VECTOR] * len(arguments))
    function = cgutils.get_or_insert_function(builder.module, kind, f"llvm.{name}.v{WIDTH}f64")
    return builder.call(function, arguments)


@intrinsic
def fused(typing, factor, vector, summand):
    """factor * vector + summand, rounded once where the processor can; factor is lanes or a number."""

    def generate(context, builder, sig, args):
        factor_vector = _as_vector(context, builder, args[0], sig.args[0])
        return _call(builder, "fmuladd", [factor_vector, args[1], args[2]])

    return LANES(factor, LANES, LANES), generate


def _of_two(name):
    """A function of two operands, of which at least one is lanes, by the name of LLVM's intrinsic."""

    def typed(typing, a, b):
        def generate(context, builder, sig, args):
            pair = [_as_vector(context, builder, *item) for item in zip(args, sig.args, strict=True)]
            return _call(builder, name, pair)

        return LANES(a, b), generate

    return typed


minimum = intrinsic(_of_two("minnum"))
maximum = intrinsic(_of_two("maxnum"))


def _operator(function, instruction):
    """Let Numba know an arithmetic operator between lanes and lanes or numbers."""

    class Typed(AbstractTemplate):
        def generic(self, args, keywords):
            if any(kind is LANES for kind in args):
                return signature(LANES, *(LANES if kind is LANES else types.float64 for kind in args))
            return None

    infer_global(function)(Typed)
    for kinds in ((LANES, LANES), (LANES, types.float64), (types.float64, LANES)):

        def generate(context, builder, sig, args):
            pair = [_as_vector(context, builder, *item) for item in zip(args, sig.args, strict=True)]
            return getattr(builder, instruction)(*pair)

        lower_builtin(function, *kinds)(generate)


_operator(operator.add, "fadd")
_operator(operator.sub, "fsub")
_operator(operator.mul, "fmul")
_operator(operator.truediv, "fdiv")
