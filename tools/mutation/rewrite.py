# SPDX-License-Identifier: MIT
"""The mutated text of a file: every site calls its switch, everything else stays as it is."""

import re

from mutation.source import FUNCTIONS, span

ROOM = "edgecase_mutation"


def mutated_text(source, sites, variables):
    """The text with all edits of the numbered sites. At one place, what closes an inner site comes
    before what closes an outer one, then opens outer before inner, then goes the token itself."""
    edits = []
    for site in sites:
        switch = f"{ROOM}::{'Constant' if site.constant else 'Runtime'}"
        for start, end, text in site.edits:
            edits.append(edit_of(site, start, end, with_switch(text, switch, site.number)))
    for cursor in variables:
        edits += variable_edits(source, sites, cursor)
    edits.sort(key=lambda edit: edit[0])
    result, at = [], 0
    for (start, *_), end, text in edits:
        result.append(source.text[at:start])
        result.append(text.encode())
        at = max(at, start)
        if end > start:
            at = end
    result.append(source.text[at:])
    return b"".join(result)


def with_switch(text, switch, number):
    """Fills `{}`: the switch's class and the number, alternately."""
    parts = [switch, str(number)]
    filled, count = [], 0
    for piece in re.split(r"(\{\{|\}\}|\{\})", text):
        if piece == "{}":
            piece = parts[count % 2]
            count += 1
        filled.append({"{{": "{", "}}": "}"}.get(piece, piece))
    return "".join(filled)


def edit_of(site, start, end, text):
    """((sort key), end, text). Key: place, what it does there, nesting."""
    if start == end and start >= site.end:
        return (start, 0, -site.start, site.rank, 0), end, text
    if start == site.start:
        return (start, 1, -site.end, -site.rank, 0), end, text
    return (start, 2, 0, 0, 0), end, text


def variable_edits(source, sites, cursor):
    """A constant that has sites must be computed when the program runs. `const` would not do: the
    compiler computes what it can of a constant's initialiser, and takes no mutant there."""
    start, end = span(cursor)
    if not any(start <= site.start and site.end <= end for site in sites):
        return []
    word = source.find("constexpr", start, cursor.location.offset)
    local = cursor.semantic_parent.kind in FUNCTIONS
    return [((word, 2, 0, 0, 0), word + len("constexpr"), "" if local else "static")]
