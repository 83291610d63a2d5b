// SPDX-License-Identifier: MIT
// The samples of one pixel in numbers: exact and rendered one above the other.

const COVERED_WORDS = {true: "covered", false: "not covered", null: "coverage not told"};

function swatch(shape, color) {
  const element = h("i.swatch", {class: shape, "aria-hidden": "true"});
  if (color) element.style.setProperty("--sample", "rgb(" + color.slice(0, 3).join(" ") + ")");
  return element;
}

// "covered, not written, missing".
function sampleWords({covered, hits}, kind) {
  const written = hits === null ? "writing not told" : !hits ? "not written" : hits === 1 ?
    "written" : "written " + hits + " times";
  return [COVERED_WORDS[covered], written, kind].filter(Boolean).join(", ");
}

function sampleCell(sample, kind) {
  const words = sampleWords(sample, kind);
  return h("td", {class: kind ? "differs" : "", title: words},
    swatch(sample.filled ? "disc" : "ring", sample.color), kind && kindIcon(kind),
    h("span.unseen", {}, words + " "), sample.color ? sample.color.join(" ") : "not told",
    sample.hits > 1 && h("b", {}, " \u00d7" + sample.hits));
}

function sampleRow(name, image, resolved, {x, y}, other) {
  if (!image) return h("tr", {}, h("th", {scope: "row"}, name), h("td", {}, "not told"));
  const mask = image.coverage ? image.coverage[y * image.width + x] : null;
  const otherMask = other?.coverage ? other.coverage[y * image.width + x] : mask;
  const cells = Array.from({length: image.count}, (_, s) => {
    const sample = sampleAt(image, x, y, s);
    return sampleCell(sample, other ? kindBetween(sampleAt(other, x, y, s), sample) : "");
  });
  return h("tr", {}, h("th", {scope: "row"}, name),
    h("td", {class: mask === otherMask ? "" : "differs"},
      mask === null ? "not told" : maskText(mask, image.count)), cells,
    h("td", {}, resolved && swatch("square", resolved), resolved ? resolved.join(" ") : "none"));
}

// Heads show the sample positions: exact's, and the renderer's if they differ. `resolved`: the
// resolved colours {exact, rendered} of the pixel, or null.
function sampleTable(exact, rendered, pixel, resolved) {
  const own = rendered?.positions || exact.positions;
  const places = exact.positions && (samePositions(exact.positions, own) ? [exact.positions] :
    [exact.positions, own]);
  const heads = Array.from({length: exact.count}, (_, s) => h("th", {scope: "col"}, "sample " + s,
    places && h("small.faint", {}, " " + places.map((at) => withinText(at[s])).join(" | "))));
  return h("table.samples.mono", {"aria-label": "Samples of pixel (" + pixel.x + ", " + pixel.y +
    ")"},
  h("thead", {}, h("tr", {}, h("td", {}), h("th", {scope: "col"}, "coverage"), heads,
    h("th", {scope: "col"}, "resolved"))),
  h("tbody", {}, sampleRow("exact", exact, resolved.exact, pixel, null),
    sampleRow("rendered", rendered, resolved.rendered, pixel, exact)));
}
