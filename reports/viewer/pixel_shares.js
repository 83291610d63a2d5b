// SPDX-License-Identifier: MIT The shares of an image's pixels by kind: of a result beside its
// pictures, and of all scenes together on the first page.

const pixelsOf = (counts) => PIXEL_VERDICTS.reduce((sum, verdict) => sum + counts[verdict], 0);

// "0.0031 %": two digits of a small share, so that one pixel in a million is not shown as 0, and
// never 100 % unless it is all.
function shareText(count, all) {
  if (!count) return "0";
  if (count === all) return "100 %";
  const share = 100 * count / all;
  if (share < 1) return Number(share.toPrecision(2)) + " %";
  const digits = Math.max(2, Math.ceil(-Math.log10(100 - share)) + 1);
  return (share > 99 ? share.toFixed(Math.min(digits, 6)) : share.toFixed(1)) + " %";
}

function pixelLine(counts) {
  const all = counts && pixelsOf(counts);
  if (!all) return null;
  return h("p.pixel-shares", {}, PIXEL_VERDICTS.filter((verdict) => counts[verdict]).map((verdict) =>
    h("span", {title: counts[verdict].toLocaleString("en") + " of " + all.toLocaleString("en") +
      " pixels: " + VERDICTS[verdict].means},
    verdictIcon(verdict), shareText(counts[verdict], all) + " " + verdict)),
  h("span.faint", {title: "Pixels whose stored colour is exact's to the bit"},
    "same colour: " + shareText(counts.same, all)));
}

// Pixels of all scenes that a renderer drew, by the worst finding at each.
function scenesSection() {
  if (!Data.renderers.some((info) => info.scenes.drawn)) return null;
  const rows = Data.renderers.map((info) => {
    const counts = info.scenes;
    const all = pixelsOf(counts);
    const cell = (key) => h("td.count", {title: counts[key].toLocaleString("en") + " pixels"},
      shareText(counts[key], all));
    return h("tr", {}, h("th", {scope: "row"}, info.name),
      h("td.count", {}, counts.drawn.toLocaleString("en")), h("td.count", {}, all.toLocaleString("en")),
      PIXEL_VERDICTS.map(cell), cell("same"));
  });
  return h("section.first", {}, h("h2", {}, "Whole scenes, pixel by pixel"),
    h("p.faint", {}, "Each pixel counts once, by the worst that was found at it, seen or hidden; " +
      "\u201csame colour\u201d counts those whose stored colour is exact\u2019s to the bit."),
    scrolled("Whole scenes", h("table.clusters.shares", {},
      h("thead", {}, h("tr", {}, h("td", {}), ["scenes", "pixels"].map((text) =>
        h("th", {scope: "col"}, text)), PIXEL_VERDICTS.map((verdict) =>
        h("th", {scope: "col", title: VERDICTS[verdict].means}, verdictIcon(verdict), verdict)),
      h("th", {scope: "col"}, "same colour"))),
      h("tbody", {}, rows))));
}
