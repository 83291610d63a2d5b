# SPDX-License-Identifier: MIT
"""The score: per file and per operator, as a table for people."""

from collections import Counter
from dataclasses import dataclass


@dataclass(frozen=True)
class Row:
    name: str
    mutants: int
    killed: int
    equivalent: int

    @property
    def survived(self):
        return self.mutants - self.killed - self.equivalent

    @property
    def score(self):
        counted = self.mutants - self.equivalent
        # Rounded down: 100.0 means all.
        return f"{self.killed * 1000 // counted / 10:.1f} %" if counted else "-"

    def cells(self):
        return [self.name, *map(str, (self.mutants, self.killed, self.survived, self.equivalent)),
                self.score]


HEAD = ["", "mutants", "killed", "survived", "equivalent", "score"]


def rows_by(outcomes, arguments, name_of):
    """A row for each name, sorted, and the total."""
    mutants, killed, equivalent = Counter(), Counter(), Counter()
    for outcome in outcomes:
        for name in (name_of(outcome.mutant), "total"):
            mutants[name] += 1
            killed[name] += outcome.killed
            equivalent[name] += not outcome.killed and outcome.mutant.key in arguments
    names = sorted(set(mutants) - {"total"}) + ["total"]
    return [Row(name, mutants[name], killed[name], equivalent[name]) for name in names]


def as_text(rows, title):
    lines = [[title, *HEAD[1:]], *[row.cells() for row in rows]]
    widths = [max(len(line[i]) for line in lines) for i in range(len(HEAD))]
    return "\n".join(
        line[0].ljust(widths[0]) + "".join(f"  {cell:>{width}}" for cell, width in
                                           zip(line[1:], widths[1:])) for line in lines)
