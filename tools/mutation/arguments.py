# SPDX-License-Identifier: MIT
"""Survivors that are argued equivalent in writing: tests/mutation/equivalent.json.

A list of {"file", "function", "site", "replacement", "nth", "why"}: the mutant by its source text,
spaces joined, as `tools/mutate --list` prints it; "nth" only where the same text occurs again in
the function. No line numbers, so that an entry holds until the code itself changes.
"""

import json


class ArgumentError(Exception):
    """The file of arguments is malformed."""


def load(path):
    """{mutant's key: why}"""
    entries = json.loads(path.read_text(encoding="utf-8")) if path.exists() else []
    arguments = {}
    for entry in entries:
        extra = set(entry) - {"file", "function", "site", "replacement", "nth", "why"}
        if extra or len(entry.get("why", "").split()) < 5:
            raise ArgumentError(f"{path}: an entry needs file, function, site, replacement and a "
                                f"sentence why, and nothing else: {entry}")
        key = (entry["file"], entry["function"], entry["site"], entry["replacement"],
               entry.get("nth", 1))
        if key in arguments:
            raise ArgumentError(f"{path}: twice: {entry}")
        arguments[key] = entry["why"]
    return arguments


def faults(arguments, mutants, outcomes):
    """Sentences about survivors without an argument, and arguments that hold for nothing."""
    known = {mutant.key for mutant in mutants}
    for key in arguments:
        if key not in known:
            yield f"stale argument, no such mutant: {' | '.join(map(str, key))}"
    for outcome in outcomes:
        argued = outcome.mutant.key in arguments
        if outcome.killed and argued:
            yield f"stale argument, killed by {outcome.killer}: {outcome.mutant}"
        if not outcome.killed and not argued:
            where = "survives" if outcome.reached else "is reached by no test"
            yield f"{where}: {outcome.mutant}"
