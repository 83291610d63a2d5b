// SPDX-License-Identifier: MIT What is drawn of one answer on a canvas: exact, the difference, what
// was rendered, or the verdict of each pixel, with the figures that explain it.

const DIMMED = 0.35;    // of everything but the chosen disagreement, in close-ups
const CROWD_NEAR = 60;  // outlines that are dimmed where no primitive is the chosen one
const FEW_HALOS = 150;  // disputed pixels too small to be seen, beyond which none has a ring

class Painter {
  constructor(one, result) {
    this.one = one;
    this.result = result;
    this.exact = exactPixels(one, result.answer);
    this.rendered = renderedPixels(one, result.answer, this.exact);
    this.exactSamples = exactSamples(one, result.answer);
    this.renderedSamples = renderedSamples(one, result.answer, this.exactSamples);
    this.listed = listedSamples(result.answer.disagreements);
    this.colors();
  }

  // Creates the images in the colours of the present theme.
  colors() {
    const {one: {width, height}, result: {answer}, exact, rendered} = this;
    this.theme = themeColors();
    const kinds = new Map(answer.disagreements.map((d) => [d.y * width + d.x, d.kind]));
    this.images = {
      exact: exact && imageOf(exact, width, height),
      difference: rendered && differenceImage(exact, rendered, width, height, kinds, this.theme),
      rendered: rendered && imageOf(rendered, width, height),
    };
    this.heat = null;
  }

  image(which) {
    if (which !== "verdicts") return this.images[which];
    if (!this.rendered) return null;
    const {width, height} = this.one;
    this.heat ??= heatImage(this.exact, this.rendered, this.result.answer, width, height, this.theme);
    return this.heat;
  }

  // `marks`: {selected, pixel, hover: what is chosen; overlay: for the rendered picture; axes: are
  // columns and rows numbered?}
  paint(plot, which, marks) {
    Object.assign(plot, {theme: this.theme});
    const {context} = plot;
    const {width, height} = this.one;
    const image = this.image(which);
    context.clearRect(0, 0, context.canvas.width, context.canvas.height);
    if (!image) return this.paintNothing(plot);
    context.save();
    context.beginPath();
    context.rect(plot.left, plot.top, plot.width, plot.height);
    context.clip();
    context.imageSmoothingEnabled = plot.scale < 1;
    const places = this.samplePlaces(which, plot);
    context.globalAlpha = places ? RESOLVED_ALPHA : 1;
    if (which === "rendered" && marks.overlay)
      marks.overlay.draw(plot, this.images.exact, image, width, height);
    else context.drawImage(image, plot.x(0), plot.y(height), width * plot.scale, height * plot.scale);
    context.globalAlpha = 1;
    drawGrids(plot, width, height);
    this.paintFigures(plot, which, marks, places);
    context.restore();
    if (marks.axes) drawAxes(plot, width, height);
  }

  paintFigures(plot, which, {selected, pixel, hover}, places) {
    const {one} = this;
    if (isDrawn("clip", one)) drawClipVolume(plot, one.viewport);
    if (Layers.shapes && (one.figure.length <= CROWD || plot.scale >= CROWD_FROM))
      this.paintShapes(plot, selected);
    if (Layers.markers && which === "verdicts") this.paintHalos(plot);
    else if (Layers.markers) this.paintMarkers(plot, selected, places !== null);
    if (Layers.rule && selected?.figure)
      drawFigure(plot, selected.figure, plot.scale >= 40 * plot.ratio);
    if (places) this.paintSamples(plot, which, selected, places);
    for (const place of [pixel, hover]) if (place) this.paintChosen(plot, place, place === hover);
  }

  // The primitives of the case; close to a disagreement, others than its own are dimmed.
  paintShapes(plot, selected) {
    const {figure} = this.one;
    const isClose = selected && plot.scale >= 11 * plot.ratio &&
      (selected.primitive !== undefined || figure.length > CROWD_NEAR);
    const isOther = ([role, , label]) => role === "primitive" && label !== String(selected.primitive);
    if (!isClose || !figure.some(isOther)) return drawFigure(plot, figure, false);
    plot.context.globalAlpha = DIMMED;
    drawFigure(plot, figure.filter(isOther), false);
    plot.context.globalAlpha = 1;
    drawFigure(plot, figure.filter((mark) => !isOther(mark)), false);
  }

  // Among samples, frames are thin, and the kind's shape stands at the sample that differs.
  paintMarkers(plot, chosen, sampled) {
    const {disagreements} = this.result.answer;
    this.paintHalos(plot);
    const atSample = (d) => sampled && d.sample !== undefined;
    plot.context.globalAlpha = chosen && plot.scale >= 11 * plot.ratio ? DIMMED : 1;
    for (const d of disagreements)
      if (d !== chosen) drawMarker(plot, d.x, d.y, d.kind, {bare: atSample(d), thin: sampled});
    plot.context.globalAlpha = 1;
    if (chosen)
      drawMarker(plot, chosen.x, chosen.y, chosen.kind,
        {strong: !sampled, bare: atSample(chosen) || (Layers.rule && chosen.figure)});
  }

  // Rings round what is worst where pixels are too small to be seen.
  paintHalos(plot) {
    const {disagreements} = this.result.answer;
    const worst = disagreements.filter((d) => d.legality === disagreements[0].legality);
    if (plot.scale < 5 * plot.ratio && worst.length <= FEW_HALOS) drawHalos(plot, worst);
  }

  // The places of the samples of a picture; null if its pixels are drawn whole.
  samplePlaces(which, plot) {
    const {exactSamples: exact, renderedSamples: rendered} = this;
    if (!Layers.samples || !exact || which === "verdicts" || (which !== "exact" && !rendered))
      return null;
    const places = which === "rendered" ? placesOf(rendered, exact) : placesOf(exact, rendered);
    return samplesFit(plot, places) ? places : null;
  }

  // The sample that the chosen one's rule decides is marked once more, over its dot.
  paintSamples(plot, which, selected, places) {
    const {one, exactSamples: exact, renderedSamples: rendered} = this;
    if (which === "exact") drawSamples(plot, one, exact, places);
    else if (which === "rendered") drawSamples(plot, one, rendered, places);
    else drawSampleDifference(plot, one, exact, rendered, places, this.listed);
    if (Layers.rule) selected?.figure?.filter(([role]) => role === "sample")
      .forEach((mark) => drawMark(plot, mark));
  }

  paintChosen(plot, place, isThin) {
    const box = new Path2D();
    box.rect(plot.x(place.x) - 1, plot.y(place.y + 1) - 1, plot.scale + 3, plot.scale + 3);
    strokeRimmed(plot, box, {color: "#ffffff", width: isThin ? 1 : 1.5});
  }

  paintNothing(plot) {
    const {context, ratio} = plot;
    context.fillStyle = this.theme.muted;
    context.font = 13 * ratio + "px system-ui, sans-serif";
    context.textAlign = "center";
    context.textBaseline = "middle";
    context.fillText("no picture", plot.left + plot.width / 2, plot.top + plot.height / 2);
  }

  // The smallest rectangle with all that is worst and a chosen pixel, and two pixels round it.
  worstBox(pixel) {
    const {one, result: {answer}} = this;
    const worst = answer.disagreements.filter((d, _, all) => d.legality === all[0].legality);
    if (!worst.length) return {left: 0, bottom: 0, right: one.width, top: one.height};
    if (pixel) worst.push(pixel);
    const [xs, ys] = [worst.map((d) => d.x), worst.map((d) => d.y)];
    return {left: Math.min(...xs) - 2, bottom: Math.min(...ys) - 2,
      right: Math.max(...xs) + 3, top: Math.max(...ys) + 3};
  }
}
