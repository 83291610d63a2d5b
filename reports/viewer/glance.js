// SPDX-License-Identifier: MIT The live picture of a card.

const GLANCE = 9;      // pixels across, round what differs
const GLANCE_ALL = 14;  // images of at most this size are shown whole

// Exact, difference and rendered, small, that lead to their case.
class Glance {
  constructor(href, id) {
    this.canvases = ["exact", "difference", "rendered"].map((which) => h("canvas", {
      role: "img", "aria-label": which + " picture of " + id}));
    this.element = h("a.glance", {href, tabindex: "-1", "aria-label": "Open " + id},
      this.canvases.map((canvas, i) => h("span", {}, canvas,
        h("small", {}, ["exact", "difference", "rendered"][i]))));
  }

  show(one, result, d) {
    const painter = new Painter(one, result);
    const place = d || worstPlace(result.answer) || {x: one.width / 2, y: one.height / 2};
    const draw = () => ["exact", "difference", "rendered"].forEach((which, i) => {
      const canvas = this.canvases[i];
      const size = Math.round(canvas.clientWidth * ratioNow());
      if (!size) return;
      canvas.width = canvas.height = size;
      const view = new View(one.width, one.height);
      view.scale = View.fitting(one.width, one.height, size, size);
      if (Math.max(one.width, one.height) > GLANCE_ALL) {
        view.scale = Math.max(view.scale, Math.floor(size / GLANCE));
        view.look(place.x + 0.5, place.y + 0.5);
      }
      painter.paint(plotOf(canvas, view, NO_MARGIN), which, {selected: d || null, pixel: null, hover: null});
    });
    requestAnimationFrame(draw);
    this.colors = () => {
      painter.colors();
      draw();
    };
    Glance.shown = Glance.shown.filter((one) => one.element.isConnected);
    Glance.shown.push(this);
  }

  /** @type {Glance[]} on the page, to be drawn again in another theme */
  static shown = [];
}
