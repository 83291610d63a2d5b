// SPDX-License-Identifier: MIT The small pictures of the list: the difference of a case, and the
// verdicts along a sweep.

const THUMBNAIL = 46;          // CSS pixels
const THUMBNAIL_AFTER = 60;    // milliseconds that a row stays before its picture is made
const THUMBNAILS_KEPT = 400;

const Thumbnails = new Map();  // id -> canvas, or null where there is none

// Draws what belongs into the rows that exist now.
function paintCharts(body) {
  const theme = themeColors();
  for (const chart of body.querySelectorAll(".chart")) paintChart(chart, theme);
  for (const canvas of body.querySelectorAll(".thumbnail")) paintThumbnail(canvas);
}

// A column for each case, in the colour of its verdict; what agrees is low.
function paintChart(canvas, theme) {
  const row = CaseList.rows[Number(canvas.closest("[data-row]").dataset.row)];
  const ratio = ratioNow();
  canvas.width = Math.round(canvas.clientWidth * ratio);
  canvas.height = Math.round(canvas.clientHeight * ratio);
  const context = canvas.getContext("2d");
  const count = row.cases.length;
  const apart = canvas.width / count > 4 * ratio ? Math.round(ratio) : 0;
  const from = (i) => Math.round(i * canvas.width / count);
  row.cases.forEach((one, i) => {
    const {verdict} = one.results[Number(canvas.dataset.renderer)];
    context.fillStyle = theme["h-" + verdict] || theme.muted;
    const height = verdict === "agree" ? Math.round(0.35 * canvas.height) : canvas.height;
    context.fillRect(from(i), canvas.height - height, Math.max(1, from(i + 1) - from(i) - apart), height);
  });
}

function paintThumbnail(canvas) {
  const one = Cases[Number(canvas.dataset.case)];
  const size = Math.round(THUMBNAIL * ratioNow());
  canvas.width = canvas.height = size;
  const put = (picture) => picture && canvas.getContext("2d").drawImage(picture, 0, 0);
  if (Thumbnails.has(one.id)) return put(Thumbnails.get(one.id));
  if (one.line === undefined || !Blocks.isHere(one.line)) return;
  setTimeout(async () => {
    if (!canvas.isConnected) return;
    await loadDetails(one);
    if (Thumbnails.size >= THUMBNAILS_KEPT) Thumbnails.delete(Thumbnails.keys().next().value);
    Thumbnails.set(one.id, thumbnailOf(one, size));
    put(Thumbnails.get(one.id));
  }, THUMBNAIL_AFTER);
}

// The difference of a case's worst answer; every disputed pixel is large enough to be seen.
function thumbnailOf(one, size) {
  const result = CaseView.resultFor(one, "");
  const exact = exactPixels(one, result.answer);
  const rendered = renderedPixels(one, result.answer, exact);
  if (!rendered) return null;
  const theme = themeColors();
  const {width, height} = one;
  const kinds = new Map(result.answer.disagreements.map((d) => [d.y * width + d.x, d.kind]));
  const canvas = h("canvas", {width: size, height: size});
  const context = canvas.getContext("2d");
  const scale = Math.min(size / width, size / height);
  const [left, top] = [(size - width * scale) / 2, (size - height * scale) / 2];
  context.imageSmoothingEnabled = scale < 1;
  context.drawImage(differenceImage(exact, rendered, width, height, kinds, theme), left, top,
    width * scale, height * scale);
  const least = Math.max(scale, 2 * ratioNow());
  for (const d of result.answer.disagreements) {
    context.fillStyle = theme["k-" + d.kind];
    context.fillRect(left + d.x * scale, top + (height - 1 - d.y) * scale, least, least);
  }
  return canvas;
}
