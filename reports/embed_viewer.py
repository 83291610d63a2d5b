# SPDX-License-Identifier: MIT
"""Joins the viewer's files into one page and writes it as C++ source (see page.h).

Usage: embed_viewer.py OUTPUT.cpp NAME,NAME... TEMPLATE.html [verdict_looks.h] STYLE.css...
                       SCRIPT.js...

The template names {{policy}}, {{style}}, {{script}} where there are scripts, and the places where
text is put in when a page is written: {{title}}, {{data}}, {{blocks}}. What stands between those
becomes one string each, of the names given. The policy allows the page nothing but the one style
and the one script that stand in it, each by its SHA-256 hash: a text that found its way into the
markup could not run, load or send anything. A page with blocks has the place {{loads}} after the
script's hash, for what lets that script load more of them. A style names the place
/* {{verdicts}} */, where the styles of verdicts are put in.
"""
import base64
import hashlib
import pathlib
import re
import sys


def hash_of(text):
    digest = hashlib.sha256(text.encode("utf-8")).digest()
    return "'sha256-" + base64.b64encode(digest).decode("ascii") + "'"


def build_page(template, style, script):
    if "</script" in script.lower() or "<!--" in script or "</style" in style.lower():
        sys.exit("embed_viewer.py: a viewer file holds text that would end its own element")
    policy = (
        "default-src 'none'; base-uri 'none'; form-action 'none'; " f"style-src {hash_of(style)}"
    )
    texts = {"{{style}}": style}
    if script:
        policy += f"; script-src {hash_of(script)}"
        if "{{blocks}}" in template:
            policy += "{{loads}}"
        texts["{{script}}"] = script
    for place, text in {"{{policy}}": policy, **texts}.items():
        if template.count(place) != 1:
            sys.exit(f"embed_viewer.py: the template must hold {place} exactly once")
        template = template.replace(place, text)
    return re.split(r"{{(?:title|loads|data|blocks)}}", template)


def array(name, text):
    """Bytes rather than a string literal: those have a length limit in some compilers."""
    data = text.encode("utf-8")
    rows = [",".join(str(b) for b in data[i : i + 24]) for i in range(0, len(data), 24)]
    return f"constexpr unsigned char {name}[] = {{\n" + ",\n".join(rows) + "};\n"


def verdict_styles(table):
    """Colours of light and dark pages, and the classes that have them, by verdict."""
    light, dark, classes = [], [], []
    for row in table.split("{.verdict = Verdict::")[1:]:
        name = row[: row.index(",")].replace("_", "-")
        sign = re.search(r'\.sign = "(\w+)"', row)[1]
        colors = re.findall(r'\.(\w+) = {"(#\w+)", "(#\w+)"}', row)
        for part, on_light, on_dark in colors:
            variable = {"ink": f"--{name}", "ground": f"--{name}-bg", "heat": f"--heat-{name}"}[part]
            light.append(f"{variable}: {on_light};")
            dark.append(f"{variable}: {on_dark};")
        classes.append(
            f".b-{name} {{ background: var(--{name}-bg); color: var(--{name}); }}\n"
            f".v-{name} {{ color: var(--{name}); }} .f-{name} {{ background: var(--{name}); }}\n"
            f'.cell.v-{name}::before {{ content: "\\{sign}"; content: "\\{sign}" / ""; }}\n'
            f".swatch.h-{name} {{ background: var(--heat-{name}); }}"
        )
    variables = f":root {{ {' '.join(light)} }}"
    at_night = f"@media (prefers-color-scheme: dark) {{ :root {{ {' '.join(dark)} }} }}"
    return "\n".join([variables, at_night, *classes])


def joined(files, suffix):
    return "".join(p.read_text(encoding="utf-8") for p in files if p.suffix == suffix)


def main():
    output, names, template, *files = sys.argv[1:]
    names = names.split(",")
    files = [pathlib.Path(file) for file in files]
    script = joined(files, ".js")
    parts = build_page(
        pathlib.Path(template).read_text(encoding="utf-8"),
        joined(files, ".css").replace(
            "/* {{verdicts}} */", verdict_styles(joined(files, ".h"))
        ),
        '"use strict";\n' + script if script else "",
    )
    if len(parts) != len(names):
        sys.exit("embed_viewer.py: a name is needed for each part between {{title}} and {{data}}")
    arrays = "".join(array(f"{name}Bytes", part) for name, part in zip(names, parts))
    views = "".join(
        f"const std::string_view {name}{{reinterpret_cast<const char*>({name}Bytes), "
        f"sizeof {name}Bytes}};\n"
        for name in names
    )
    pathlib.Path(output).write_text(
        '// Made by embed_viewer.py.\n#include "reports/page.h"\n\nnamespace edgecase {\n'
        f"namespace {{\n{arrays}}}\n{views}}}  // namespace edgecase\n",
        encoding="utf-8",
    )


main()
