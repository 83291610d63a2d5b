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
MOST = 8
# All sources are formatted: what a namespace holds begins in the first column.
HIDDEN = re.compile(r"^namespace \{\n(.*?)^\}  // namespace$", re.MULTILINE | re.DOTALL)
STATEMENT = re.compile(r"^(?!using ::|template|[A-Z_]+\()[\w:].*(?:\n .*)*", re.MULTILINE)
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


class Batch:
    """Sources that one file includes."""

    def __init__(self):
        self.sources = []
        self.hidden = {}
        self.known = set()

    def has_room_for(self, source):
        if not self.sources:
            return True
        if source.alone or self.sources[0].alone or len(self.sources) == MOST:
            return False
        if self.known & source.hidden.keys() or source.known & self.hidden.keys():
            return False
        # To say `using A = B;` twice is no clash.
        return all(source.hidden[name] == self.hidden[name] and
                   source.hidden[name].startswith("using ")
                   for name in self.hidden.keys() & source.hidden.keys())

    def add(self, source):
        self.sources.append(source)
        self.hidden.update(source.hidden)
        self.known |= source.known


def batches(paths):
    """[paths that one file includes], each path in the first that has room for it."""
    found = []
    for source in map(Source, paths):
        batch = next((batch for batch in found if batch.has_room_for(source)), None)
        if batch is None:
            batch = Batch()
            found.append(batch)
        batch.add(source)
    return [[source.path for source in batch.sources] for batch in found]


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
