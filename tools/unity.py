# SPDX-License-Identifier: MIT
"""Which sources of a program or library may be compiled as one file: tools/unity.cmake asks.

    unity.py FOLDER SOURCE...

Writes FOLDER/unity_N.cpp, each of which includes some of the sources, and prints their names, one a
line. Most of a compiler's time goes to headers that many sources include and to templates that many
of them use, so several sources at once cost little more than one.

What a source keeps to itself, in a namespace without a name, another may call the same: in such a
namespace too, as a constant in a function, or in a header that it includes. Such two never share a
file; nor does a source that defines macros share one.
"""
import functools
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
MOST = 16
# All sources are formatted: what a namespace holds begins in the first column.
HIDDEN = re.compile(r"^namespace \{\n(.*?)^\}  // namespace$", re.MULTILINE | re.DOTALL)
STATEMENT = re.compile(r"^(?!using ::|template|static_assert|[A-Z_]+\()[\w:].*(?:\n .*)*", re.MULTILINE)
# A name stands before its value, size, parameters or body; a second one behind a comma.
DECLARED = re.compile(r"\b(\w+)(?:\[[^\]]*\])*(?= = |\(|\{| \{|;| : | final )")
FURTHER = re.compile(r", (k[A-Z]\w*) = ")
ENUMERATOR = re.compile(r"\bk[A-Z]\w*")
LOCAL = re.compile(r"^ +(?:static )?(?:constexpr|const) .*?\b(k[A-Z]\w*)", re.MULTILINE)
INCLUDED = re.compile(r'^#include "(.*)"', re.MULTILINE)
MACRO = re.compile(r"^#define ", re.MULTILINE)


def declared(text):
    """{name: the statement that declares it} of the text of a namespace."""
    found = {}
    for statement in STATEMENT.findall(text):
        names = DECLARED.findall(statement.split("\n")[0])[:1]
        names += FURTHER.findall(statement)
        if statement.startswith("enum "):
            names += ENUMERATOR.findall(statement)
        found.update(dict.fromkeys(names, statement))
    return found


@functools.cache
def of_header(path):
    """(the names that a header declares, the headers that it includes)"""
    text = path.read_text(encoding="utf-8")
    return set(declared(text)), headers(path, text)


def headers(path, text):
    """The project's own that are included, by their path from src/, the root or the file itself."""
    places = [[folder / name for folder in (ROOT / "src", ROOT, path.parent)]
              for name in INCLUDED.findall(text)]
    return {file for files in places for file in files if file.is_file()}


class Source:
    def __init__(self, path):
        text = path.read_text(encoding="utf-8")
        self.path = path
        self.hidden = {name: statement for part in HIDDEN.findall(text)
                       for name, statement in declared(part).items()}
        # What would be hidden or mistaken if another source called something so.
        self.known = set(LOCAL.findall(text))
        self.alone = MACRO.search(text) is not None
        waiting, seen = list(headers(path, text)), set()
        while waiting:
            header = waiting.pop()
            if header not in seen:
                seen.add(header)
                names, others = of_header(header)
                self.known |= names
                waiting += others


def clash(one, other):
    """Whether two sources must not share a file."""
    if one.alone or other.alone:
        return True
    if one.known & other.hidden.keys() or other.known & one.hidden.keys():
        return True
    # To say `using A = B;` or `namespace a = b;` twice is no clash.
    return any(one.hidden[name] != other.hidden[name] or
               not one.hidden[name].startswith(("using ", "namespace "))
               for name in one.hidden.keys() & other.hidden.keys())


def batches(paths):
    """[paths that one file includes]. Those that clash with most others are placed first, each in
    the first batch that has room for it, so that few batches do."""
    sources = [Source(path) for path in paths]
    clashes = {source.path: {other.path for other in sources
                             if other is not source and clash(source, other)}
               for source in sources}
    found = []
    for path in sorted(paths, key=lambda path: -len(clashes[path])):
        batch = next((batch for batch in found
                      if len(batch) < MOST and clashes[path].isdisjoint(batch)), None)
        if batch is None:
            batch = []
            found.append(batch)
        batch.append(path)
    return found


def main(folder, *sources):
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    for number, batch in enumerate(batches([Path(source) for source in sources])):
        file = folder / f"unity_{number}.cpp"
        text = "".join(f'#include "{source}"\n' for source in batch)
        # What has not changed is not compiled again.
        if not file.exists() or file.read_text(encoding="utf-8") != text:
            file.write_text(text, encoding="utf-8")
        print(file)


if __name__ == "__main__":
    main(*sys.argv[1:])
