# SPDX-License-Identifier: MIT
"""Comments and pages name files that there are.

A path counts if it starts with a folder of the root or of src, and ends like a file of ours or lies
in a folder that there is: `tests/oracles/support.cpp`, `diff/judge.h`, `rules/coverage/window`. It
may be meant from the root, from src, or from the folder of the file that names it. Blocks of pages
are left out, since documents_test.py runs them, and so are NAMES/IN/CAPITALS.

    python3 paths.py ROOT      prints each path that leads nowhere as FILE:LINE: PATH; exit code 1
                               if any
"""

import re
import sys
from pathlib import Path

ROOTS = ("cases", "reference", "reports", "src", "tests", "tools")
ENDINGS = ("h", "cpp", "py", "js", "css", "html", "md", "cmake", "json", "txt")
IGNORED = {"__pycache__", "node_modules"}

C_COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.DOTALL)
HASH_COMMENT = re.compile(r"(?<!\S)# [^\n]*")
# A text at the start of a line documents its module, class or function; another is no comment.
PYTHON_COMMENT = re.compile(r'(?<!\S)# [^\n]*|^ *""".*?"""|(?P<other>""".*?""")',
                            re.DOTALL | re.MULTILINE)
PROSE = re.compile(r"(?:\A|^```$)(?:(?!^```).)*", re.DOTALL | re.MULTILINE)
COMMENT = {".h": C_COMMENT, ".cpp": C_COMMENT, ".js": C_COMMENT, ".css": C_COMMENT,
           ".py": PYTHON_COMMENT, "": PYTHON_COMMENT, ".txt": HASH_COMMENT, ".cmake": HASH_COMMENT,
           ".yml": HASH_COMMENT, ".sbatch": HASH_COMMENT, ".md": PROSE}

PATH = re.compile(r"(?<![\w./:<>$*{}…-])(?<!Save this as `)((?:[\w-]+/)+[\w.-]*\w)")
PLACEHOLDER = re.compile(r"\b[A-Z]{2,}\b(?!\.(md|txt)\b)")


def files_of(root):
    """The files whose comments are read."""
    inner = (path for folder in ROOTS for path in (root / folder).rglob("*"))
    for path in sorted([*root.iterdir(), *inner]):
        if not path.is_file() or path.suffix not in COMMENT or IGNORED & set(path.parts):
            continue
        if path.suffix == ".txt" and path.name != "CMakeLists.txt":
            continue
        if path.suffix == "" and path.read_bytes()[:2] != b"#!":
            continue
        yield path


def named(root, text, comment):
    """(position, path) of each path in the comments that claims to be one of ours."""
    starts = {*ROOTS, *(path.name for path in (root / "src").iterdir() if path.is_dir())}
    for part in comment.finditer(text):
        if part.lastgroup == "other":
            continue
        for match in PATH.finditer(part.group()):
            words = match[1].split("/")
            if words[0] not in starts or PLACEHOLDER.search(match[1]):
                continue
            folder = "/".join(words[:-1])
            known = len(words) > 2 and any((top / folder).is_dir() for top in (root, root / "src"))
            if words[-1].rpartition(".")[2] in ENDINGS if "." in words[-1] else known:
                yield part.start() + match.start(), match[1]


def leads_somewhere(root, file, path):
    for top in (root, root / "src", file.parent):
        target = top / path
        if target.exists() or (not target.suffix and any(
                target.with_suffix("." + ending).exists() for ending in ENDINGS)):
            return True
    return False


def check(root):
    """(file, line, path) of each path that leads nowhere, and how many were followed."""
    lost, count = [], 0
    for file in files_of(root):
        text = file.read_text(encoding="utf-8")
        for position, path in named(root, text, COMMENT[file.suffix]):
            count += 1
            if not leads_somewhere(root, file, path):
                lost.append((file.relative_to(root), text.count("\n", 0, position) + 1, path))
    return lost, count


def main():
    lost, count = check(Path(sys.argv[1]).resolve())
    for file, line, path in lost:
        print(f"{file}:{line}: there is no {path}")
    print(f"{count} paths, {len(lost)} lead nowhere")
    return 1 if lost or not count else 0


if __name__ == "__main__":
    sys.exit(main())
