# SPDX-License-Identifier: MIT
"""A source file and its syntax tree: places are offsets in bytes, as libclang has them."""

import re

from clang import cindex
from clang.cindex import CursorKind as Kind
from clang.cindex import TypeKind

WRAPPERS = {Kind.UNEXPOSED_EXPR, Kind.PAREN_EXPR}
FUNCTIONS = {Kind.FUNCTION_DECL, Kind.CXX_METHOD, Kind.CONSTRUCTOR, Kind.DESTRUCTOR,
             Kind.CONVERSION_FUNCTION, Kind.FUNCTION_TEMPLATE}
CLASSES = {Kind.CLASS_DECL, Kind.STRUCT_DECL, Kind.CLASS_TEMPLATE}
NUMBERS = {TypeKind.CHAR_U, TypeKind.UCHAR, TypeKind.USHORT, TypeKind.UINT, TypeKind.ULONG,
           TypeKind.ULONGLONG, TypeKind.UINT128, TypeKind.CHAR_S, TypeKind.SCHAR, TypeKind.SHORT,
           TypeKind.INT, TypeKind.LONG, TypeKind.LONGLONG, TypeKind.INT128, TypeKind.FLOAT,
           TypeKind.DOUBLE, TypeKind.LONGDOUBLE}


class SourceError(Exception):
    """The file cannot be parsed."""


class Source:
    """The text of one file, and the root of its tree."""

    def __init__(self, path, include_folders):
        self.path = path
        self.text = path.read_bytes()
        arguments = ["-x", "c++", "-std=c++20", "-Wno-pragma-once-outside-header"]
        arguments += [f"-I{folder}" for folder in include_folders]
        unit = cindex.Index.create().parse(str(path), args=arguments)
        errors = [d for d in unit.diagnostics if d.severity >= cindex.Diagnostic.Error]
        if errors:
            raise SourceError(f"{path}: {errors[0]}")
        self.unit = unit  # it keeps the cursors alive
        self.root = unit.cursor

    def holds(self, cursor):
        file = cursor.extent.start.file
        return file is not None and file.name == str(self.path)

    def between(self, start, end):
        return self.text[start:end].decode("utf-8")

    def of(self, cursor):
        return self.between(*span(cursor))

    def line(self, offset):
        return self.text.count(b"\n", 0, offset) + 1

    def find(self, wanted, start, end):
        """The offset of a token between two places, comments left out; none when it is not there."""
        part = re.sub(rb"//[^\n]*|/\*.*?\*/", lambda m: b" " * len(m.group()),
                      self.text[start:end], flags=re.DOTALL)
        at = part.find(wanted.encode())
        return start + at if at >= 0 else None


def span(cursor):
    return cursor.extent.start.offset, cursor.extent.end.offset


def children(cursor):
    return list(cursor.get_children())


def is_expression(cursor):
    return cursor.kind.is_expression()


def unwrapped(cursor):
    """The expression without the implicit conversions and parentheses round it."""
    while cursor.kind in WRAPPERS:
        inner = [child for child in children(cursor) if is_expression(child)]
        if len(inner) != 1:
            break
        cursor = inner[0]
    return cursor


def type_name(cursor):
    name = unwrapped_type(cursor).spelling
    return name.removeprefix("const ").removesuffix(" &").strip()


def unwrapped_type(cursor):
    kind = cursor.type.get_canonical()
    if kind.kind in {TypeKind.LVALUEREFERENCE, TypeKind.RVALUEREFERENCE}:
        kind = kind.get_pointee().get_canonical()
    return kind


def is_number(cursor):
    return unwrapped_type(cursor).kind in NUMBERS


def is_pointer(cursor):
    return unwrapped_type(cursor).kind == TypeKind.POINTER


def declaration_start(source, cursor):
    """Where the initialiser of a variable, field or parameter starts; none when it has none."""
    at = cursor.location.offset + len(cursor.spelling.encode())
    end = cursor.extent.end.offset
    while at < end:
        character = source.text[at:at + 1]
        if character in b" \n\t":
            at += 1
        elif character == b"[":
            at = source.text.index(b"]", at) + 1
        else:
            return at if character in b"={(" else None
    return None
