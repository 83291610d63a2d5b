# SPDX-License-Identifier: MIT
"""Writes the essays on top of the rules' headers as C++ source (see chapters.h).

Usage: embed_essays.py OUTPUT.cpp HEADER.h...

An essay is the comment between a header's licence line and its first line of code. A header is
named by its path below the folder of this file, without suffix: coverage/snap.
"""
import pathlib
import re
import sys

OPENING = re.compile(r"// SPDX-License-Identifier: MIT\n//\n((?://[^\n]*\n)+)")
DELIMITER = "essay"


def essay_of(path):
    opening = OPENING.match(path.read_text(encoding="utf-8"))
    if not opening:
        sys.exit(f"embed_essays.py: {path} has no essay below its licence line")
    essay = "".join(re.sub(r"^// ?", "", line) for line in opening[1].splitlines(keepends=True))
    if f'){DELIMITER}"' in essay:
        sys.exit(f"embed_essays.py: the essay of {path} would end its own string")
    return essay


def main():
    output, *headers = sys.argv[1:]
    folder = pathlib.Path(__file__).resolve().parent
    entries = []
    for header in headers:
        path = folder / f"{header}.h"
        entries.append(f'    {{"{header}",\n     R"{DELIMITER}({essay_of(path)}){DELIMITER}"}},\n')
    pathlib.Path(output).write_text(
        '// Made by embed_essays.py.\n#include "rules/chapters.h"\n\n#include <map>\n\n'
        "namespace edgecase {\n\nstd::string_view essay_of(const Section& section) {\n"
        "  static const std::map<std::string_view, std::string_view> essays = {\n"
        f"{''.join(entries)}  }};\n"
        "  return essays.at(section.header);\n}\n\n}  // namespace edgecase\n",
        encoding="utf-8",
    )


main()
