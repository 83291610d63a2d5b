# SPDX-License-Identifier: MIT
"""Finds the places of a file that can be mutated, and what has to be written there.

A site is an extent of the text with its edits: (start, end, new text), the new text calling a
function of tests/mutation/switches.h with the number of the site's first mutant. Sites nest.

Left alone: includes and other directives, strings, static_assert, template arguments, enumerators,
array bounds, case labels, functions that are `= default`, constants of classes, and constants that
anything left alone refers to: those serve constant expressions.
"""

import re
from dataclasses import dataclass, field, replace

from clang.cindex import CursorKind as Kind

from mutation import operators as ops
from mutation.source import (CLASSES, FUNCTIONS, children, declaration_start, is_expression,
                             is_number, is_pointer, span, type_name, unwrapped)

NUMBER = re.compile(r"[0-9.]")
CASTS = {Kind.CXX_STATIC_CAST_EXPR, Kind.CXX_FUNCTIONAL_CAST_EXPR, Kind.CSTYLE_CAST_EXPR,
         Kind.CXX_REINTERPRET_CAST_EXPR, Kind.CXX_CONST_CAST_EXPR}
SKIPPED = {Kind.STATIC_ASSERT, Kind.ENUM_DECL, Kind.TYPE_ALIAS_DECL, Kind.TYPEDEF_DECL,
           Kind.TYPE_REF, Kind.TEMPLATE_REF, Kind.NAMESPACE_REF}
JUMPS = {Kind.BREAK_STMT, Kind.CONTINUE_STMT, Kind.RETURN_STMT}
VARIABLES = {Kind.VAR_DECL, Kind.FIELD_DECL, Kind.PARM_DECL}


@dataclass
class Site:
    """A place, its mutants, and the edits that switch them; `{}` stands for the switch's class and
    first number: SWITCH::function(NUMBER."""
    start: int
    end: int
    rank: int                 # of equal extents, the higher rank lies outside
    operator: str
    function: str             # the function or variable that it is in
    constant: bool            # may the code run during compilation?
    shown: tuple              # extent of the text that names the site
    replacements: list        # per mutant (start, end, text): what it makes of that text
    edits: list = field(default_factory=list)
    number: int = 0           # of the first mutant


@dataclass(frozen=True)
class Place:
    """Where the walk is."""
    function: str       # the function or variable, with its classes
    constant: bool      # may the code here run during compilation?
    around: tuple       # extent of the construct round it: a literal is named by that
    in_function: bool

    def inside(self, name, constant, in_function):
        joined = f"{self.function}::{name}" if self.function else name
        return Place(joined, constant, None, in_function)

    def within(self, cursor):
        return replace(self, around=span(cursor))


class Finder:
    """Walks the tree of one source file."""

    def __init__(self, source):
        self.source = source
        self.sites = {}
        self.variables = []  # constexpr ones
        self.references = set()  # where the walk found one

    def find(self):
        declarations = [child for child in children(self.source.root) if self.source.holds(child)]
        for child in declarations:
            self.visit(child, Place("", False, None, False))
        self.leave_alone(self.constants_for_the_compiler(declarations))
        return sorted(self.sites.values(), key=lambda s: (s.start, -s.end, -s.rank, s.operator))

    def constants_for_the_compiler(self, declarations):
        """The variables that types, case labels and the like refer to: what the walk passes by."""
        return {node.referenced.hash for child in declarations for node in child.walk_preorder()
                if node.kind == Kind.DECL_REF_EXPR and span(node) not in self.references}

    def leave_alone(self, constants):
        for variable in [known for known in self.variables if known.hash in constants]:
            self.variables.remove(variable)
            start, end = span(variable)
            self.sites = {key: site for key, site in self.sites.items()
                          if site.end <= start or end <= site.start}

    def add(self, cursor, place, rank, operator, replacements, edits, shown=None):
        start, end = span(cursor)
        key = (start, end, operator, rank)
        if key not in self.sites:
            self.sites[key] = Site(start, end, rank, operator, place.function, place.constant,
                                   shown or (start, end), replacements, edits)

    # ------------------------------------------------------------------------------ declarations

    def visit(self, cursor, place):
        kind = cursor.kind
        if kind in SKIPPED:
            return
        if kind in FUNCTIONS:
            self.visit_function(cursor, place)
        elif kind in CLASSES:
            for child in children(cursor):
                self.visit(child, place.inside(cursor.spelling, False, False))
        elif kind in VARIABLES:
            self.visit_variable(cursor, place)
        elif is_expression(cursor):
            self.visit_expression(cursor, place)
        else:
            self.visit_statement(cursor, place)

    def visit_function(self, cursor, place):
        if self.is_defaulted(cursor):
            return
        start, _ = span(cursor)
        constant = self.source.find("constexpr", start, cursor.location.offset) is not None
        inner = place.inside(cursor.spelling, constant, True)
        for child in children(cursor):
            # What stands before the name belongs to the type of the result.
            if span(child)[0] > cursor.location.offset and (
                    child.kind in {Kind.COMPOUND_STMT, Kind.PARM_DECL} or is_expression(child)):
                self.visit(child, inner)

    def is_defaulted(self, cursor):
        """Whether what follows the name is `= default`; the extent need not hold that."""
        name, end = cursor.location.offset, len(self.source.text)
        ends = [at for at in (self.source.find(token, name, end) for token in "{;") if at]
        return self.source.find("= default", name, min(ends, default=end)) is not None

    def visit_variable(self, cursor, place):
        start, _ = span(cursor)
        initialiser = declaration_start(self.source, cursor)
        if initialiser is None:
            return
        in_class = cursor.semantic_parent is not None and cursor.semantic_parent.kind in CLASSES
        constant = self.source.find("constexpr", start, cursor.location.offset) is not None
        if constant and in_class:
            return
        if constant:
            self.variables.append(cursor)
        if cursor.kind == Kind.PARM_DECL:
            inner = replace(place, constant=True)
        elif place.in_function:
            inner = place
        else:
            inner = place.inside(cursor.spelling, in_class, False)
        name = cursor.location.offset
        for child in children(cursor):
            if is_expression(child) and (child.extent.start.offset >= initialiser or
                                         child.extent.start.offset == name):
                self.visit(child, inner.within(cursor))

    # -------------------------------------------------------------------------------- statements

    def visit_statement(self, cursor, place):
        kind = cursor.kind
        parts = children(cursor)
        if kind == Kind.CASE_STMT:
            parts = parts[1:]
        if kind in {Kind.COMPOUND_STMT, Kind.CASE_STMT, Kind.DEFAULT_STMT}:
            bodies = parts
        elif kind in {Kind.IF_STMT, Kind.FOR_STMT, Kind.WHILE_STMT, Kind.CXX_FOR_RANGE_STMT}:
            bodies = self.bodies(cursor, parts)
        elif kind == Kind.DO_STMT:
            bodies = parts[:1]
        else:
            bodies = []
        for body in bodies:
            self.add_deletion(body, place)
        if kind in {Kind.IF_STMT, Kind.WHILE_STMT}:
            if self.is_for_the_compiler(cursor, parts, len(bodies)):
                parts = parts[len(parts) - len(bodies):]
            else:
                self.add_negation(cursor, parts, len(bodies), place)
        for part in parts:
            self.visit(part, place.within(cursor))

    def bodies(self, cursor, parts):
        """The statements of an if or a loop: what stands after its closing parenthesis."""
        if cursor.kind != Kind.IF_STMT or len(parts) < 3:
            return parts[-1:]
        between = parts[-2].extent.end.offset, parts[-1].extent.start.offset
        return parts[-2:] if self.source.find("else", *between) is not None else parts[-1:]

    def add_deletion(self, cursor, place):
        start, end = span(cursor)
        jump = cursor.kind in JUMPS and not children(cursor)
        if not jump and not is_expression(cursor):
            return
        semicolon = self.source.find(";", end, len(self.source.text))
        self.add(cursor, place, 3, "SDL", [(start, end, "")],
                 [(start, start, "{{ if (!{}::is({})) "), (semicolon + 1, semicolon + 1, " }}")])

    def is_for_the_compiler(self, cursor, parts, bodies):
        """Whether it is an `if constexpr`: what it decides is done while compiling."""
        start, _ = span(cursor)
        condition = parts[-bodies - 1] if len(parts) > bodies else cursor
        end = condition.extent.start.offset
        return self.source.find("constexpr", start, end) is not None

    def add_negation(self, cursor, parts, bodies, place):
        if len(parts) <= bodies or any(p.kind == Kind.VAR_DECL for p in parts[:-bodies]):
            return
        self.negate(parts[-bodies - 1], place)

    def negate(self, condition, place):
        inner = unwrapped(condition)
        token = self.operator_of(inner)
        plain = inner.kind == Kind.CXX_BOOL_LITERAL_EXPR or self.source.of(inner).startswith("!")
        # A relation that is rewritten in terms of another keeps its own text.
        shallow = token and token[0] in ops.RELATIONS
        if plain or shallow or self.rewritten_relation(condition):
            return
        start, end = span(condition)
        self.add(condition, place, 2, "COI", [(start, end, f"!({self.source.of(condition)})")],
                 [(start, start, "(static_cast<bool>("), (end, end, ") != {}::is({}))")])

    def rewritten_relation(self, cursor):
        """`a < b` that means `(a <=> b) < 0`: the real operands are two levels down."""
        extent = span(cursor)
        stack = [cursor]
        while stack:
            node = stack.pop()
            token = self.operator_of(node)
            if span(node) == extent and token and token[0] in ops.RELATIONS:
                return True
            stack += [child for child in children(node) if span(child)[0] == extent[0]]
        return False

    # ------------------------------------------------------------------------------- expressions

    def visit_expression(self, cursor, place):
        kind = cursor.kind
        if kind == Kind.LAMBDA_EXPR:
            for child in children(cursor):
                if child.kind == Kind.COMPOUND_STMT:
                    self.visit(child, place)
            return
        if kind in {Kind.INTEGER_LITERAL, Kind.FLOATING_LITERAL, Kind.CXX_BOOL_LITERAL_EXPR}:
            self.add_literal(cursor, place)
            return
        if kind == Kind.DECL_REF_EXPR:
            self.references.add(span(cursor))
            return
        parts = children(cursor)
        if kind == Kind.MEMBER_REF_EXPR:
            parts = [p for p in parts if p.extent.end.offset <= cursor.location.offset]
        elif kind in CASTS:
            parts = parts[-1:]
        self.add_operators(cursor, parts, place)
        inner = place if kind == Kind.UNEXPOSED_EXPR else place.within(cursor)
        for part in parts:
            self.visit(part, inner)

    def add_operators(self, cursor, parts, place):
        kind = cursor.kind
        if kind == Kind.CONDITIONAL_OPERATOR:
            self.negate(parts[0], place)
        elif kind in {Kind.BINARY_OPERATOR, Kind.COMPOUND_ASSIGNMENT_OPERATOR}:
            self.add_binary(cursor, place)
        elif kind == Kind.UNARY_OPERATOR:
            self.add_unary(cursor, parts[0], place)
        elif kind == Kind.CALL_EXPR and cursor.spelling.startswith("operator"):
            if len(parts) == 3:
                self.add_binary(cursor, place)
            elif len(parts) == 2 and cursor.spelling in {"operator-", "operator!"}:
                self.add_unary(cursor, parts[1], place)
        elif kind == Kind.CALL_EXPR:
            self.add_call(cursor, parts, place)

    def operator_of(self, cursor):
        """(token, its offset, left, right) of an operator with two operands, or none."""
        parts = children(cursor)
        if cursor.kind in {Kind.BINARY_OPERATOR, Kind.COMPOUND_ASSIGNMENT_OPERATOR}:
            if len(parts) != 2:
                return None
            left, right = parts
        elif cursor.kind == Kind.CALL_EXPR and cursor.spelling.startswith("operator") and \
                len(parts) == 3:
            left, _, right = parts
        else:
            return None
        start, end = left.extent.end.offset, right.extent.start.offset
        if start > end:
            return None
        token = self.source.between(start, end).strip()
        if token not in ops.BINARY and token not in ops.ASSIGNMENT and token not in {"&&", "||"}:
            return None
        return token, self.source.find(token, start, end), left, right

    def add_binary(self, cursor, place):
        found = self.operator_of(cursor)
        if not found:
            return
        token, at, left, right = found
        start, end = span(cursor)
        after = at + len(token)
        if token in {"&&", "||"}:
            other = "||" if token == "&&" else "&&"
            self.add(cursor, place, 1, "COR", [(at, after, other)],
                     [(start, start, "(((static_cast<bool>("),
                      (at, after, f") != {{}}::is({{}})) {token} (static_cast<bool>("),
                      (end, end, ") != {}::is({}))) != {}::is({}))")])
            return
        entry = ops.BINARY.get(token) or ops.ASSIGNMENT.get(token)
        name, function, others = entry
        if token not in ops.RELATIONS and not self.has_arithmetic(token, left, right):
            return
        self.add(cursor, place, 1, name, [(at, after, other) for other in others],
                 [(start, start, f"{{}}::{function}({{}}, "), (at, after, ", "), (end, end, ")")])

    def has_arithmetic(self, token, left, right):
        if is_number(left) and is_number(right):
            return True
        if is_pointer(left) and is_number(right):
            return token in {"+", "-"}
        names = {type_name(left), type_name(right)}
        for name, tokens in ops.CLASS_ARITHMETIC.items():
            if name in names:
                return token in tokens
        return False

    def add_unary(self, cursor, operand, place):
        start, end = span(cursor)
        text = self.source.of(cursor)
        if operand.extent.start.offset <= start:  # i++, or a rewritten relation: != without its left
            return
        for token, (name, function, other) in ops.STEP.items():
            if not is_number(operand):
                continue
            if text.startswith(token):
                self.add(cursor, place, 1, name, [(start, start + 2, other)],
                         [(start, start + 2, f"{{}}::{function}({{}}, "), (end, end, ")")])
                return
        if text[:2] in ops.STEP or text[:1] not in ops.UNARY:
            return
        name, function = ops.UNARY[text[0]]
        self.add(cursor, place, 1, name, [(start, start + 1, "")],
                 [(start, start + 1, f"{{}}::{function}({{}}, "), (end, end, ")")])

    def add_call(self, cursor, parts, place):
        if not parts:
            return
        start, end = span(cursor)
        callee = self.source.of(parts[0])
        for text, (function, other) in ops.CALLED.items():
            if callee == text or callee.startswith(text + "<"):
                if function in {"Minimum", "Maximum"} and len(parts) != 3:
                    return
                self.add(cursor, place, 1, "FNR", [(start, start + len(text), other)],
                         [(start, start + len(text), f"{{}}::{function}<{{}}>::call")])
                return
        member = unwrapped(parts[0])
        if member.kind == Kind.MEMBER_REF_EXPR and len(parts) == 1 and \
                cursor.spelling in ops.MEMBERS and children(member):
            function, other = ops.MEMBERS[cursor.spelling]
            base = children(member)[0].extent.end.offset
            name = member.location.offset
            self.add(cursor, place, 1, "FNR", [(name, name + len(cursor.spelling), other)],
                     [(start, start, f"{{}}::{function}({{}}, "), (base, end, ")")])

    def add_literal(self, cursor, place):
        start, end = span(cursor)
        text = self.source.of(cursor)
        if text in {"true", "false"}:
            others = ["false" if text == "true" else "true"]
        elif NUMBER.match(text):
            number = int(text) if text.isdigit() and not text.startswith("00") else None
            others = [f"{text} + 1", f"{text} - 1"] if number is None else \
                [str(number + 1), str(number - 1)]
        else:
            return
        self.add(cursor, place, 0, "CRP", [(start, end, other) for other in others],
                 [(start, start, "{}::literal({}, "), (end, end, ")")],
                 shown=place.around)
