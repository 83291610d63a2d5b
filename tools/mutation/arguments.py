# SPDX-License-Identifier: MIT
"""Survivors that are argued equivalent in writing: tests/mutation/equivalent.txt.

Mutants stand there as `tools/mutate --list` prints them, without numbers of lines, so that an entry
holds until the code itself changes:

    FILE in FUNCTION:
      SITE  ->  REPLACEMENT
      SITE (no. 2)  ->  REPLACEMENT
        A sentence why no test can notice these mutants.
"""

import re

HEAD = re.compile(r"(\S+) in (.+):")
MUTANT = re.compile(r"  (\S.*?)(?: \(no\. (\d+)\))?  ->  (\S.*)")
REASON = re.compile(r"    (\S+(?: \S+){4,})")
NOTHING = "(nothing)"  # what stands for an empty replacement


class ArgumentError(Exception):
    """The file of arguments is malformed."""


def joined(text):
    """One line, without comments."""
    return " ".join(re.sub(r"//[^\n]*", "", text).split())


def load(path):
    """{mutant's key: why}"""
    arguments, place, unargued = {}, None, []  # unargued: no sentence came yet
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        head, mutant, reason = (form.fullmatch(line) for form in (HEAD, MUTANT, REASON))
        if head and not unargued:
            place = head.groups()
        elif mutant and place:
            site, nth, replacement = mutant.groups()
            unargued.append((*place, site, "" if replacement == NOTHING else replacement,
                              int(nth or 1)))
        elif reason and unargued:
            for key in unargued:
                if key in arguments:
                    raise ArgumentError(f"{path}:{number}: twice: {' | '.join(map(str, key))}")
                arguments[key] = reason[1]
            unargued = []
        else:
            raise ArgumentError(f"{path}:{number}: this needs FILE in FUNCTION:, mutants below it, "
                                f"and a sentence below those: {line}")
    if unargued:
        raise ArgumentError(f"{path}: the last mutants have no sentence")
    return arguments


def gone(arguments, root):
    """Sentences about arguments whose file, function or text is no more. A quick look that needs no
    compiler: faults() tells for certain."""
    texts = {}
    for file, function, site, replacement, nth in arguments:
        if file not in texts:
            path = root / file
            texts[file] = joined(path.read_text(encoding="utf-8")) if path.is_file() else ""
        if site not in texts[file] or function.split("::")[-1] not in texts[file]:
            yield f"stale argument, no such text: {file} in {function}: {site}"


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
