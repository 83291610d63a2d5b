// SPDX-License-Identifier: MIT
// The page that draws a suite on the device, shows how it goes, and hands back a recording.

/**
 * @typedef {{mode: string, tool: string, title: string, count: number, blocks: string[]}} PageData
 * @typedef {{id: string, digest: string, scene: Scene, hits: number[]|null}} PageCase
 */

const SLICE = 40;  // milliseconds between two looks at the screen
const MOST_REASONS = 12;

const byId = (id) => document.getElementById(id);

function fromBase64(text) {
  return Uint8Array.from(atob(text), (character) => character.charCodeAt(0));
}

/** The cases of a block: a line of JSON each. @returns {Promise<PageCase[]>} */
async function casesOf(block) {
  const text = new TextDecoder().decode(await inflate(fromBase64(block)));
  return text.trimEnd().split("\n").map((line) => {
    const [id, digest, scene, hits] = JSON.parse(line);
    return {id, digest, scene, hits};
  });
}

/** Does the answer have as many fragments at each pixel as exact? Nothing where that is not told.
 * @param {PageCase} one @param {Answer} answer */
function agreesWithExact(one, answer) {
  if (!one.hits || !answer.fragments) return undefined;
  const {width, height} = one.scene.target;
  const counts = new Uint32Array(width * height);
  for (const fragment of answer.fragments) ++counts[fragment.y * width + fragment.x];
  let at = 0;
  for (let i = 0; i < one.hits.length; i += 2)
    for (let run = one.hits[i + 1]; run > 0; --run)
      if (counts[at++] !== one.hits[i]) return false;
  return true;
}

class RunPage {
  /** @param {PageData} data */
  constructor(data) {
    this.data = data;
    this.device = new Device();
    this.writer = new RecordingWriter();
    this.counts = {drawn: 0, agree: 0, differ: 0, "not supported": 0, "lost contexts": 0};
    this.reasons = new Map();
    this.done = 0;
    this.state = "ready";
  }

  begin() {
    byId("title").textContent = this.data.title;
    const problem = typeof CompressionStream === "undefined"
      ? "this browser is too old: it has no CompressionStream" : this.device.open();
    if (problem) return this.tell("failed", `Nothing can be drawn here: ${problem}.`);
    byId("device").textContent = this.device.claims.device;
    byId("browser").textContent = this.device.claims.traits.browser;
    this.tell("ready", `${this.data.count} cases wait to be drawn by this device.`);
    byId("start").hidden = false;
    byId("start").onclick = () => this.run();
    byId("save").onclick = () => this.save();
    if (location.hash === "#go") this.run();
  }

  tell(state, text) {
    this.state = state;
    document.body.dataset.state = state;
    byId("word").textContent = text;
  }

  async run() {
    byId("start").hidden = true;
    byId("save").hidden = false;
    addEventListener("beforeunload", (event) => {
      if (this.state === "drawing") event.preventDefault();
    });
    this.tell("drawing", "Drawing. Keep this page open.");
    const begun = performance.now();
    let shown = begun;
    for (const block of this.data.blocks)
      for (const one of await casesOf(block)) {
        if (!(await this.draw(one))) return this.giveUp();
        if (performance.now() - shown < SLICE) continue;
        this.show();
        await pause(0);
        shown = performance.now();
      }
    this.show();
    const seconds = ((performance.now() - begun) / 1000).toFixed(1);
    this.tell("done", `All ${this.data.count} cases are drawn, in ${seconds} s. ` +
      "Save the recording and hand it on.");
  }

  giveUp() {
    this.show();
    this.tell("stopped", `The context was lost and no other one could be had: ${this.done} of ${
      this.data.count} cases are drawn. They can be saved.`);
  }

  /** False if the device is lost for good. @param {PageCase} one */
  async draw(one) {
    const answer = this.device.answer({edgecase: PROTOCOL_VERSION, ...one});
    ++this.done;
    if (answer === null) {
      ++this.counts["lost contexts"];
      this.note(LOST);
      this.writer.add(one.id, one.digest, failureLine("crashed", LOST));
      return this.device.reopen();
    }
    if (answer.not_run !== undefined) {
      ++this.counts["not supported"];
      this.note(answer.not_run);
    } else {
      ++this.counts.drawn;
      const agrees = agreesWithExact(one, answer);
      if (agrees !== undefined) ++this.counts[agrees ? "agree" : "differ"];
    }
    this.writer.add(one.id, one.digest, storedLine(answer));
    return true;
  }

  note(reason) {
    this.reasons.set(reason, (this.reasons.get(reason) || 0) + 1);
  }

  show() {
    const progress = /** @type {HTMLProgressElement} */ (byId("progress"));
    progress.max = this.data.count;
    progress.value = this.done;
    byId("counts").replaceChildren(...Object.entries(this.counts).map(([name, count]) =>
      row(name, String(count))));
    const sorted = [...this.reasons].sort((a, b) => b[1] - a[1]).slice(0, MOST_REASONS);
    byId("reasons").replaceChildren(...sorted.map(([reason, count]) => row(reason, String(count))));
  }

  recording() {
    return this.writer.file(this.data.tool, this.device.name, this.device.claims,
      this.done === this.data.count);
  }

  async save() {
    const file = await this.recording();
    const link = document.createElement("a");
    link.href = URL.createObjectURL(new Blob([file], {type: "application/octet-stream"}));
    link.download = this.device.name.replace(":", "-") + ".rec";
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 60000);
  }
}

function row(name, value) {
  const line = document.createElement("tr");
  for (const [tag, text] of [["th", name], ["td", value]]) {
    const cell = document.createElement(tag);
    cell.textContent = text;
    if (tag === "th") cell.scope = "row";
    line.append(cell);
  }
  return line;
}
