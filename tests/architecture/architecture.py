# SPDX-License-Identifier: MIT
"""What CONTRIBUTING.md says of the architecture, held against the files.

Modules use one another in one direction only; each library stays with the modules that need it;
coverage is decided in integers; no file grows too long. Reads the files as text: includes, and
words outside comments and strings. It does not build anything, and knows no preprocessor.

    python3 architecture.py ROOT      prints each fault as FILE:LINE: sentence; exit code 1 if any
"""

import re
import sys
from pathlib import Path

SRC = {"base", "exact", "model", "rules", "kernels", "raster", "casefile", "wire", "recording", "image",
       "diff", "results", "processes", "suite", "run", "generate", "profile", "search"}

# module -> modules that it may include, besides itself.
ALLOWED = {
    "base": set(),
    "exact": set(),
    "model": {"base", "exact"},
    "rules": {"model", "exact"},
    "kernels": {"rules", "exact"},
    "raster": {"kernels", "rules", "model", "exact"},
    "casefile": {"model", "exact", "image"},
    "wire": {"model", "exact"},
    "recording": {"wire", "model", "exact"},
    "image": {"model", "exact"},
    "diff": {"raster", "rules", "model", "exact"},
    "results": {"wire", "rules", "model", "base"},
    "processes": {"casefile", "wire", "model", "exact"},
    "suite": {"casefile", "results", "raster", "rules", "wire", "model", "exact", "base"},
    "run": SRC - {"generate", "profile", "search"},
    "generate": {"casefile", "model", "exact"},
    "profile": SRC,
    "search": SRC,
    "reference": {"model", "wire", "exact"},
    "examples": set(),  # reference/examples: programs of people who have nothing of ours
    "reports": {"results", "rules", "model", "image", "base"},
    "tools": SRC | {"reference", "reports"},
    "edgecase_gtest": SRC | {"reports", "tools"},  # tools/edgecase_gtest
}

# The folders within a module, lowest first; "" is its top. Each may include from those before it.
ROOMS = {
    "casefile": ("json", "mesh", "scene", "sweep", ""),
    "diff": ("findings", "coverage", "values", "output", "samples", "textures", ""),
}

# A library's headers -> modules that may include them.
LIBRARIES = [
    (r"nlohmann/", {"casefile", "wire", "recording", "results", "profile", "search", "reports",
                    "tools", "examples"}),
    (r"OpenImageIO/", {"image"}),
    (r"(GL|EGL|KHR|GLES\d?|glad)/", {"reference"}),
    (r"hwy/", {"exact", "kernels"}),
    (r"glm/", {"casefile"}),
    (r"tiny_obj_loader", {"casefile"}),
    (r"boost/multiprecision/", {"exact"}),
    (r"pugixml", {"reports"}),
    (r"CLI/", {"tools", "edgecase_gtest"}),
    (r"toml\+\+/", {"tools"}),
    (r"gtest/", {"edgecase_gtest"}),
    (r"gmock/", set()),
]

# Functions of otherwise integer files that may compute in floating point, since nothing is decided
# by what they yield: "people" format a number for a sentence and say "for people only" above, in
# "figure" positions of a drawing are computed.
FLOATING = {
    "src/exact/fixed.h": {"to_double": "figure"},
    "src/rules/coverage/diamond_exit.cpp": {"manhattan_distance": "people",
                                            "explain_line": "figure"},
    "src/rules/coverage/point_ownership.cpp": {"explain_point": "figure"},
    "src/rules/coverage/triangle_fill.cpp": {"distance_inside": "people"},
}
FLOATING_FILES = {"src/exact/elementary.h", "src/exact/interval.h", "src/exact/interval_lanes.h",
                  "src/exact/interval_lanes.cpp", "src/exact/rational.h", "src/kernels/color_planes.h",
                  "src/kernels/color_planes.cpp", "src/kernels/smooth_fill_kernel.cpp",
                  "src/kernels/textured_fill_kernel.cpp", "src/kernels/code_words-inl.h"}

INTEGER_FOLDERS = ("src/exact/", "src/rules/coverage/", "src/kernels/")

MAX_LINES = 600
CODE = {".h", ".cpp", ".js", ".py"}
# Put together here, so that this file does not hold them itself.
UNWANTED = re.compile(r"\b((?i:epsi" r"lon)|TO" r"DO|FIX" r"ME)\b")
FLOATING_WORD = re.compile(
    r"\b(float|double|to_double)\b|(?<![\w.])(\d+\.\d*|\.\d+)([eE][+-]?\d+)?[fFlL]?(?![\w.])")
# glibc has variants of these that differ in the last bit, and takes one by the processor.
ELEMENTARY = re.compile(r"\bstd::(exp2?|expm1|log(2|10|1p)?|pow|a?(sin|cos|tan)h?|atan2)\(")
INCLUDE = re.compile(r'^\s*#\s*include\s*(?:"([^"]+)"|<([^>]+)>)', re.MULTILINE)
NAMESPACE = re.compile(r"^namespace ([\w:]+) \{", re.MULTILINE)
TYPE = re.compile(r"^(?:struct|class|enum(?: class)?) (\w+)(?: final)?(?: : [^{;]*)? \{", re.MULTILINE)
NOISE = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\'', re.DOTALL)


def module_of(path):
    """The module that a file of the repository belongs to, by its path from the root."""
    if path.parts[:2] == ("reference", "examples"):
        return "examples"
    if path.parts[:2] == ("tools", "edgecase_gtest"):
        return "edgecase_gtest"
    return path.parts[1] if path.parts[0] == "src" else path.parts[0]


def line_of(text, position):
    return text.count("\n", 0, position) + 1


def without_noise(text):
    """The text with comments and literals of characters blanked out, line for line."""
    return NOISE.sub(lambda match: re.sub(r"[^\n]", " ", match.group()), text)


def room_of(module, name):
    """The place in its module's order of a file, by its path from the module's folder on."""
    room = name.split("/")[1] if name.count("/") > 1 else ""
    return ROOMS[module].index(room) if room in ROOMS[module] else None


def room_fault(module, path, own):
    """What is wrong with including `own`, a header of the same module."""
    if module not in ROOMS:
        return None
    user, used = room_of(module, "/".join(path.parts[1:])), room_of(module, own)
    if user is None or used is None:
        return f"{module} has no such folder"
    return f'"{own}" lies above {path.parent.name}' if used > user else None


def include_faults(path, text):
    """Includes that the direction of the modules, or a library's place, forbids."""
    module = module_of(path)
    for match in INCLUDE.finditer(text):
        own, library = match.groups()
        line = line_of(text, match.start())
        if own:
            used = own.split("/")[0]
            if used not in ALLOWED:
                yield line, f'"{own}" does not start with a module\'s folder'
            elif used != module and used not in ALLOWED[module]:
                yield line, f'{module} may not use {used}: "{own}"'
            elif used == module and (fault := room_fault(module, path, own)):
                yield line, fault
            continue
        for headers, users in LIBRARIES:
            if re.match(headers, library) and module not in users:
                yield line, f"{module} may not use <{library}>"
        if library == "nlohmann/json.hpp" and path.suffix == ".h":
            yield line, "<nlohmann/json.hpp> in a header costs every user seconds"


def allowed_lines(path, text):
    """Lines of functions that may compute in floating point, and faults of the list itself."""
    lines, faults = set(), []
    for name, reason in FLOATING.get(path.as_posix(), {}).items():
        found = re.search(rf"^([^\n;]*[\s:])?{name}\([^;{{]*(;|{{)", text, re.MULTILINE)
        if not found:
            faults.append((1, f"{name} is on the list of floating functions, but not here"))
            continue
        first = line_of(text, found.start())
        one_line = text[found.end():].split("\n", 1)[0].rstrip().endswith("}")
        is_body = found.group().endswith("{") and not one_line
        end = re.compile(r"^}", re.MULTILINE).search(text, found.end()) if is_body else None
        last = line_of(text, end.start() if end else found.end())
        lines.update(range(first, last + 1))
        above = text.splitlines()[max(0, first - 3):first - 1]
        if reason == "people" and not any("for people only" in line for line in above):
            faults.append((first, f'{name} needs a comment that says "for people only"'))
    return lines, faults


def floating_faults(path, text):
    """Floating point where decisions are integers."""
    place = path.as_posix()
    if place in FLOATING_FILES or not place.startswith(INTEGER_FOLDERS):
        return
    allowed, faults = allowed_lines(path, text)
    yield from faults
    code = without_noise(text)
    for match in FLOATING_WORD.finditer(code):
        line = line_of(code, match.start())
        if line not in allowed:
            yield line, f"{match.group().strip()}: coverage and coordinates are integers"


def elementary_faults(path, text):
    """Functions whose last bit depends on the processor."""
    if path.parts[0] != "src" or path.as_posix() == "src/exact/elementary.h":
        return
    for match in ELEMENTARY.finditer(without_noise(text)):
        yield (line_of(text, match.start()),
               f"{match.group()[:-1]}: exact/elementary.h's answer the same on every processor")


def file_faults(path, text):
    if path.suffix in {".h", ".cpp"} and path.parts[0] != "tests":
        yield from include_faults(path, text)
        yield from floating_faults(path, text)
        yield from elementary_faults(path, text)
    for match in UNWANTED.finditer(text):
        yield line_of(text, match.start()), f"the word {match.group()}"
    if path.suffix in CODE:
        count = text.count("\n")
        if count > MAX_LINES:
            yield MAX_LINES, f"{count} lines; a file has {MAX_LINES} at most"
        if "SPDX-License-Identifier: MIT" not in "".join(text.splitlines(True)[:2]):
            yield 1, "no licence line"


def types_of(path, text):
    """(name with its namespace, line) of the types that one of our headers defines."""
    if path.suffix != ".h" or path.parts[0] == "tests":
        return
    code = without_noise(text)
    namespaces = [(match.start(), match[1]) for match in NAMESPACE.finditer(code)]
    for match in TYPE.finditer(code):
        outer = [name for start, name in namespaces if start < match.start()]
        yield "::".join([*outer[-1:], match[1]]), line_of(code, match.start())


def check(root):
    """All faults of the repository at `root` as (path, line, sentence), and the files read."""
    faults, files, types = [], [], {}
    for folder in ("src", "reference", "reports", "tools", "tests"):
        for path in sorted((root / folder).rglob("*")):
            if path.suffix not in CODE | {".txt", ".css"} or not path.is_file():
                continue
            relative = path.relative_to(root)
            if path.suffix == ".txt" and path.name != "CMakeLists.txt":
                continue
            if "__pycache__" in relative.parts or "node_modules" in relative.parts:
                continue
            text = path.read_text(encoding="utf-8")
            files.append(relative)
            faults += [(relative, line, what) for line, what in file_faults(relative, text)]
            # Of two types of one name the linker takes the members of either.
            for name, line in types_of(relative, text):
                first = types.setdefault(name, relative)
                if first != relative:
                    faults.append((relative, line, f"{name} is in {first}, too"))
    return faults, files


def main():
    faults, files = check(Path(sys.argv[1]).resolve())
    for path, line, what in faults:
        print(f"{path}:{line}: {what}")
    seen = {module_of(path) for path in files}
    missing = {"exact", "model", "rules", "raster", "diff", "results", "run", "reference", "reports",
               "tools"} - seen
    if missing:
        print(f"nothing was read of {', '.join(sorted(missing))}")
    print(f"{len(files)} files, {len(faults)} faults")
    return 1 if faults or missing else 0


if __name__ == "__main__":
    sys.exit(main())
