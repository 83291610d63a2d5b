# SPDX-License-Identifier: MIT
"""Joins the viewer's files into one page and writes it as C++ source (see page.h).

Usage: embed_viewer.py OUTPUT.cpp index.html viewer.css SCRIPT.js...

The template names four places: {{policy}}, {{style}}, {{data}} and {{script}}. The policy allows
the page nothing but the one style and the one script that stand in it, each by its SHA-256 hash: a
text that found its way into the markup could not run, load or send anything.
"""
import base64
import hashlib
import pathlib
import sys


def hash_of(text):
    digest = hashlib.sha256(text.encode("utf-8")).digest()
    return "'sha256-" + base64.b64encode(digest).decode("ascii") + "'"


def build_page(template, style, script):
    if "</script" in script.lower() or "<!--" in script or "</style" in style.lower():
        sys.exit("embed_viewer.py: a viewer file holds text that would end its own element")
    policy = (
        "default-src 'none'; base-uri 'none'; form-action 'none'; "
        f"style-src {hash_of(style)}; script-src {hash_of(script)}"
    )
    page = template
    for place, text in (("{{policy}}", policy), ("{{style}}", style), ("{{script}}", script)):
        if page.count(place) != 1:
            sys.exit(f"embed_viewer.py: the template must hold {place} exactly once")
        page = page.replace(place, text)
    return page.split("{{data}}")


def array(name, text):
    """Bytes rather than a string literal: those have a length limit in some compilers."""
    data = text.encode("utf-8")
    rows = [",".join(str(b) for b in data[i : i + 24]) for i in range(0, len(data), 24)]
    return f"constexpr unsigned char {name}[] = {{\n" + ",\n".join(rows) + "};\n"


def main():
    output, template, style, *scripts = (pathlib.Path(a) for a in sys.argv[1:])
    script = '"use strict";\n' + "".join(p.read_text(encoding="utf-8") for p in scripts)
    parts = build_page(
        template.read_text(encoding="utf-8"), style.read_text(encoding="utf-8"), script
    )
    if len(parts) != 2:
        sys.exit("embed_viewer.py: the template must hold {{data}} exactly once")
    view = "{reinterpret_cast<const char*>(%s), sizeof %s}"
    output.write_text(
        '// Made by embed_viewer.py.\n#include "reports/page.h"\n\nnamespace edgecase {\n'
        "namespace {\n" + array("kBefore", parts[0]) + array("kAfter", parts[1]) + "}\n"
        f"const std::string_view kPageBeforeData{view % ('kBefore', 'kBefore')};\n"
        f"const std::string_view kPageAfterData{view % ('kAfter', 'kAfter')};\n"
        "}  // namespace edgecase\n",
        encoding="utf-8",
    )


main()
