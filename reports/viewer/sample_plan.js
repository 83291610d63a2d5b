// SPDX-License-Identifier: MIT The sample positions of a case: one large pixel with its numbered
// samples.

const PLAN = 104;       // CSS pixels of the pixel's side
const PLAN_MARGIN = 9;  // for samples on its border

const planPlace = ([x, y]) => [PLAN_MARGIN + PLAN * x, PLAN_MARGIN + PLAN * (1 - y)];

function planGrid() {
  const lines = [0.25, 0.5, 0.75].map((at) => {
    const [x, y] = planPlace([at, at]);
    return "M" + x + " " + PLAN_MARGIN + "v" + PLAN + "M" + PLAN_MARGIN + " " + y + "h" + PLAN;
  });
  return [
    svgNode("rect", {class: "ground", x: PLAN_MARGIN, y: PLAN_MARGIN, width: PLAN, height: PLAN}),
    svgNode("path", {class: "grid", d: lines.join("")}),
  ];
}

// A disc for exact's position of a sample, a square for the renderer's, if it differs.
function planMark(at, s, radius, shape) {
  const [x, y] = planPlace(at);
  const body = shape === "disc" ? svgNode("circle", {class: shape, cx: x, cy: y, r: radius}) :
    svgNode("rect", {class: shape, x: x - radius, y: y - radius, width: 2 * radius,
      height: 2 * radius});
  return svgNode("g", {}, svgNode("title", {}, "sample " + s + " at " + withinText(at)), body,
    svgNode("text", {class: "on-" + shape, x, y: y + radius * 0.42, "font-size": radius * 1.25,
      "text-anchor": "middle"}, String(s)));
}

function planDrawing(exact, reported, label) {
  const radius = Math.min(9, PLAN * dotRadius(exact) * 0.72);
  const moved = reported ? exact.map((at, s) => {
    const [x, y] = planPlace(at);
    const [u, v] = planPlace(reported[s]);
    return svgNode("path", {class: "way", d: "M" + x + " " + y + "L" + u + " " + v});
  }) : [];
  const size = PLAN + 2 * PLAN_MARGIN;
  return svgNode("svg", {role: "img", "aria-label": label, width: size, height: size,
    viewBox: "0 0 " + size + " " + size}, planGrid(), moved,
  reported ? reported.map((at, s) => planMark(at, s, radius, "square")) : [],
  exact.map((at, s) => planMark(at, s, radius, "disc")));
}

// Null for a case that is not multisampled.
function samplePlan(one, result) {
  if (!one.samples) return null;
  const {answer} = result;
  const exact = positionsOf((answer.exact?.samples || one.samples).positions);
  const reported = positionsOf(answer.samples?.positions);
  const count = plural(one.samples.count, "sample", "samples");
  if (!exact) return h("p.plan.faint", {}, count + " a pixel, at places that are not told");
  const differ = reported && !samePositions(exact, reported);
  const words = !answer.samples ? "as exact has them" : !reported
    ? "as exact has them; " + result.renderer + " does not tell where its own lie" : differ
      ? "discs as exact has them, squares as " + result.renderer + " reports them"
      : "exact has them where " + result.renderer + " reports them";
  const list = (positions) => positions.map((at, s) => s + " at " + withinText(at)).join("; ");
  const label = count + " of a pixel, y up: " + list(exact) +
    (differ ? ". Reported: " + list(reported) : "");
  return h("figure.plan", {}, planDrawing(exact, differ ? reported : null, label),
    h("figcaption", {}, h("b", {}, count + " a pixel"), h("span", {}, words)));
}
