// SPDX-License-Identifier: MIT The sections below the pictures: aggregated values, candidate
// causes, vertices, the case's source, and the commands that reproduce the case.

function ulpLabel(exponent) {
  if (exponent < 0) return "< 1";
  if (exponent > 9) return "\u2265 2^" + exponent;
  return exponent === 0 ? "1" : "\u2265 " + 2 ** exponent;
}

function histogramOf(pairs) {
  const most = Math.max(...pairs.map(([, count]) => count));
  return h("div.histogram", {role: "img", "aria-label": "Components by error in ULP: " +
    pairs.map(([e, n]) => ulpLabel(e) + " ULP: " + n).join(", ")},
  pairs.map(([exponent, count]) => {
    const bar = h("i", {});
    bar.style.height = Math.max(2, Math.round(40 * count / most)) + "px";
    return h("span.bin", {title: ulpLabel(exponent) + " ULP: " + count},
      h("small", {}, count), bar, h("small.faint", {}, ulpLabel(exponent)));
  }));
}

function valuesCard(v, pick) {
  const {worst} = v;
  if (!v.differing)
    return h("div.values", {}, h("b", {}, v.attribute), h("p", {}, "All " +
      v.compared.toLocaleString("en") + " compared are the correctly rounded values."));
  return h("div.values", {},
    h("div", {}, h("b", {}, v.attribute), " ", ruleChip(v.rule), " ",
      v.ruling ? rulingChip(v.ruling) : null,
      h("p", {}, v.differing.toLocaleString("en") + " of " + v.compared.toLocaleString("en") +
        (v.cause ? " differ, as " + v.cause + " makes them." : " differ within what is permitted.")),
      h("p", {}, "Worst: ",
        h("button.link.mono", {onclick: () => pick(worst.x, worst.y)},
          "pixel (" + worst.x + ", " + worst.y + ")"),
        (v.attribute === "written samples" ? " sample " : " component ") + worst.component + ", " + short(worst.ulp) + " ULP: exact ",
        h("span.mono", {}, short(worst.exact)), ", rendered ",
        h("span.mono", {}, short(worst.rendered)), worst.permitted &&
        ", " + short(worst.permitted[0]) + " to " + short(worst.permitted[1]) + " permitted"),
      h("p", {}, "Mean: " + short(v.mean_ulp) + " ULP over all " +
        v.components.toLocaleString("en") + " components." + (v.relative ? " At most " +
        short(v.relative) + " of the attribute's range over the vertices." : ""))),
    v.histogram.length > 0 && h("div", {}, histogramOf(v.histogram),
      h("small.faint", {}, "components by error, ULP")));
}

function valuesSection(answer, pick) {
  if (!answer.values.length) return null;
  return h("section.card", {}, h("h2", {}, "Values"),
    h("div.columns", {}, answer.values.map((v) => valuesCard(v, pick))));
}

function evidenceSection(answer) {
  if (!answer.evidence.length && !answer.illegal_line_snaps.length) return null;
  const rows = answer.evidence.map((e) => h("tr", {},
    h("th", {scope: "row"}, (e.primitive < 0 ? "the whole answer" : "primitive " + e.primitive) +
      (e.pass === undefined ? "" : ", pass " + (e.pass + 1))),
    h("td", {}, e.causes.length ? e.causes.map((c) => h("div", {}, causeChips(c)))
      : h("i.faint", {}, e.primitive < 0 ? "legal as it stands; its rows in the opposite order, nothing disagrees"
        : "no catalogued alternative reproduces it")),
    h("td.mono", {}, e.illegal_line_snaps.join(", ")), h("td", {}, e.broken_clause)));
  return h("section.card", {}, h("h2", {}, "Evidence"),
    h("p.faint", {}, "Alternatives that reproduce what the renderer drew, smallest sets first."),
    rows.length > 0 && h("div.scroll", {}, h("table.evidence", {},
      h("thead", {}, h("tr", {}, h("td", {}), h("th", {}, "candidate causes"),
        h("th", {}, "snaps under which it is not legal"), h("th", {}, "as given it breaks"))),
      h("tbody", {}, rows))),
    answer.illegal_line_snaps.length > 0 && h("p", {}, "Some line of the case is not legal with vertices snapped by: ",
      h("span.mono", {}, answer.illegal_line_snaps.join(", "))));
}

function verticesOf(figure) {
  const items = figure.filter(([role]) => role.endsWith("vertex")).flatMap(
    ([role, , label, at]) => Array.from({length: at.length / 2}, (_, i) => h("li", {},
      h("span.faint", {}, label || role.replace("-", " "), " "),
      h("span.mono", {}, coordinate(at[2 * i]) + ", " + coordinate(at[2 * i + 1])))));
  if (!items.length) return null;
  return h("details", {}, h("summary", {}, "Vertices (" + items.length + ")"),
    h("ol.vertices", {}, items.slice(0, 500)));
}

function prettySource(source) {
  try {
    return JSON.stringify(JSON.parse(source), null, 2)
      .replace(/\[\s+((?:[^\[\]{}]|\n)*?)\s+\]/g, (all, inner) =>
        inner.length < 90 ? "[" + inner.replace(/\s*\n\s*/g, " ") + "]" : all);
  } catch (error) {
    return source;
  }
}

// The case's file, formatted when it is opened.
function sourceOf(one) {
  const text = h("pre", {tabindex: "0"});
  return h("details", {ontoggle: () => sourceText(one).then((source) =>
    replace(text, source ? prettySource(source) : "The file was not beside the results."),
    (fault) => replace(text, "The text cannot be read: " + fault.message + "."))},
    h("summary", {}, "Case file ", h("code.faint", {}, one.file)), text);
}

// A word, quoted for a POSIX shell if necessary.
function shellWord(text) {
  return /^[\w@%+=:,.\/-]+$/.test(text) ? text : "'" + text.replaceAll("'", "'\\''") + "'";
}

// A renderer as the command line names it: "mine=exec:./r" if it has a name of its own.
function askedAs(name) {
  const {traits} = Data.renderers.find((info) => info.name === name);
  return traits.address && !name.includes(":") ? name + "=" + traits.address : name;
}

function commandsFor(one, result, pixel) {
  const against = ["--against", askedAs(result.renderer)];
  const policy = Data.policy === "opengl" ? [] : ["--policy", Data.policy];
  const filter = one.id.includes(":") ? ["--filter", one.id] : [];
  const lines = [["edgecase", "run", one.file, ...filter, ...against, ...policy]];
  if (pixel)
    lines.push(["edgecase", "explain", one.file, ...filter, "--pixel", pixel.x + "," + pixel.y, ...against,
      ...policy]);
  return lines.map((line) => line.map(shellWord).join(" "));
}

async function copyText(text, button) {
  try {
    await navigator.clipboard.writeText(text);
  } catch (error) {
    const field = h("textarea.unseen", {});
    field.value = text;
    document.body.append(field);
    field.select();
    document.execCommand("copy");
    field.remove();
  }
  button.textContent = "Copied";
  say("Copied");
  setTimeout(() => { button.textContent = "Copy"; }, 1200);
}

function commandLine(text) {
  return h("div.command", {}, h("code", {}, text), h("button", {
    "aria-label": "Copy this command", onclick: (event) => copyText(text, event.currentTarget),
  }, "Copy"));
}
