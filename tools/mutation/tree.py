# SPDX-License-Identifier: MIT
"""All mutants of a set of files, numbered, and a copy of the repository that holds them."""

from collections import Counter
from dataclasses import dataclass

from mutation.arguments import NOTHING, joined
from mutation.rewrite import mutated_text
from mutation.sites import Finder
from mutation.source import Source


@dataclass(frozen=True)
class Mutant:
    number: int
    file: str
    line: int
    operator: str
    function: str
    site: str           # the source text, spaces joined
    replacement: str    # what it becomes
    nth: int            # among equals in the function, from 1

    @property
    def key(self):
        return self.file, self.function, self.site, self.replacement, self.nth

    def __str__(self):
        nth = f" (no. {self.nth})" if self.nth > 1 else ""
        return (f"{self.number:5} {self.file}:{self.line} {self.operator} in {self.function}: "
                f"{self.site}{nth}  ->  {self.replacement or NOTHING}")


def mutants_of(source, file, sites, first):
    """The mutants of a file's sites; numbers them from `first`."""
    mutants, seen = [], Counter()
    for site in sites:
        site.number = first + len(mutants)
        start, end = site.shown
        shown = joined(source.between(start, end))
        for at, to, text in site.replacements:
            changed = joined(source.between(start, at) + text + source.between(to, end))
            same = (site.function, shown, changed)
            seen[same] += 1
            mutants.append(Mutant(first + len(mutants), file, source.line(at), site.operator,
                                  site.function, shown, changed, seen[same]))
    return mutants


def source_files(root, folders):
    return sorted(path for folder in folders for path in (root / folder).rglob("*")
                  if path.suffix in {".cpp", ".h"})


def mutate_files(root, files, first=1):
    """(mutants, {path relative to the root: mutated text})."""
    mutants, texts = [], {}
    for path in files:
        file = path.relative_to(root).as_posix()
        source = Source(path, [root / "src", root])
        finder = Finder(source)
        sites = finder.find()
        mutants += mutants_of(source, file, sites, first + len(mutants))
        texts[file] = mutated_text(source, sites, finder.variables)
    return mutants, texts


def write_changed(path, content):
    """Writes a file only when it changes, so that nothing is compiled in vain."""
    if path.exists() and path.read_bytes() == content:
        return
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(content)


def copy_tree(root, into, texts, copied):
    """Copies the repository's sources into a folder, mutated files in place of the originals;
    removes what the repository no longer has."""
    wanted = set()
    for name in copied:
        for path in [root / name, *sorted((root / name).rglob("*"))]:
            if not path.is_file() or "__pycache__" in path.parts:
                continue
            file = path.relative_to(root).as_posix()
            wanted.add(file)
            write_changed(into / file, texts[file] if file in texts else path.read_bytes())
    for path in into.rglob("*"):
        if path.is_file() and path.relative_to(into).as_posix() not in wanted:
            path.unlink()
