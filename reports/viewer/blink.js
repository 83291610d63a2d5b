// SPDX-License-Identifier: MIT
// Exact and rendered in one place: divided by a slider, or one after the other.

const BLINK = 600;  // milliseconds
const calm = matchMedia("(prefers-reduced-motion: reduce)");

// The content of the rendered picture's pane. `changed` is called when it has to be drawn again.
class Overlay {
  constructor(changed) {
    this.changed = changed;
    this.mode = "";       // "", "slider" or "blink"
    this.share = 0.5;     // of the width, from the left, that exact has
    this.exactNow = false;
    this.timer = 0;
    this.range = h("input", {
      type: "range", min: 0, max: 100, value: 50, hidden: true, "aria-label": "Share of exact",
      oninput: () => {
        this.share = Number(this.range.value) / 100;
        changed();
      },
    });
    const button = (mode, text, title) => h("button", {
      type: "button", title, "aria-pressed": "false", onclick: () => this.choose(mode),
    }, text);
    this.buttons = {
      slider: button("slider", "Slider", "Exact on the left, rendered on the right (w)"),
      blink: button("blink", "Blink", calm.matches
        ? "Exact or rendered, the other one each time (b)" : "Exact and rendered in turn (b)"),
    };
    this.element = h("span.group", {}, Object.values(this.buttons), this.range);
  }

  // Toggles a mode. If the user prefers no motion, each call blinks once.
  choose(mode) {
    const steps = mode === "blink" && calm.matches;
    if (steps && this.mode === "blink" && this.exactNow) this.exactNow = false;
    else if (steps && this.mode !== "blink") this.set("blink");
    else this.set(this.mode === mode ? "" : mode);
    this.changed();
  }

  set(mode) {
    clearInterval(this.timer);
    this.mode = mode;
    this.exactNow = mode === "blink";
    this.range.hidden = mode !== "slider";
    for (const [name, button] of Object.entries(this.buttons))
      button.setAttribute("aria-pressed", name === mode ? "true" : "false");
    if (mode === "blink" && !calm.matches) this.timer = setInterval(() => {
      this.exactNow = !this.exactNow;
      this.changed();
    }, BLINK);
  }

  stop() {
    clearInterval(this.timer);
  }

  // The pane's present title.
  title(usual) {
    if (this.mode === "slider") return "Exact | " + usual.toLowerCase();
    return this.mode === "blink" && this.exactNow ? "Exact (blinking)" : usual;
  }

  // Draws the pictures into the plot.
  draw(plot, exact, rendered, width, height) {
    const {context} = plot;
    const put = (image) => context.drawImage(image, plot.x(0), plot.y(height),
      width * plot.scale, height * plot.scale);
    put(this.mode === "blink" && this.exactNow ? exact : rendered);
    if (this.mode !== "slider") return;
    const split = plot.left + plot.width * this.share;
    context.save();
    context.beginPath();
    context.rect(plot.left, plot.top, split - plot.left, plot.height);
    context.clip();
    put(exact);
    context.restore();
    const line = new Path2D();
    line.moveTo(split, plot.top);
    line.lineTo(split, plot.top + plot.height);
    strokeRimmed(plot, line, {color: "#ffffff", width: 1.25});
  }
}
