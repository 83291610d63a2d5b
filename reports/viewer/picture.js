// SPDX-License-Identifier: MIT
// The pictures of one result, with one pointer and one selection. Ordinary cases have exact,
// difference and rendered side by side in one view. Whole scenes have the verdicts of all pixels
// large, and multisampled cases the disputed pixel with its samples; exact and rendered stand beside
// these. One more picture, for the column of text, shows what the others do not: the disputed
// pixel from close by, or all of the image.

const SCENE_FROM = 96;  // pixels of width or height

const PANE_TITLES = {exact: "Exact", difference: "Difference", rendered: "Rendered", verdicts: "Verdicts"};

// Which pictures a case has: {main: is the first one large?, shown, how: the first view, side: that of
// the picture beside the text}.
function layoutOf(one, rendered) {
  if (one.samples) return {main: true, shown: ["difference", "exact", "rendered"], how: "close", side: "fit"};
  if (rendered && Math.max(one.width, one.height) >= SCENE_FROM)
    return {main: true, shown: ["verdicts", "exact", "rendered"], how: "fit", side: "close"};
  return {main: false, shown: ["exact", "difference", "rendered"], how: "frame", side: "close"};
}

class Pictures {
  // onpick(x, y): a pixel was clicked; onzoom(zoom): the zoom changed, "" for the whole image.
  constructor(one, result, onpick, onzoom) {
    this.one = one;
    this.result = result;
    this.onpick = onpick;
    this.onzoom = onzoom;
    this.painter = new Painter(one, result);
    this.overlay = new Overlay(() => this.draw());
    this.layout = layoutOf(one, this.painter.rendered);
    this.view = new View(one.width, one.height);
    this.view.how = this.layout.how;
    this.selected = null;   // a disagreement
    this.pixel = null;      // the chosen pixel {x, y}
    this.hover = null;
    this.width = 0;         // CSS pixels for all panes, once measured
    this.readout = h("div.readout.mono", {"aria-live": "off"});
    this.table = this.painter.exactSamples && h("div.scroll.of-samples", {tabindex: "0", role: "region",
      "aria-label": "Samples in numbers"});
    this.scaleText = h("output.scale", {});
    this.panes = this.layout.shown.map((which) => this.pane(which));
    this.side = this.pane("difference");
    this.side.view = new View(one.width, one.height);
    this.side.view.how = this.layout.side;
    this.side.title = this.layout.side === "close" ? "Close-up of the difference" : "All of the image";
    this.strip = h("div.panes", {class: this.layout.main ? "with-main" : "", tabindex: "0", role: "group",
      "aria-label": "Pictures side by side"}, this.panes.map((p) => p.element));
    this.element = h("section.pictures", {"aria-label": "Pictures"},
      this.tools(), this.strip, this.readout, this.table);
    this.onresize = () => {
      this.width = 0;
      this.measure();
      this.draw();
    };
    addEventListener("resize", this.onresize);
  }

  destroy() {
    removeEventListener("resize", this.onresize);
    this.overlay.stop();
  }

  colors() {
    this.painter.colors();
  }

  // Toggles "slider" or "blink" if there are two pictures.
  compare(mode) {
    if (this.painter.rendered) this.overlay.choose(mode);
  }

  pane(which) {
    const title = PANE_TITLES[which] + (which === "rendered" ? " by " + this.result.renderer : "");
    const canvas = h("canvas", {
      role: "img", "aria-label": title + ", " + this.one.width + " by " + this.one.height,
    });
    const pane = {which, title, canvas, view: null, caption: h("figcaption", {}, title)};
    pane.element = h("figure", {class: "of-" + which}, pane.caption, canvas);
    this.listen(pane);
    return pane;
  }

  tools() {
    const button = (text, label, act) =>
      h("button", {type: "button", title: label, "aria-label": label, onclick: act}, text);
    const layers = Object.keys(LAYER_NAMES)
      .filter((id) => id !== "samples" || this.painter.exactSamples);
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
      this.painter.rendered && this.overlay.element,
      h("details.layers", {}, h("summary", {}, "Layers"), h("div", {}, toggles)), this.legend());
  }

  // Shows a layer, or hides it.
  toggle(id) {
    if (!this.boxes[id]) return;
    Layers[id] = !isDrawn(id, this.one);
    this.boxes[id].checked = Layers[id];
    this.draw();
  }

  legend() {
    const {answer} = this.result;
    const kinds = Object.keys(KINDS).filter((kind) =>
      answer.disagreements.some((d) => d.kind === kind));
    return h("span.group.legend", {}, this.painter.exactSamples && [
      h("span.key", {}, swatch("disc", null), "written sample"),
      h("span.key", {}, swatch("ring", null), "not written"),
    ], this.layout.shown[0] === "verdicts" ? PIXEL_VERDICTS.slice(1)
      .filter((verdict) => this.result.pixel_counts?.[verdict])
      .map((verdict) => h("span.key", {}, h("i.swatch", {class: "h-" + verdict}), verdict))
      : kinds.map(kindLabel));
  }

  // Sets the sizes of canvases: at least LEAST_HEIGHT high, and within the screen if that allows.
  measure() {
    if (this.width) return;  // the text may change; the pictures keep their size
    const all = this.width = this.element.clientWidth;
    if (all < 40) return;
    const top = this.strip.getBoundingClientRect().top + scrollY;
    const room = innerHeight - top - 64;
    if (isNarrow()) for (const pane of this.panes) this.setSize(pane, all - 12, all - 12);
    else if (this.layout.main) this.setMain(all, room);
    else {
      const width = Math.floor((all - 24) / 3);
      const height = Math.max(LEAST_HEIGHT, Math.min(room, Math.round(1.45 * width)));
      for (const pane of this.panes) this.setSize(pane, width, height);
    }
    const beside = this.side.element.parentElement?.clientWidth || 280;
    this.setSize(this.side, beside, isNarrow() ? beside : Math.min(beside, 240));
  }

  // The first picture takes what it needs to be large; the others share the rest, one above another.
  setMain(all, room) {
    const isScene = this.layout.shown[0] === "verdicts";
    const least = isScene ? LEAST_SCENE + MARGIN.left + MARGIN.right + 6 : LEAST_HEIGHT;
    const width = Math.max(least, Math.min(Math.round(0.6 * all), Math.max(room, least)));
    const height = Math.max(isScene ? LEAST_SCENE + MARGIN.top + MARGIN.bottom + 6 : LEAST_HEIGHT,
      Math.min(room, width));
    this.setSize(this.panes[0], width, height);
    const caption = 26;
    for (const pane of this.panes.slice(1))
      this.setSize(pane, all - width - 12, Math.floor((height - 12 - caption) / 2));
  }

  setSize({canvas}, width, height) {
    const ratio = ratioNow();
    canvas.style.width = width + "px";
    canvas.style.height = height + "px";
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(height * ratio);
  }

  plot(pane) {
    const view = pane.view || this.view;
    const {width, height} = plotOf(pane.canvas, view);
    // Beside the verdicts of a scene, exact and rendered show the disputed pixel.
    const how = view.how === "fit" && !pane.view && pane !== this.panes[0] && this.layout.main &&
      this.pixel ? "near" : view.how;
    const own = how === "near" ? Object.assign(new View(view.columns, view.rows), view) : view;
    if (how === "fit") own.fit(width, height);
    else if (how === "frame") own.frame(this.painter.worstBox(this.pixel), width, height);
    else if (how) {
      const place = this.pixel || {x: this.one.width / 2 - 0.5, y: this.one.height / 2 - 0.5};
      const across = how === "close" ? CLOSE_UP : NEAR;
      own.scale = Math.max(1, Math.floor(Math.min(width, height) / across));
      own.x = place.x + 0.5;
      own.y = place.y + 0.5;
    }
    return plotOf(pane.canvas, own);
  }

  draw() {
    for (const pane of [...this.panes, this.side]) if (pane.canvas.width) this.drawPane(pane);
    this.plot(this.panes[0]);
    const scale = this.view.scale / ratioNow();
    this.scaleText.textContent =
      scale >= 1 ? "\u00d7" + Number(scale.toFixed(2)) : "1/" + Number((1 / scale).toFixed(2));
    this.tell();
  }

  drawPane(pane) {
    const {selected, pixel, hover, overlay} = this;
    this.painter.paint(this.plot(pane), pane.which, {selected, pixel, hover, axes: true,
      overlay: pane.which === "rendered" ? overlay : null});
    if (pane.which === "rendered") replace(pane.caption, overlay.title(pane.title));
    if (pane === this.side) replace(pane.caption, pane.title);
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
    if (this.view.how || !this.pixel) return;
    const plot = this.plot(this.panes[0]);
    const x = plot.x(this.pixel.x + 0.5);
    const y = plot.y(this.pixel.y + 0.5);
    const inside = x > plot.left && x < plot.left + plot.width && y > plot.top &&
      y < plot.top + plot.height;
    if (!inside) this.view.look(this.pixel.x + 0.5, this.pixel.y + 0.5);
  }

  zoom(factor, around) {
    this.plot(this.panes[0]);
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
    this.view.how = "fit";
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
    this.pixel ??= {x: Math.floor(this.view.x), y: Math.floor(this.view.y)};
    this.view.how = "close";
    this.draw();
    this.onzoom(String(Number((this.view.scale / ratioNow()).toFixed(3))));
  }

  placeOf(pane, event) {
    const box = pane.canvas.getBoundingClientRect();
    const plot = this.plot(pane);
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
      if (drag && !pane.view && event.pointerType !== "touch") this.pan(drag, event);
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
    const reach = 7 * ratioNow() / this.plot(pane).scale;
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
    const {exactSamples, renderedSamples} = this.painter;
    const exact = this.colorOf(this.painter.exact, pixel);
    const rendered = this.colorOf(this.painter.rendered, pixel);
    const text = (name, color) => h("span", {}, name + " " +
      (color ? color.join(" ") + " " + bytesHex(color) : "none"));
    if (this.table) replace(this.table, sampleTable(exactSamples, renderedSamples, pixel,
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
