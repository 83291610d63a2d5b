# SPDX-License-Identifier: MIT
"""The mutation operators, by their usual abbreviations, and the function of switches.h for each.

    AOR   arithmetic operator replacement: + -> -, - -> +, * -> +, / -> *, % -> *
    AORS  the same for short-cuts: ++ <-> --
    ASR   assignment operator replacement: += <-> -=, *= <-> /=, %= -> *=
    COI   conditional operator insertion: the condition of an if, ?: or while is negated
    COR   conditional operator replacement: && <-> ||
    CRP   constant replacement: a number n -> n + 1 and n -> n - 1, true <-> false
    FNR   function replacement: std::min <-> std::max, floor <-> ceil
    LOR   logical (bitwise) operator replacement: & <-> |, ^ -> &
    ROR   relational operator replacement: the boundary moved (< <-> <=, > <-> >=), and negated
    SDL   statement deletion: assignments, calls and the like; break, continue, return without value
    SOR   shift operator replacement: << <-> >>
    UOD   unary operator deletion: -, !, ~

A mutant that another one equals is left out: negating a condition that is one relation is ROR,
negating one that starts with ! is UOD.
"""

# operator of two operands -> (abbreviation, function, [replacement, ...])
BINARY = {
    "+": ("AOR", "plus", ["-"]),
    "-": ("AOR", "minus", ["+"]),
    "*": ("AOR", "times", ["+"]),
    "/": ("AOR", "divide", ["*"]),
    "%": ("AOR", "modulo", ["*"]),
    "<<": ("SOR", "shift_left", [">>"]),
    ">>": ("SOR", "shift_right", ["<<"]),
    "&": ("LOR", "bit_and", ["|"]),
    "|": ("LOR", "bit_or", ["&"]),
    "^": ("LOR", "bit_xor", ["&"]),
    "<": ("ROR", "less", ["<=", ">="]),
    "<=": ("ROR", "less_equal", ["<", ">"]),
    ">": ("ROR", "greater", [">=", "<="]),
    ">=": ("ROR", "greater_equal", [">", "<"]),
    "==": ("ROR", "equal", ["!="]),
    "!=": ("ROR", "unequal", ["=="]),
}
ASSIGNMENT = {
    "+=": ("ASR", "plus_assign", ["-="]),
    "-=": ("ASR", "minus_assign", ["+="]),
    "*=": ("ASR", "times_assign", ["/="]),
    "/=": ("ASR", "divide_assign", ["*="]),
    "%=": ("ASR", "modulo_assign", ["*="]),
}
UNARY = {"-": ("UOD", "negate"), "!": ("UOD", "invert"), "~": ("UOD", "complement")}
STEP = {"++": ("AORS", "increment", "--"), "--": ("AORS", "decrement", "++")}
# Functions of <algorithm> and <cmath>, by the text that calls them.
CALLED = {"std::min": ("Minimum", "std::max"), "std::max": ("Maximum", "std::min"),
          "std::floor": ("Floor", "std::ceil"), "std::ceil": ("Ceil", "std::floor")}
# Member functions without arguments.
MEMBERS = {"floor": ("floor_of", "ceil"), "ceil": ("ceil_of", "floor")}

RELATIONS = {token for token, entry in BINARY.items() if entry[0] == "ROR"}

# Classes of our own that have arithmetic, and which; every relation that is written exists.
CLASS_ARITHMETIC = {"edgecase::Fixed": "+-", "edgecase::Interval": "+-*/"}
