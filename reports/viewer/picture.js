// SPDX-License-Identifier: MIT
// The pictures of one result: exact, difference and rendered side by side, with one view, one
// pointer and one selection; and, where pixels are small, a close-up of the chosen one with the
// figure of its rule.

class Pictures {
  // onpick(x, y): a pixel was clicked; onzoom(zoom): the zoom changed, "" for the whole image.
  constructor(one, result, onpick, onzoom) {
    this.one = one;
    this.result = result;
    this.onpick = onpick;
    this.onzoom = onzoom;
    this.overlay = new Overlay(() => this.draw());
    this.view = new View(one.width, one.height);
    this.exact = exactPixels(one, result.answer);
    this.rendered = renderedPixels(one, result.answer, this.exact);
    this.exactSamples = exactSamples(one, result.answer);
    this.renderedSamples = renderedSamples(one, result.answer, this.exactSamples);
    this.listed = listedSamples(result.answer.disagreements);
    this.selected = null;   // a disagreement
    this.pixel = null;      // the chosen pixel {x, y}
    this.hover = null;
    this.width = 0;         // CSS pixels for all panes, once measured
    this.readout = h("div.readout.mono", {"aria-live": "off"});
    this.table = this.exactSamples && h("div.scroll.of-samples", {});
    this.scaleText = h("output.scale", {});
    const titles = ["Exact", "Difference", "Rendered by " + result.renderer,
      "Close-up of the difference"];
    this.panes = titles.map((title) => this.pane(title));
    this.panes[3].view = new View(one.width, one.height);
    this.element = h("section.pictures", {"aria-label": "Pictures"},
      this.tools(), h("div.panes", {}, this.panes.map((p) => p.element)), this.readout, this.table);
    this.onresize = () => {
      this.width = 0;
      this.measure();
      this.draw();
    };
    addEventListener("resize", this.onresize);
    this.colors();
  }

  destroy() {
    removeEventListener("resize", this.onresize);
    this.overlay.stop();
  }

  // Toggles "slider" or "blink" if there are two pictures.
  compare(mode) {
    if (this.rendered) this.overlay.choose(mode);
  }

  pane(title) {
    const canvas = h("canvas", {
      role: "img", "aria-label": title + ", " + this.one.width + " by " + this.one.height,
    });
    const pane = {title, canvas, image: null, caption: h("figcaption", {}, title)};
    pane.element = h("figure", {}, pane.caption, canvas);
    this.listen(pane);
    return pane;
  }

  // Creates the images in the colours of the present theme.
  colors() {
    const {width, height} = this.one;
    this.theme = themeColors();
    const kinds = new Map(this.result.answer.disagreements.map((d) =>
      [d.y * width + d.x, d.kind]));
    const rendered = this.rendered;
    this.panes[0].image = this.exact && imageOf(this.exact, width, height);
    this.panes[1].image =
      rendered && differenceImage(this.exact, rendered, width, height, kinds, this.theme);
    this.panes[2].image = rendered && imageOf(rendered, width, height);
    this.panes[3].image = this.panes[1].image;
  }

  tools() {
    const button = (text, label, act) =>
      h("button", {type: "button", title: label, "aria-label": label, onclick: act}, text);
    const layers = Object.keys(LAYER_NAMES).filter((id) => id !== "samples" || this.exactSamples);
    this.boxes = Object.fromEntries(layers.map((id) => [id, h("input", {
      type: "checkbox", checked: isDrawn(id, this.one), onchange: () => this.toggle(id),
    })]));
    const toggles = layers.map((id) => h("label", {
      title: id === "samples" && "Pixels as their samples, where they are large enough (s)",
    }, this.boxes[id], LAYER_NAMES[id]));
    return h("div.tools", {role: "toolbar", "aria-label": "View"},
      h("span.group", {},
        button("\u2212", "Smaller (-)", () => this.zoom(0.8)), this.scaleText,
        button("+", "Larger (+, or Ctrl and wheel)", () => this.zoom(1.25)),
        button("Fit", "Whole image (0)", () => this.fit()),
        button("Pixel", "Close to the chosen pixel (z)", () => this.close())),
      this.rendered && this.overlay.element, h("span.group", {}, toggles), this.legend());
  }

  // Shows a layer, or hides it.
  toggle(id) {
    if (!this.boxes[id]) return;
    Layers[id] = !isDrawn(id, this.one);
    this.boxes[id].checked = Layers[id];
    this.draw();
  }

  legend() {
    const kinds = Object.keys(KINDS).filter((kind) =>
      this.result.answer.disagreements.some((d) => d.kind === kind));
    return h("span.group.legend", {}, this.exactSamples && [
      h("span.key", {}, swatch("disc", null), "written sample"),
      h("span.key", {}, swatch("ring", null), "not written"),
    ], kinds.map(kindLabel));
  }

  // Sets the sizes of canvases: as high as the image needs at the available width, but so low that
  // the text above and the beginning of the list stay on the screen.
  measure() {
    if (this.width) return;  // the text above may change; the pictures keep their size
    const all = this.width = this.element.clientWidth;
    const across = (columns) => Math.floor((all - 12 * (columns - 1)) / columns);
    if (across(1) < 40) return;
    if (matchMedia("(max-width: 760px)").matches) return this.setSizes(across(1), false);
    const scale = this.fitScale(across(4), this.mostHeight(across(4)));
    const close = this.rendered !== null && scale < CLOSE_UP_BELOW;
    this.setSizes(across(close ? 4 : 3), close);
  }

  mostHeight(width) {
    const top = this.panes[0].element.getBoundingClientRect().top + scrollY;
    return Math.max(200, Math.min(width, innerHeight - top - 110));
  }

  // CSS pixels per image pixel when the whole image shows.
  fitScale(width, height) {
    const ratio = ratioNow();
    return View.fitting(this.one.width, this.one.height,
      (width - MARGIN.left - MARGIN.right - 6) * ratio,
      (height - MARGIN.top - MARGIN.bottom - 6) * ratio) / ratio;
  }

  setSizes(width, close) {
    const ratio = ratioNow();
    const most = this.mostHeight(width);
    const needed = this.fitScale(width, most) * this.one.height + MARGIN.top + MARGIN.bottom + 6;
    const height = Math.ceil(Math.min(most, Math.max(needed, close ? 230 : 180)));
    this.panes[3].element.hidden = !close;
    for (const {canvas} of this.panes) {
      canvas.style.width = width + "px";
      canvas.style.height = height + "px";
      canvas.width = Math.round(width * ratio);
      canvas.height = Math.round(height * ratio);
    }
  }

  plot(pane) {
    if (pane.view) return this.closePlot(pane);
    if (this.view.fitted) {
      const {width, height} = plotOf(pane.canvas, this.view);
      this.view.fit(width, height);
    }
    return Object.assign(plotOf(pane.canvas, this.view), {theme: this.theme});
  }

  closePlot(pane) {
    const place = this.pixel || {x: this.one.width / 2 - 0.5, y: this.one.height / 2 - 0.5};
    const {width, height} = plotOf(pane.canvas, pane.view);
    pane.view.scale = Math.max(1, Math.floor(Math.min(width, height) / CLOSE_UP));
    pane.view.look(place.x + 0.5, place.y + 0.5);
    return Object.assign(plotOf(pane.canvas, pane.view), {theme: this.theme});
  }

  draw() {
    for (const pane of this.panes) if (!pane.element.hidden) this.drawPane(pane);
    const scale = this.view.scale / ratioNow();
    this.scaleText.textContent =
      scale >= 1 ? "\u00d7" + Number(scale.toFixed(2)) : "1/" + Number((1 / scale).toFixed(2));
    this.tell();
  }

  drawPane(pane) {
    const plot = this.plot(pane);
    const {context} = plot;
    context.clearRect(0, 0, pane.canvas.width, pane.canvas.height);
    if (!pane.image) return this.drawNothing(plot);
    context.save();
    context.beginPath();
    context.rect(plot.left, plot.top, plot.width, plot.height);
    context.clip();
    context.imageSmoothingEnabled = plot.scale < 1;
    const {width, height} = this.one;
    const places = this.samplePlaces(pane, plot);
    context.globalAlpha = places ? RESOLVED_ALPHA : 1;
    if (pane === this.panes[2]) {
      this.overlay.draw(plot, this.panes[0].image, pane.image, width, height);
      replace(pane.caption, this.overlay.title(pane.title));
    } else {
      context.drawImage(pane.image, plot.x(0), plot.y(height), width * plot.scale,
        height * plot.scale);
    }
    context.globalAlpha = 1;
    drawGrids(plot, width, height);
    if (isDrawn("clip", this.one)) drawClipVolume(plot, this.one.viewport);
    if (Layers.shapes && (this.one.figure.length <= CROWD || plot.scale >= CROWD_FROM))
      drawFigure(plot, this.one.figure, false);
    if (Layers.markers) this.drawMarkers(plot, places !== null);
    this.drawRule(plot);
    if (places) this.drawSamples(pane, plot, places);
    this.drawChosen(plot);
    context.restore();
    drawAxes(plot, width, height);
  }

  // The places of a pane's samples; null if its pixels are drawn whole.
  samplePlaces(pane, plot) {
    const {exactSamples: exact, renderedSamples: rendered} = this;
    if (!Layers.samples || !exact || (pane !== this.panes[0] && !rendered)) return null;
    const places = pane === this.panes[2] ? placesOf(rendered, exact) : placesOf(exact, rendered);
    return samplesFit(plot, places) ? places : null;
  }

  // The sample that the chosen one's rule decides is marked once more, over its dot.
  drawSamples(pane, plot, places) {
    const {one, exactSamples: exact, renderedSamples: rendered} = this;
    if (pane === this.panes[0]) drawSamples(plot, one, exact, places);
    else if (pane === this.panes[2]) drawSamples(plot, one, rendered, places);
    else drawSampleDifference(plot, one, exact, rendered, places, this.listed);
    if (Layers.rule) this.selected?.figure?.filter(([role]) => role === "sample")
      .forEach((mark) => drawMark(plot, mark));
  }

  drawNothing(plot) {
    const {context, ratio} = plot;
    context.fillStyle = this.theme.muted;
    context.font = 13 * ratio + "px system-ui, sans-serif";
    context.textAlign = "center";
    context.textBaseline = "middle";
    context.fillText("no picture", plot.left + plot.width / 2, plot.top + plot.height / 2);
  }

  // Among samples, frames are thin, and the kind's shape stands at the sample that differs.
  drawMarkers(plot, sampled) {
    const chosen = this.selected;
    if (plot.scale < 5 * plot.ratio) drawHalos(plot, this.result.answer.disagreements);
    const atSample = (d) => sampled && d.sample !== undefined;
    for (const d of this.result.answer.disagreements)
      if (d !== chosen) drawMarker(plot, d.x, d.y, d.kind, {bare: atSample(d), thin: sampled});
    if (chosen)
      drawMarker(plot, chosen.x, chosen.y, chosen.kind,
        {strong: !sampled, bare: atSample(chosen) || (Layers.rule && chosen.figure)});
  }

  drawRule(plot) {
    const figure = this.selected?.figure;
    if (Layers.rule && figure) drawFigure(plot, figure, plot.scale >= 40 * plot.ratio);
  }

  drawChosen(plot) {
    for (const place of [this.pixel, this.hover]) {
      if (!place) continue;
      const box = new Path2D();
      box.rect(plot.x(place.x) - 1, plot.y(place.y + 1) - 1, plot.scale + 3, plot.scale + 3);
      strokeRimmed(plot, box, {color: "#ffffff", width: place === this.hover ? 1 : 1.5});
    }
  }

  // Chooses a disagreement (or, with null, only a pixel) and brings it into sight.
  select(disagreement, pixel) {
    this.selected = disagreement;
    this.pixel = pixel || (disagreement && {x: disagreement.x, y: disagreement.y});
    this.measure();
    this.bringIn();
    this.draw();
  }

  bringIn() {
    if (this.view.fitted || !this.pixel) return;
    const plot = this.plot(this.panes[0]);
    const x = plot.x(this.pixel.x + 0.5);
    const y = plot.y(this.pixel.y + 0.5);
    const inside = x > plot.left && x < plot.left + plot.width && y > plot.top &&
      y < plot.top + plot.height;
    if (!inside) this.view.look(this.pixel.x + 0.5, this.pixel.y + 0.5);
  }

  zoom(factor, around) {
    const chosen = this.pixel && {x: this.pixel.x + 0.5, y: this.pixel.y + 0.5};
    const place = around || chosen || this.view;
    const {scale, x, y} = this.view;
    this.view.zoom(factor);
    const kept = scale / this.view.scale;
    this.view.look(place.x + (x - place.x) * kept, place.y + (y - place.y) * kept);
    this.draw();
    this.onzoom(String(Number((this.view.scale / ratioNow()).toFixed(3))));
  }

  fit() {
    this.view.fitted = true;
    this.draw();
    this.onzoom("");
  }

  // Zooms to a number of screen pixels per pixel around the chosen pixel, as given in a link.
  zoomTo(scale) {
    if (!(scale > 0)) return;
    this.view.scale = Math.min(scale * ratioNow(), MAX_SCALE);
    if (this.view.scale > 1) this.view.scale = Math.round(this.view.scale);
    const place = this.pixel || {x: this.one.width / 2 - 0.5, y: this.one.height / 2 - 0.5};
    this.view.look(place.x + 0.5, place.y + 0.5);
    this.draw();
  }

  // Zooms in until the figure of the chosen pixel's rule is large.
  close() {
    const place = this.pixel || {x: Math.floor(this.view.x), y: Math.floor(this.view.y)};
    const {width, height} = plotOf(this.panes[0].canvas, this.view);
    this.view.scale = Math.min(MAX_SCALE, Math.floor(Math.min(width, height) / 4));
    this.view.look(place.x + 0.5, place.y + 0.5);
    this.draw();
    this.onzoom(String(this.view.scale / ratioNow()));
  }

  placeOf(pane, event) {
    const box = pane.canvas.getBoundingClientRect();
    const plot = plotOf(pane.canvas, pane.view || this.view);
    const ratio = ratioNow();
    const x = plot.column((event.clientX - box.left) * ratio);
    const y = plot.row((event.clientY - box.top) * ratio);
    const inside = x >= 0 && y >= 0 && x < this.one.width && y < this.one.height;
    return {x, y, pixel: inside ? {x: Math.floor(x), y: Math.floor(y)} : null};
  }

  listen(pane) {
    const {canvas} = pane;
    let drag = null;
    canvas.addEventListener("pointerdown", (event) => {
      const {x, y} = this.view;
      drag = {x: event.clientX, y: event.clientY, viewX: x, viewY: y, far: false};
      canvas.setPointerCapture(event.pointerId);
    });
    canvas.addEventListener("pointermove", (event) => {
      if (drag && !pane.view) this.pan(drag, event);
      const place = this.placeOf(pane, event);
      this.point(place.pixel, place, pane);
    });
    canvas.addEventListener("pointerup", (event) => {
      const {pixel} = this.placeOf(pane, event);
      if (drag && !drag.far && pixel) this.onpick(pixel.x, pixel.y);
      drag = null;
    });
    canvas.addEventListener("pointercancel", () => { drag = null; });
    canvas.addEventListener("pointerleave", () => this.point(null, null, pane));
    canvas.addEventListener("wheel", (event) => {
      if (pane.view || (!event.ctrlKey && !event.metaKey)) return;
      event.preventDefault();
      this.zoom(event.deltaY < 0 ? 1.25 : 0.8, this.placeOf(pane, event));
    }, {passive: false});
  }

  pan(drag, event) {
    const ratio = ratioNow();
    const right = (event.clientX - drag.x) * ratio;
    const down = (event.clientY - drag.y) * ratio;
    if (!drag.far && Math.hypot(right, down) < 4 * ratio) return;
    drag.far = true;
    this.view.look(drag.viewX - right / this.view.scale, drag.viewY + down / this.view.scale);
  }

  point(pixel, place, pane) {
    this.hover = pixel;
    const reach = 7 * ratioNow() / (pane.view || this.view).scale;
    this.near = place && vertexNear(this.one.figure, place, reach);
    this.draw();
  }

  colorOf(pixels, {x, y}) {
    const at = 4 * (y * this.one.width + x);
    return pixels && Array.from(pixels.subarray(at, at + 4));
  }

  // Writes one line about the pixel under the pointer, or else the chosen one.
  tell() {
    const pixel = this.hover || this.pixel;
    if (!pixel) return void replace(this.readout, "Point at a pixel to read it.");
    const exact = this.colorOf(this.exact, pixel);
    const rendered = this.colorOf(this.rendered, pixel);
    const text = (name, color) => h("span", {}, name + " " +
      (color ? color.join(" ") + " " + bytesHex(color) : "none"));
    if (this.table) replace(this.table, sampleTable(this.exactSamples, this.renderedSamples, pixel,
      {exact, rendered}));
    replace(this.readout,
      h("b", {}, "(" + pixel.x + ", " + pixel.y + ")"),
      h("span", {}, "centre (" + (pixel.x + 0.5) + ", " + (pixel.y + 0.5) + ")"),
      !this.table && [text("exact", exact), text("rendered", rendered)],
      isDrawn("clip", this.one) && h("span", {}, clipWords(this.one.viewport)),
      this.near && h("span.near", {}, [this.near.role.replace("-", " "), this.near.label, "at",
        coordinate(this.near.x) + ", " + coordinate(this.near.y)].filter(Boolean).join(" ")));
  }
}
