// SPDX-License-Identifier: MIT The details of cases: lines of deflated blocks, which are in the
// page after the script, or in scripts beside it (reports/report_data.h).

const BLOCKS_KEPT = 8;  // inflated

const Blocks = {
  waiting: new Map(),   // number of a block -> its pending requests
  arrived: new Map(),   // number -> base64, of blocks from scripts beside the page
  inflated: new Map(),  // number -> promise of its lines; the last used last

  // The number of the block that holds a line.
  numberOf(line) {
    let number = Data.blocks.length - 1;
    while (number > 0 && Data.blocks[number] > line) --number;
    return number;
  },

  // The promise of a line's text.
  async line(line) {
    const number = Blocks.numberOf(line);
    const lines = Blocks.inflated.get(number) || Blocks.packed(number).then(inflatedLines);
    Blocks.inflated.delete(number);
    Blocks.inflated.set(number, lines);
    lines.catch(() => Blocks.inflated.delete(number));
    if (Blocks.inflated.size > BLOCKS_KEPT)
      Blocks.inflated.delete(Blocks.inflated.keys().next().value);
    return (await lines)[line - Data.blocks[number]];
  },

  // Is the block that holds a line in the page itself?
  isHere(line) {
    return Blocks.numberOf(line) < Data.here;
  },

  // Reads the block of a line in advance if it is in the page itself.
  readAhead(line) {
    if (Blocks.isHere(line)) Blocks.line(line).catch(() => {});
  },

  async packed(number) {
    if (Blocks.arrived.has(number)) return Blocks.arrived.get(number);
    const chunk = Data.chunks.findLast((one) => one.first <= number);
    if (chunk) return Blocks.load(chunk.name, number);
    if (number >= Data.here)
      throw new Error("there was no room for them on this page; write it with --all-details");
    if (!byId("block-" + number) && document.readyState === "loading")
      await new Promise((then) => document.addEventListener("DOMContentLoaded", then));
    return byId("block-" + number).textContent;
  },

  // Loads blocks from a script beside the page, which calls edgecaseBlocks.
  load(name, number) {
    return new Promise((then, fail) => {
      const script = document.createElement("script");
      script.src = name.split("/").map(encodeURIComponent).join("/");
      script.onload = () => {
        script.remove();
        if (Blocks.arrived.has(number)) then(Blocks.arrived.get(number));
        else fail(new Error(name + " belongs to another report; write the report again"));
      };
      script.onerror = () => fail(new Error(name + " is not beside this page; copy it too, or write the report again"));
      document.head.append(script);
    });
  },
};

// Called by scripts beside the page.
function edgecaseBlocks(key, first, blocks) {
  if (key !== Data.key) return;
  blocks.forEach((block, i) => Blocks.arrived.set(first + i, block));
}

async function inflatedLines(base64) {
  const stream = new DecompressionStream("deflate");
  const writer = stream.writable.getWriter();
  const written = writer.write(bytesOf(base64)).then(() => writer.close());
  const text = await new Response(stream.readable).text();
  await written;
  return text.split("\n");
}

const NO_ANSWER = {fingerprint: "", disagreements: [], values: [], evidence: [],
  illegal_line_snaps: []};

// The text of a case's file, or "".
async function sourceText(one) {
  return one.sourceLine === undefined ? "" : JSON.parse(await Blocks.line(one.sourceLine));
}

// Adds the details to a case and its results, once. Cases in which all agree have none.
async function loadDetails(one) {
  if (one.loaded) return one;
  const details = one.line === undefined ? {} : JSON.parse(await Blocks.line(one.line));
  one.pixels = details.pixels || "";
  one.samples = details.samples;
  one.figure = details.figure || [];
  one.viewport = details.viewport || [0, 0, one.width, one.height];
  one.expect_failures = details.expect_failures || [];
  one.results.forEach((result, r) => {
    const own = details.results?.[r];
    Object.assign(result, own || {standing_reason: ""});
    result.answer = own ? details.answers[own.answer] : NO_ANSWER;
  });
  one.loaded = true;
  return one;
}
