// SPDX-License-Identifier: MIT
// The page that draws one case on the device beside exact, with a magnifier, for teaching.

/**
 * @typedef {{mode: string, title: string, id: string, why: string, scene: Scene,
 *   exact: Answer}} ShownCase
 */

const ZOOMS = [1, 2, 4, 8, 12, 16, 24, 32, 48, 64];
const MOST_OF_SCREEN = 0.7;  // of its height, for a picture that is not as wide as its room

class Pane {
  /** @param {string} name @param {Scene} scene @param {Answer} rendering */
  constructor(name, scene, rendering, other) {
    this.scene = scene;
    this.rendering = rendering;
    this.other = other;
    this.element = document.createElement("figure");
    const caption = document.createElement("figcaption");
    caption.textContent = name;
    this.canvas = document.createElement("canvas");
    this.canvas.setAttribute("role", "img");
    this.canvas.setAttribute("aria-label", `What ${name} draws`);
    this.box = document.createElement("div");
    this.box.className = "scroll";
    this.box.append(this.canvas);
    this.element.append(caption, this.box);
  }

  /** The magnification, in CSS pixels, with which the picture fills its room. */
  fitting() {
    const {width, height} = this.scene.target;
    const room = this.box.clientWidth;
    return Math.max(1, Math.min(room / width, Math.max(room, MOST_OF_SCREEN * innerHeight) / height));
  }

  draw(magnification, chosen) {
    const {width, height} = this.scene.target;
    const zoom = Math.ceil(magnification);
    this.canvas.width = width * zoom;
    this.canvas.height = height * zoom;
    this.canvas.style.width = `${width * magnification}px`;
    const context = this.canvas.getContext("2d");
    for (let y = 0; y < height; ++y)
      for (let x = 0; x < width; ++x) {
        const at = 4 * (y * width + x);
        const [red, green, blue] = this.rendering.pixels.slice(at, at + 3);
        context.fillStyle = `rgb(${red} ${green} ${blue})`;
        const [left, top] = [x * zoom, (height - 1 - y) * zoom];
        context.fillRect(left, top, zoom, zoom);
        if (zoom < 4) continue;
        const differs = [0, 1, 2, 3].some(
          (i) => this.rendering.pixels[at + i] !== this.other.pixels[at + i]);
        if (differs) this.frame(context, left, top, zoom, "#e5007d", 2);
        if (chosen && chosen[0] === x && chosen[1] === y)
          this.frame(context, left, top, zoom, "#ffb000", 3);
      }
  }

  frame(context, left, top, zoom, color, width) {
    context.strokeStyle = color;
    context.lineWidth = width;
    context.strokeRect(left + width / 2, top + width / 2, zoom - width, zoom - width);
  }

  /** The pixel at a place of the canvas. @param {MouseEvent} event */
  pixelAt(event) {
    const {width, height} = this.scene.target;
    const zoom = this.canvas.clientWidth / width;
    return [Math.floor(event.offsetX / zoom), height - 1 - Math.floor(event.offsetY / zoom)];
  }

  textAt([x, y]) {
    const here = (this.rendering.fragments || []).filter((f) => f.x === x && f.y === y);
    const at = 4 * (y * this.scene.target.width + x);
    const fragments = here.map((f) => `primitive ${f.primitive}, depth ${f.depth}, colour ${
      (f.color || []).map((value) => Number(value).toPrecision(6)).join(" ")}`);
    return `pixel ${this.rendering.pixels.slice(at, at + 4).join(" ")}; ` +
      (fragments.join("; ") || "no fragment");
  }
}

class ShowPage {
  /** @param {ShownCase} data */
  constructor(data) {
    this.data = data;
    this.device = new Device();
    this.chosen = null;
    this.zoom = 0;  // what fits
  }

  begin() {
    const {data} = this;
    byId("progress").hidden = true;
    byId("title").textContent = data.id;
    byId("word").textContent = data.title;
    const problem = this.device.open();
    const answer = problem ? {not_run: problem} : this.device.answer(
      {edgecase: PROTOCOL_VERSION, id: data.id, digest: "", scene: data.scene}) || {not_run: LOST};
    document.body.dataset.state = answer.not_run === undefined ? "done" : "failed";
    if (this.device.claims) {
      byId("device").textContent = this.device.claims.device;
      byId("browser").textContent = this.device.claims.traits.browser;
    }
    if (answer.not_run !== undefined) {
      byId("word").textContent = `This device does not draw it: ${answer.not_run}.`;
      return;
    }
    this.panes = [new Pane("exact", data.scene, data.exact, answer),
      new Pane("this device", data.scene, answer, data.exact)];
    byId("panes").replaceChildren(...this.panes.map((pane) => pane.element));
    this.addZoom();
    for (const pane of this.panes)
      pane.canvas.onclick = (event) => this.choose(pane.pixelAt(event));
    addEventListener("resize", () => this.setZoom(this.zoom));
    this.choose(null);
  }

  addZoom() {
    const button = (text, label, next) => {
      const element = document.createElement("button");
      element.textContent = text;
      element.setAttribute("aria-label", label);
      element.onclick = () => this.setZoom(next(this.zoom || this.panes[0].fitting()) || this.zoom);
      return element;
    };
    byId("zoom").replaceChildren(
      button("\u2212", "smaller", (now) => ZOOMS.findLast((zoom) => zoom < now)),
      button("+", "larger", (now) => ZOOMS.find((zoom) => zoom > now)));
  }

  /** @param {number} zoom CSS pixels of one pixel, or 0 for what fits */
  setZoom(zoom) {
    this.zoom = zoom;
    for (const pane of this.panes) pane.draw(zoom || pane.fitting(), this.chosen);
  }

  choose(pixel) {
    this.chosen = pixel;
    this.setZoom(this.zoom);
    const [exact, device] = this.panes;
    const differing = this.data.exact.pixels.reduce((found, value, i) =>
      value === device.rendering.pixels[i] ? found : found.add(i >> 2), new Set()).size;
    byId("counts").replaceChildren(...(pixel
      ? [row(`(${pixel.join(", ")}) exact`, exact.textAt(pixel)),
        row(`(${pixel.join(", ")}) this device`, device.textAt(pixel))]
      : [row("pixels that differ", String(differing)), row("tap a pixel", "its fragments")]));
  }
}
