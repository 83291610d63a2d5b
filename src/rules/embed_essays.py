# SPDX-License-Identifier: MIT
"""Writes the essays on top of the rules' headers as C++ source (see chapters.h).

Usage: embed_essays.py OUTPUT.cpp HEADER.h...

An essay is the comment between a header's licence line and its first line of code. Where a header
holds the rules of several sections, their essays are the comments that begin with a line
"// Essay: TITLE OF THE SECTION", and the one on top is none. A header is named by its path below the
folder of this file, without suffix: coverage/snap.
"""
import pathlib
import re
import sys

OPENING = re.compile(r"// SPDX-License-Identifier: MIT\n//\n((?://[^\n]*\n)+)")
TITLED = re.compile(r"^// Essay: ([^\n]+)\n//\n((?://[^\n]*\n)+)", re.MULTILINE)
DELIMITER = "essay"


def essays_of(path):
    """(title, essay) of each; of the only one the title is empty."""
    text = path.read_text(encoding="utf-8")
    opening = OPENING.match(text)
    if not opening:
        sys.exit(f"embed_essays.py: {path} has no essay below its licence line")
    for title, comment in TITLED.findall(text) or [("", opening[1])]:
        essay = "".join(re.sub(r"^// ?", "", line) for line in comment.splitlines(keepends=True))
        if f'){DELIMITER}"' in essay:
            sys.exit(f"embed_essays.py: an essay of {path} would end its own string")
        yield title, essay


def main():
    output, *headers = sys.argv[1:]
    folder = pathlib.Path(__file__).resolve().parent
    entries = []
    for header in headers:
        for title, essay in essays_of(folder / f"{header}.h"):
            entries.append(
                f'    {{{{"{header}", "{title}"}},\n     R"{DELIMITER}({essay}){DELIMITER}"}},\n')
    pathlib.Path(output).write_text(
        '// Made by embed_essays.py.\n#include "rules/chapters.h"\n\n#include <map>\n\n'
        "namespace edgecase {\n\nstd::string_view essay_of(const Section& section) {\n"
        "  using Key = std::pair<std::string_view, std::string_view>;\n"
        "  static const std::map<Key, std::string_view> essays = {\n"
        f"{''.join(entries)}  }};\n"
        '  const auto only = essays.find({section.header, ""});\n'
        "  return only != essays.end() ? only->second\n"
        "                              : essays.at({section.header, section.title});\n"
        "}\n\n}  // namespace edgecase\n",
        encoding="utf-8",
    )


main()
