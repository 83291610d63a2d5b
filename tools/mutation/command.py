# SPDX-License-Identifier: MIT
"""The command line of tools/mutate."""

import argparse
import hashlib
import sys
import time
from pathlib import Path

from mutation import arguments as argued
from mutation import score
from mutation.project import ROOT, BuildError, edgecase, processors
from mutation.record import UnmutatedFailure, record
from mutation.source import SourceError
from mutation.trial import Trial
from share import in_share

ARGUMENTS = ROOT / "tests/mutation/equivalent.txt"


def parser():
    result = argparse.ArgumentParser(
        prog="tools/mutate", description="Makes small faults in src/exact, src/rules and "
        "src/raster, one at a time, says which of them no test notices, and prints the score: "
        "how many tests notice, of those that are not argued equivalent.",
        epilog="Exit codes: 0 every survivor is argued equivalent, 1 one is not or an argument is "
        "stale, 2 usage, 3 the mutated copy cannot be built or fails without a mutant.")
    result.add_argument("--sample", type=int, metavar="N", help="only N mutants, drawn by chance")
    result.add_argument("--seed", type=int, default=1, metavar="S", help="of the sample")
    result.add_argument("--share", metavar="I/N", default="1/16",
                        help="how much of their scenes tests ask (1/16, as the quick tier); 1/1: all")
    result.add_argument("--file", action="append", metavar="PATH",
                        help="only mutants of files whose path holds this; may be repeated")
    result.add_argument("--jobs", type=int, default=processors(), metavar="N",
                        help="processes at a time (the number of processors)")
    result.add_argument("--unkilled", action="store_true",
                        help="only those that no earlier run in the build folder killed")
    result.add_argument("--report", type=Path, metavar="FILE",
                        help="write each mutant and what killed it")
    result.add_argument("--list", action="store_true", help="print the mutants and run nothing")
    result.add_argument("--build", type=Path, default=ROOT / "build/mutate", metavar="DIR",
                        help="where the mutated copy is built")
    return result


def lot(mutant, seed):
    """What the mutant draws. By its own text alone: a change of other code leaves a sample as it is,
    so that what a sample finds is news of the change."""
    return hashlib.sha256(repr((seed, mutant.key)).encode()).digest()


def selected(mutants, options):
    chosen = [m for m in mutants if not options.file or any(f in m.file for f in options.file)]
    if options.sample is not None and options.sample < len(chosen):
        chosen = sorted(chosen, key=lambda mutant: lot(mutant, options.seed))[:options.sample]
        chosen.sort(key=lambda mutant: mutant.number)
    # A part of the test that plants a sample plants its share.
    return in_share(chosen)


class Progress:
    """Writes each outcome to the report as it comes, and shows how far the run is where someone
    looks on."""

    def __init__(self, total, arguments, report):
        self.total, self.arguments = total, arguments
        self.report = report.open("w", encoding="utf-8") if report else None
        self.done = self.survived = 0
        self.started = time.monotonic()

    def __call__(self, outcome):
        self.done += 1
        self.survived += not outcome.killed
        if self.report:
            print(outcome.mutant, f"      {fate(outcome, self.arguments)}", sep="\n",
                  file=self.report, flush=True)
        if sys.stderr.isatty():
            rate = self.done / (time.monotonic() - self.started)
            print(f"\r{self.done}/{self.total}, {self.survived} survive, {rate:.1f} a second ",
                  end="" if self.done < self.total else "\n", file=sys.stderr, flush=True)


def fate(outcome, arguments):
    if outcome.killed:
        return f"killed by {outcome.killer}" + (", endless" if outcome.endless else "")
    if outcome.mutant.key in arguments:
        return "equivalent: " + arguments[outcome.mutant.key]
    return "survived" if outcome.reached else "not reached"


def run(options):
    project = edgecase(options.build.resolve(), options.share)
    mutants, texts = project.mutate()
    chosen = selected(mutants, options)
    if options.list:
        print("\n".join(map(str, chosen)))
        return 0
    if not chosen:
        print("tools/mutate: no mutant is selected", file=sys.stderr)
        return 2
    arguments = argued.load(ARGUMENTS)
    stale = list(argued.faults(arguments, mutants, []))
    if stale:  # said before anything is built
        print("\n".join(stale))
        return 1
    project.make(texts, options.jobs)
    tests = record(project, options.jobs)
    trial = Trial(project, tests)
    if options.unkilled:
        chosen = [mutant for mutant in chosen if not trial.was_killed(mutant)]
    outcomes = trial.run(chosen, options.jobs,
                         Progress(len(chosen), arguments, options.report))
    print(score.as_text(score.rows_by(outcomes, arguments, lambda m: m.file), "file"))
    print()
    print(score.as_text(score.rows_by(outcomes, arguments, lambda m: m.operator), "operator"))
    faults = list(argued.faults(arguments, mutants, outcomes))
    for fault in faults:
        print(fault)
    return 1 if faults else 0


def main():
    options = parser().parse_args()
    try:
        return run(options)
    except (BuildError, SourceError, UnmutatedFailure, argued.ArgumentError) as error:
        print(f"tools/mutate: {error}", file=sys.stderr)
        return 3
