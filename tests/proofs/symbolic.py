# SPDX-License-Identifier: MIT
"""Follows all paths of a function at once, its integers being mathematical ones.

Every operation that could wrap is an obligation: that its true result lies in the range of its
type. So where all obligations hold, integers of the machine and of mathematics are the same, and
what is shown of these holds of those. An integer is a term with an interval that encloses it,
whatever the path; most obligations follow from intervals alone, the rest are the solver's.
"""
import re
from dataclasses import dataclass

import z3

TRUE, FALSE = z3.BoolVal(True), z3.BoolVal(False)


def both(a, b):
    if z3.is_false(a) or z3.is_false(b):
        return FALSE
    return b if z3.is_true(a) else a if z3.is_true(b) else z3.And(a, b)


def either(a, b):
    if z3.is_true(a) or z3.is_true(b):
        return TRUE
    return b if z3.is_false(a) else a if z3.is_false(b) else z3.Or(a, b)


def opposite(a):
    return FALSE if z3.is_true(a) else TRUE if z3.is_false(a) else z3.Not(a)


@dataclass
class Number:
    term: z3.ArithRef
    low: int
    high: int


@dataclass
class Half:
    """64 bits of a number of 128, on their way through a call: "low" or "high", and as which
    stage of being taken apart or put together."""
    number: Number
    part: str
    guard: z3.BoolRef  # on which paths it was taken


@dataclass
class Pair:
    """What an operation with an overflow bit yields."""
    value: Number
    overflow: z3.BoolRef


@dataclass
class Obligation:
    what: str
    holds: z3.BoolRef  # on every path
    rests_on: list     # presuppositions and earlier obligations


def constant(value):
    return Number(z3.IntVal(value), value, value)


def least(bits):
    return -(1 << (bits - 1))


def fits(number, bits):
    """Is it a number of so many bits, signed?"""
    low, high = least(bits), -least(bits) - 1
    return both(TRUE if number.low >= low else number.term >= low,
                TRUE if number.high <= high else number.term <= high)


def width(kind):
    return int(re.fullmatch(r"i(\d+)", kind)[1])


class Walk:
    """One claim: its obligations, in the order of the blocks."""

    def __init__(self, blocks, order, successors):
        self.values = {}
        self.obligations = []
        self.presupposed = []
        self.inputs = []
        self.operations = 0  # that could wrap
        self.edges = {}  # (from, to) -> on which paths it is taken
        self.guards = {blocks[0].name: TRUE}
        self.entry = blocks[0].name
        for block in order:
            self.block = block.name
            self.guard = self.guards.get(block.name, FALSE)
            for instruction in block.instructions:
                self.step(instruction)
            for name, condition, sense in successors(block):
                way = TRUE if condition is None else self.truth(condition)
                taken = both(self.guard, way if sense else opposite(way))
                self.edges[(block.name, name)] = either(
                    self.edges.get((block.name, name), FALSE), taken)
                self.guards[name] = either(self.guards.get(name, FALSE), taken)

    # Operands.
    def number(self, operand, bits=None):
        if operand in self.values:
            value = self.values[operand]
            if isinstance(value, Half):
                return self.whole(value)
            if isinstance(value, Number):
                return value
            if bits is not None and z3.is_bool(value):
                return Number(z3.If(value, z3.IntVal(1), z3.IntVal(0)), 0, 1)
            raise ValueError(f"{operand} is no number")
        return constant(int(operand))

    def truth(self, operand):
        if operand in ("true", "false"):
            return TRUE if operand == "true" else FALSE
        value = self.values[operand]
        if not z3.is_bool(value):
            raise ValueError(f"{operand} is no truth value")
        return value

    def operand(self, kind, operand):
        if operand in ("undef", "poison"):
            raise ValueError("an undefined value is used")
        if kind == "i1":
            return self.truth(operand)
        value = self.values.get(operand)
        return value if isinstance(value, Half) else self.number(operand)

    # Obligations.
    def oblige(self, what, holds):
        goal = either(opposite(self.guard), holds)
        if not z3.is_true(goal):
            self.obligations.append(
                Obligation(f"{self.block}: {what}", goal, list(self.presupposed)))
            self.presupposed.append(goal)

    def within(self, number, bits, what):
        """The number, obliged to be one of so many bits: its interval is cut to them."""
        self.oblige(f"{what} fits {bits} bits", fits(number, bits))
        return Number(number.term, max(number.low, least(bits)),
                      min(number.high, -least(bits) - 1))

    def whole(self, half):
        """The low half by itself: the number was cut off, and has to fit."""
        if half.part != "low":
            raise ValueError("half a number is used otherwise than to put it together")
        here, self.guard = self.guard, half.guard
        number = self.within(half.number, 64, "a conversion")
        self.guard = here
        return number

    # Arithmetic.
    def compute(self, opcode, a, b):
        self.operations += 1
        if opcode in ("add", "sub"):
            sign = 1 if opcode == "add" else -1
            low, high = (b.low, b.high) if sign > 0 else (-b.high, -b.low)
            term = a.term + b.term if sign > 0 else a.term - b.term
            return Number(term, a.low + low, a.high + high)
        if opcode == "mul":
            ends = [x * y for x in (a.low, a.high) for y in (b.low, b.high)]
            return Number(a.term * b.term, min(ends), max(ends))
        if opcode in ("shl", "ashr") and b.low == b.high:
            by = 1 << b.low
            if opcode == "shl":
                return self.compute("mul", a, constant(by))
            return Number(a.term / by, a.low // by, a.high // by)  # rounds down, both
        if opcode in ("sdiv", "srem") and b.low >= 0:
            # By 0 the term is any number; that it does not happen is an obligation of its own.
            magnitude = z3.If(a.term >= 0, a.term, -a.term)
            quotient = z3.If(a.term >= 0, magnitude / b.term, -(magnitude / b.term))
            most = max(abs(a.low), abs(a.high))
            if opcode == "sdiv":
                return Number(quotient, -most, most)
            return Number(a.term - quotient * b.term, max(-most, 1 - b.high),
                          min(most, b.high - 1))
        if opcode == "and" and b.low == b.high and b.low > 0 and b.low & (b.low - 1) == 0:
            # One bit of a number: either value, for all that is said of it.
            bit = z3.FreshBool("bit")
            return Number(z3.If(bit, z3.IntVal(b.low), z3.IntVal(0)), 0, b.low)
        raise ValueError(f"{opcode} of such operands is not known")

    def choose(self, condition, a, b):
        if z3.is_true(condition) or z3.is_false(condition):
            return a if z3.is_true(condition) else b
        if isinstance(a, Half) or isinstance(b, Half):
            if not (isinstance(a, Half) and isinstance(b, Half) and a.part == b.part):
                a, b = (self.whole(x) if isinstance(x, Half) else x for x in (a, b))
                return self.choose(condition, a, b)
            return Half(self.choose(condition, a.number, b.number), a.part,
                        either(a.guard, b.guard))
        if isinstance(a, Number):
            return Number(z3.If(condition, a.term, b.term), min(a.low, b.low),
                          max(a.high, b.high))
        return either(both(condition, a), both(opposite(condition), b))

    def compare(self, predicate, a, b, bits):
        if predicate.startswith("u"):
            # Of unsigned ones: only where none is negative is that the same.
            self.oblige("compared as unsigned", both(
                TRUE if a.low >= 0 else a.term >= 0, TRUE if b.low >= 0 else b.term >= 0))
            predicate = "s" + predicate[1:]
        if predicate in ("slt", "sle"):
            predicate, a, b = "sg" + predicate[2], b, a
        if predicate == "sgt":
            return TRUE if a.low > b.high else FALSE if a.high <= b.low else a.term > b.term
        if predicate == "sge":
            return TRUE if a.low >= b.high else FALSE if a.high < b.low else a.term >= b.term
        apart = a.high < b.low or b.high < a.low
        same = FALSE if apart else TRUE if a.low == a.high == b.low == b.high else a.term == b.term
        return same if predicate == "eq" else opposite(same)

    # Instructions.
    def step(self, instruction):
        try:
            result = getattr(self, "do_" + instruction.opcode, self.do_arithmetic)(instruction)
        except (ValueError, AttributeError, KeyError) as error:
            raise ValueError(f"{instruction.opcode} {instruction.text}: {error}") from error
        if instruction.result:
            self.values[instruction.result] = result

    def do_arithmetic(self, instruction):
        match = re.fullmatch(r"(?:(?:nsw|nuw|exact) )*(i\d+) (\S+), (\S+)", instruction.text)
        if not match:
            raise ValueError(f"not known: {instruction.opcode} {instruction.text}")
        bits, opcode = width(match[1]), instruction.opcode
        if bits == 1:
            a, b = self.truth(match[2]), self.truth(match[3])
            if opcode == "xor":
                return opposite(a) if z3.is_true(b) else a != b
            return {"and": both, "or": either}[opcode](a, b)
        a, b = self.operand(match[1], match[2]), self.operand(match[1], match[3])
        if isinstance(a, Half) or isinstance(b, Half) or (opcode, match[3]) == ("lshr", "64"):
            return self.halves(opcode, a, b)
        return self.within(self.compute(opcode, a, b), bits, opcode)

    def halves(self, opcode, a, b):
        if opcode == "lshr":
            return Half(a, "high of 128", self.guard)
        if opcode == "shl" and isinstance(a, Half) and a.part == "high put down":
            return Half(a.number, "high put up", a.guard)
        if opcode == "or" and isinstance(a, Half) and isinstance(b, Half):
            if {a.part, b.part} == {"high put up", "low put down"}:
                if z3.eq(a.number.term, b.number.term):
                    return a.number
        raise ValueError("halves of a number are used otherwise than to put it together")

    def do_trunc(self, instruction):
        kind, operand, to = re.fullmatch(r"(i\d+) (\S+) to (i\d+)", instruction.text).groups()
        value = self.operand(kind, operand)
        if isinstance(value, Half):
            if value.part == "high of 128" and to == "i64":
                return Half(value.number, "high", value.guard)
            value = self.whole(value)
        if (kind, to) == ("i128", "i64") and fits(value, 64) is not TRUE:
            return Half(value, "low", self.guard)
        if to == "i1":
            return (value.term % 2) == 1
        return self.within(value, width(to), "a conversion")

    def do_zext(self, instruction):
        kind, operand, to = re.fullmatch(r"(i\d+) (\S+) to (i\d+)", instruction.text).groups()
        value = self.operand(kind, operand)
        if isinstance(value, Half):
            return Half(value.number, value.part + " put down", value.guard)
        if kind == "i1":
            return Number(z3.If(value, z3.IntVal(1), z3.IntVal(0)), 0, 1)
        if (kind, to) == ("i64", "i128"):
            return Half(value, "low put down", self.guard)
        self.oblige("widened as unsigned", TRUE if value.low >= 0 else value.term >= 0)
        return value

    def do_sext(self, instruction):
        kind, operand, _ = re.fullmatch(r"(i\d+) (\S+) to (i\d+)", instruction.text).groups()
        value = self.operand(kind, operand)
        if isinstance(value, Half):
            return self.whole(value)
        if kind == "i1":
            return Number(z3.If(value, z3.IntVal(-1), z3.IntVal(0)), -1, 0)
        return value

    def do_icmp(self, instruction):
        predicate, kind, a, b = re.fullmatch(r"(\w+) (i\d+) (\S+), (\S+)",
                                             instruction.text).groups()
        if kind == "i1":
            same = self.truth(a) == self.truth(b)
            return {"eq": same, "ne": opposite(same)}[predicate]
        return self.compare(predicate, self.number(a), self.number(b), width(kind))

    def do_select(self, instruction):
        condition, kind, a, _, b = re.fullmatch(
            r"i1 (\S+), (i\d+) (\S+), (i\d+) (\S+)", instruction.text).groups()
        return self.choose(self.truth(condition), self.operand(kind, a), self.operand(kind, b))

    def do_phi(self, instruction):
        kind, rest = instruction.text.split(" ", 1)
        result = None
        for operand, origin in re.findall(r"\[ (\S+), (\S+) \]", rest):
            # The entry has no label; it is the one that no other block is called.
            name = origin if (origin, self.block) in self.edges else self.entry
            way = self.edges.get((name, self.block), FALSE)
            if z3.is_false(way):
                continue
            value = self.operand(kind, operand)
            result = value if result is None else self.choose(way, value, result)
        return result if result is not None else (FALSE if kind == "i1" else constant(0))

    def do_freeze(self, instruction):
        return self.operand(*instruction.text.split(" "))

    def do_extractvalue(self, instruction):
        operand, index = re.fullmatch(r"{.*} (\S+), (\d)", instruction.text).groups()
        pair = self.values[operand]
        return pair.value if index == "0" else pair.overflow

    def do_call(self, instruction):
        name, words = re.search(r"@([\w.]+)\((.*)\)", instruction.text).groups()
        arguments = [(word.split()[0], word.split()[-1]) for word in words.split(", ") if word]
        overflow = re.fullmatch(r"llvm\.s(add|sub|mul)\.with\.overflow\.i(\d+)", name)
        if overflow:
            value = self.compute(overflow[1], *(self.number(a) for _, a in arguments))
            bits = int(overflow[2])
            inside = fits(value, bits)
            # The other way out is a trap: behind it the value is one of its type.
            return Pair(Number(value.term, max(value.low, least(bits)),
                               min(value.high, -least(bits) - 1)), opposite(inside))
        if name == "between":
            low, high = (int(a) for _, a in arguments)
            value = Number(z3.Int(f"n{len(self.inputs)}"), low, high)
            self.inputs.append(value.term)
            self.presupposed += [value.term >= low, value.term <= high]
            return value
        if name == "assume":
            self.presupposed.append(either(opposite(self.guard), self.truth(arguments[0][1])))
        elif name == "check":
            self.oblige("check", self.truth(arguments[0][1]))
        elif name == "llvm.ubsantrap":
            self.oblige("no undefined behaviour", FALSE)
        elif name == "__assert_fail":
            self.oblige("what the source asserts", FALSE)
        elif not re.match(r"llvm\.(lifetime|assume|dbg|experimental\.noalias)", name):
            raise ValueError(f"a function that is not known: {name}")
        return None

    def do_br(self, instruction):
        return None

    do_ret = do_unreachable = do_br
