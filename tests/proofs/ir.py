# SPDX-License-Identifier: MIT
"""Reads the textual form of LLVM's intermediate representation: functions of integers, without
memory. What it does not know it refuses."""
import re
from dataclasses import dataclass, field


@dataclass
class Instruction:
    result: str  # "%7", or "" where there is none
    opcode: str
    text: str    # what follows the opcode


@dataclass
class Block:
    name: str
    instructions: list = field(default_factory=list)


def functions(text, prefix):
    """name -> blocks, the entry first, of the functions whose names begin with the prefix."""
    found = {}
    pattern = re.compile(rf"^define [^\n]*@({prefix}\w+)\(\)[^\n]*{{\n(.*?)^}}", re.M | re.S)
    for match in pattern.finditer(text):
        found[match[1]] = blocks_of(match[2])
    return found


def blocks_of(body):
    blocks = [Block("%entry")]
    for line in body.splitlines():
        line = re.sub(r"(, ![\w.]+ ![\w.]+)+|\s+;.*|\s+#\d+(?=,|$)", "", line).strip()
        label = re.fullmatch(r"(\"[^\"]*\"|[-\w.$]+):", line)
        if label:
            if blocks[-1].instructions:
                blocks.append(Block(""))
            blocks[-1].name = "%" + label[1]
        elif line:
            assigned = re.fullmatch(r"(?:(%[-\w.$]+) = )?(?:tail )?(\w+)\s*(.*)", line)
            if not assigned:
                raise ValueError(f"no instruction: {line}")
            blocks[-1].instructions.append(
                Instruction(assigned[1] or "", assigned[2], assigned[3]))
    return blocks


def successors(block):
    """(block's name, condition's operand or None, its sense) for each way out."""
    last = block.instructions[-1]
    if last.opcode in ("ret", "unreachable"):
        return []
    both = re.fullmatch(r"i1 (\S+), label (\S+), label (\S+)", last.text)
    if both:
        return [(both[2], both[1], True), (both[3], both[1], False)]
    one = re.fullmatch(r"label (\S+)", last.text)
    if last.opcode != "br" or not one:
        raise ValueError(f"unknown way out: {last.opcode} {last.text}")
    return [(one[1], None, True)]


def in_order(blocks):
    """The blocks, each behind all that lead to it. A loop is an error: it was not unrolled."""
    by_name = {block.name: block for block in blocks}
    # The entry's label is left out; phis name it by the number it would have.
    order, state = [], {}

    def visit(name):
        if state.get(name) == "open":
            raise ValueError("a loop is left")
        if name in state:
            return
        state[name] = "open"
        for successor, _, _ in successors(by_name[name]):
            visit(successor)
        state[name] = "done"
        order.append(by_name[name])

    visit(blocks[0].name)
    return order[::-1]
