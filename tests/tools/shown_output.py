# SPDX-License-Identifier: MIT
"""What documents show of a command's output, held against what it prints (documents_test.py).

Lines stand in their order, and `…` stands for anything. The first line of a run's summary tells how
many cases the whole suite has; the run that it is compared with has a few cases and takes another
time.
"""
import re

# The first line of a run's summary: the number of cases, what is said of them, and the seconds.
FIRST_LINE = re.compile(r"^([\d,]+)( cases?, .*?, )(?:[\d,]+ answers? as before, )?\d+(?:\.\d)? s$",
                        re.MULTILINE)


def is_in_order(pieces, text):
    """Whether the pieces occur in the text one behind the other."""
    for piece in pieces:
        _, found, text = text.partition(piece)
        if not found and piece:
            return False
    return True


def shown_pieces(output):
    """What of an output that a document shows is compared: all but `…`."""
    lines = output.splitlines(keepends=True)
    return [piece for line in lines for piece in line.split("…") if piece.strip()]


def without_seconds(text):
    """The text, with N for the seconds of a summary's first line."""
    return FIRST_LINE.sub(r"\1\2N s", text)


def of_few_cases(output, few, whole):
    """What a document shows of the whole suite, as a run of a few cases prints it, without seconds.
    A number of cases other than the suite's is marked as wrong, so that no output holds it."""
    return FIRST_LINE.sub(lambda line: f"{few if line[1] == whole else f'wrong: {line[1]}'}"
                                       f"{line[2]}N s", output)
