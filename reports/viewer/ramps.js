// SPDX-License-Identifier: MIT The levels of detail along a ramp: a plot for each distinct answer,
// one below another on the same axes, with the levels above and their distances from exact below.
// All plots show the same chosen place.

const RAMP_KEYS = {
  ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1, PageDown: -10, PageUp: 10,
  Home: -Infinity, End: Infinity,
};

const levelText = (v) => Number.isFinite(v) ? String(Number(v.toPrecision(7))) :
  Number.isNaN(v) ? "NaN" : v > 0 ? "\u221e" : "-\u221e";

// "+0.0013": the distance from exact.
function apartText(point) {
  const apart = levelsApart(point.rendered, point.exact);
  if (Number.isNaN(apart)) return "";
  if (apart === 0) return "equal to exact";
  const size = Math.abs(apart);
  const sign = apart < 0 ? "-" : "+";
  return sign + (size === Infinity ? "\u221e" : Number(size.toPrecision(3))) + " from exact";
}

// The points of an answer by column, and those outside the band.
function rampOf(answer) {
  const keys = ["x", "y", "exact", "low", "high", "rendered"];
  const points = answer.ramp.points.map((numbers) =>
    Object.fromEntries(keys.map((key, i) => [key, Number(numbers[i])])));
  const outside = new Set(answer.ramp.outside.map((i) => points[i]));
  const {farthest} = answer.ramp;
  const listed = new Set(answer.disagreements.map((d) => d.x + "," + d.y));
  return {
    answer, outside, farthest: farthest === undefined ? null : points[farthest],
    listed: points.filter((p) => listed.has(p.x + "," + p.y)).map((p) => p.x),
    points: [...points].sort((a, b) => a.x - b.x),
  };
}

class Ramps {
  // The index of the plot that gets the focus back after the keyboard led to another renderer.
  static returning = -1;

  // onpick(result, x, y): a pixel of a result's plot was chosen.
  constructor(one, chosen, onpick) {
    this.one = one;
    this.onpick = onpick;
    this.column = null;   // pointed at
    this.pixel = null;    // chosen
    const answers = [...new Set([chosen, ...one.results].map((r) => r.answer))].filter((a) => a.ramp);
    this.plots = answers.map((answer) => this.plot(rampOf(answer), chosen));
    const points = this.plots.flatMap((plot) => plot.ramp.points);
    this.levels = rangeOf(points, 1, 1);
    this.apart = rangeOf(points.map(lessExact), 0.02, 2);
    this.columns = [...new Set(points.map((p) => p.x))].sort((a, b) => a - b);
    const without = one.results.filter((r) => !r.answer.ramp).map((r) => r.renderer);
    this.element = this.plots.length > 0 && h("section.card.ramps", {},
      h("h2", {}, "Level of detail along the row"), this.legend(),
      this.plots.map((plot) => plot.element),
      without.length > 0 && h("p.faint", {}, "No level of detail is told by " +
        without.join(", ") + "."));
    if (!this.element) return;
    this.watch = new ResizeObserver(() => this.draw());
    this.watch.observe(this.element);
  }

  destroy() {
    this.watch?.disconnect();
  }

  legend() {
    const swatch = (name, d, text) => h("span.key", {},
      svgNode("svg", {viewBox: "0 0 22 12", width: 22, height: 12, "aria-hidden": "true"},
        svgNode("path", {class: name, d})), text);
    const beyond = (v, {low, high}) => !(v >= low && v <= high);
    const hidden = this.plots.some(({ramp}) => ramp.points.some((p) =>
      beyond(p.rendered, this.levels) || beyond(lessExact(p).rendered, this.apart)));
    return h("p.keys", {},
      swatch("exact", "M0 6H22", "exact"), swatch("band", "M0 1H22V11H0Z", "permitted"),
      swatch("dots", dotsPath([{x: 0, rendered: 0}, {x: 1, rendered: 0}],
        {x: (x) => 11 * x, y: () => 6}, 2.5), "rendered"),
      this.plots.some(({ramp}) => ramp.outside.size) &&
        swatch("outside", "M11 1l5 5l-5 5l-5 -5z", "outside"),
      hidden && h("span.key", {},
        "\u25b2 \u25bc beyond the plot, \u2715 not a number"),
      this.plots.some(({ramp}) => ramp.listed.length) &&
        swatch("listed", "M11 2V10", "a listed disagreement"));
  }

  plot(ramp, chosen) {
    const results = this.one.results.filter((r) => r.answer === ramp.answer);
    const result = results.includes(chosen) ? chosen : results[0];
    const first = Data.renderers.findIndex((r) => r.name === results[0].renderer);
    const names = results.map((r) => r.renderer).join(", ");
    const words = h("p.sentence", {}, h("span", {}, ramp.answer.ramp.words),
      this.openCauses(ramp.answer.ramp), this.placeLinks(ramp, result));
    const svg = svgNode("svg", {
      role: "slider", tabindex: 0, "aria-orientation": "horizontal",
      "aria-label": "Level of detail by pixel column, " + visible(names),
      "aria-valuemin": 0, "aria-valuemax": this.one.width - 1, "aria-valuenow": 0,
    });
    const readout = h("p.readout.mono", {});
    const plot = {ramp, result, svg, readout, element: null};
    plot.element = h("figure", {class: "r-" + first % 8},
      h("figcaption", {}, h("i", {}), names,
        result === chosen && h("span.faint", {}, "shown beside")), svg, words, readout);
    this.listen(plot);
    return plot;
  }

  // Why points outside the band are no violations, if so.
  openCauses({causes = []}) {
    return causes.length > 0 && h("span", {},
      " The specification leaves open what it follows there: ",
      causes.map((cause, i) => [i > 0 && ", ", causeChips(cause)]), ".");
  }

  placeLinks(ramp, result) {
    const link = (what, p) => p && h("span.place", {}, what + ": ", h("button.link.mono", {
      onclick: () => this.onpick(result, p.x, p.y),
    }, "pixel (" + p.x + ", " + p.y + ")"));
    return [link("farthest from exact", ramp.farthest),
      link("first outside", ramp.points.find((p) => ramp.outside.has(p)))];
  }

  listen(plot) {
    const {svg} = plot;
    const columnOf = (event) => {
      const box = svg.getBoundingClientRect();
      const {left, width} = this.layout;
      const x = Math.floor((event.clientX - box.left - left) / width * this.one.width);
      return this.columns.includes(x) ? x : null;
    };
    const pick = () => {
      const point = plot.ramp.points.find((p) => p.x === this.column);
      if (point) this.onpick(plot.result, point.x, point.y);
    };
    svg.addEventListener("pointermove", (event) => this.point(columnOf(event)));
    svg.addEventListener("pointerdown", (event) => this.point(columnOf(event)));
    svg.addEventListener("pointerleave", () => this.point(null));
    svg.addEventListener("click", pick);
    svg.addEventListener("focus", () => {
      if (this.column === null) this.point(this.chosenColumn() ?? this.columns[0]);
    });
    svg.addEventListener("blur", () => this.point(null));
    svg.addEventListener("keydown", (event) => {
      if (event.ctrlKey || event.metaKey || event.altKey) return;
      const step = RAMP_KEYS[event.key];
      if (!step && event.key !== "Enter" && event.key !== " ") return;
      event.preventDefault();
      event.stopPropagation();
      if (step) return this.step(step);
      Ramps.returning = this.plots.indexOf(plot);
      pick();
    });
  }

  chosenColumn() {
    return this.pixel && this.columns.includes(this.pixel.x) ? this.pixel.x : null;
  }

  step(by) {
    const from = Math.max(this.columns.indexOf(this.column), 0);
    const to = Math.min(Math.max(from + by, 0), this.columns.length - 1);
    this.point(this.columns[to]);
  }

  // Points at a column in all plots, or with null at none.
  point(column) {
    this.column = column;
    this.plots.forEach((plot) => this.tell(plot));
  }

  // Marks the pixel that is chosen in the pictures.
  mark(pixel) {
    this.pixel = pixel;
    this.plots.forEach((plot) => this.tell(plot));
  }

  draw() {
    const width = Math.floor(this.plots[0].element.clientWidth);
    if (width < 120 || (this.layout && width === this.layout.all)) return;
    const left = 46;
    this.layout = {all: width, left, width: width - left - 10};
    for (const plot of this.plots) this.drawPlot(plot);
    this.plots[Ramps.returning]?.svg.focus({preventScroll: true});
    Ramps.returning = -1;
  }

  drawPlot(plot) {
    const {ramp, svg} = plot;
    const place = {left: this.layout.left, width: this.layout.width, columns: this.one.width};
    const above = {...place, ...this.levels, top: 18, height: 132, name: "\u03bb\u2032, levels"};
    const below = {...place, ...this.apart, top: 178, height: 76, signed: true,
      name: "\u03bb\u2032 less exact, levels"};
    const outside = ramp.points.filter((p) => ramp.outside.has(p));
    plot.cursor = svgNode("g", {});
    plot.panels = [above, below];
    svg.setAttribute("width", this.layout.all);
    svg.setAttribute("height", 288);
    replace(svg, svgNode("g", {"aria-hidden": "true"},
      drawPanel(above, ramp.points, outside, ramp.listed),
      drawPanel(below, ramp.points.map(lessExact), outside.map(lessExact), []),
      columnAxis(below, panelScale(below)),
      svgNode("text", {class: "what", x: place.left + place.width, y: 285, "text-anchor": "end"},
        "pixel column"), plot.cursor));
    this.tell(plot);
  }

  // Shows the column pointed at, or else the chosen one, in the plot and as text.
  tell(plot) {
    const column = this.column ?? this.chosenColumn();
    const points = plot.ramp.points.filter((p) => p.x === column);
    const text = points.map((p) => this.pointText(plot, p)).join("; ");
    replace(plot.readout, text || "Point at a pixel to read its numbers.");
    if (column !== null) plot.svg.setAttribute("aria-valuenow", column);
    plot.svg.setAttribute("aria-valuetext", text || "pixel column " + (column ?? 0) + ": nothing");
    if (plot.cursor) replace(plot.cursor, this.cursorShapes(plot, column, points));
  }

  pointText(plot, p) {
    const all = plot.ramp.answer.disagreements;
    const listed = all.findIndex((d) => d.x === p.x && d.y === p.y);
    return "pixel (" + p.x + ", " + p.y + "): " + [
      "exact " + levelText(p.exact), "permitted " + levelText(p.low) + " to " + levelText(p.high),
      "rendered " + levelText(p.rendered), apartText(p),
      plot.ramp.outside.has(p) && "outside",
      listed >= 0 && "disagreement " + (listed + 1) + " of " + all.length,
    ].filter(Boolean).join(", ");
  }

  cursorShapes(plot, column, points) {
    if (column === null) return [];
    return plot.panels.map((panel, i) => {
      const scale = panelScale(panel);
      const x = scale.x(column + 0.5);
      const shown = (i ? points.map(lessExact) : points).filter((p) => !Number.isNaN(p.rendered));
      return [svgNode("line", {class: "cursor", x1: x, x2: x, y1: panel.top,
        y2: panel.top + panel.height}),
      svgNode("path", {class: "dots pointed", d: dotsPath(shown, scale, dotSize(scale) + 1.5)})];
    });
  }
}
