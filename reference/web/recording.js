// SPDX-License-Identifier: MIT
// The file that a page hands back: a recording (src/recording/recording.h), which stands in for this
// device in every command that takes a renderer.

const RECORDING_MAGIC = "edgecase-recording 1\n";
const BLOCK_BYTES = 1 << 20;  // of answers; a block is deflated as one

const CRC_TABLE = Uint32Array.from({length: 256}, (_, n) => {
  for (let bit = 0; bit < 8; ++bit) n = n & 1 ? 0xedb88320 ^ (n >>> 1) : n >>> 1;
  return n;
});

/** CRC-32 as in zlib. @param {Uint8Array} bytes */
function crc32(bytes) {
  let crc = 0xffffffff;
  for (const byte of bytes) crc = CRC_TABLE[(crc ^ byte) & 0xff] ^ (crc >>> 8);
  return (crc ^ 0xffffffff) >>> 0;
}

/** @param {Uint8Array} bytes */
async function through(bytes, transform) {
  const stream = new Blob([/** @type {BlobPart} */ (bytes)]).stream().pipeThrough(transform);
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

const deflate = (bytes) => through(bytes, new CompressionStream("deflate"));
const inflate = (bytes) => through(bytes, new DecompressionStream("deflate"));

/** Seven bits a byte, the lowest first. */
function sizeBytes(size) {
  const bytes = [];
  for (; size >= 0x80; size = Math.floor(size / 0x80)) bytes.push((size % 0x80) | 0x80);
  return [...bytes, size];
}

function joined(parts) {
  const all = new Uint8Array(parts.reduce((sum, part) => sum + part.length, 0));
  let at = 0;
  for (const part of parts) {
    all.set(part, at);
    at += part.length;
  }
  return all;
}

const utf8 = (text) => new TextEncoder().encode(text);

async function deflatedStretch(text) {
  const bytes = utf8(text);
  const small = await deflate(bytes);
  return joined([sizeBytes(bytes.length), sizeBytes(small.length), small]);
}

const stretchOf = (bytes) => ({size: bytes.length, crc: crc32(bytes)});

/** Collects answers in the order of their cases' ids. */
class RecordingWriter {
  constructor() {
    /** @type {Promise<{scenes: string[], bytes: Uint8Array}>[]} */
    this.blocks = [];
    this.scenes = [];
    this.lines = [];
    this.bytes = 0;
  }

  /** @param {string} line an answer without a digest, or a failure */
  add(id, digest, line) {
    // A long answer has a block to itself, since reading one means reading the block.
    if (this.bytes + line.length > BLOCK_BYTES) this.endBlock();
    this.scenes.push(id, digest);
    this.lines.push(line);
    this.bytes += line.length;
    if (this.bytes >= BLOCK_BYTES) this.endBlock();
  }

  // All numbers stay in the text: no columns follow it.
  endBlock() {
    if (this.lines.length === 0) return;
    const {scenes, lines} = this;
    [this.scenes, this.lines, this.bytes] = [[], [], 0];
    this.blocks.push(deflatedStretch(lines.map((line) => line + "\n").join(""))
      .then((text) => ({scenes, bytes: joined([text, sizeBytes(0)])})));
  }

  /** The whole file. @param {Claims} claims */
  async file(tool, name, claims, complete) {
    this.endBlock();
    const blocks = await Promise.all(this.blocks);
    const head = utf8(RECORDING_MAGIC +
      toJson({tool, complete, renderer: {name, ...claims}}) + "\n");
    const index = await deflatedStretch(toJson({head: stretchOf(head),
      blocks: blocks.map(({scenes, bytes}) => ({...stretchOf(bytes), scenes}))}));
    const end = `${index.length.toString(16).padStart(16, "0")} ${
      crc32(index).toString(16).padStart(8, "0")}\n`;
    return joined([head, ...blocks.map((block) => block.bytes), index, utf8(end)]);
  }
}

const failureLine = (kind, reason) => toJson({failure: kind, reason});

/** What a recording keeps of an answer. @param {any} answer */
function storedLine(answer) {
  return answer.not_run === undefined ? lineOf({digest: "", ...answer})
    : failureLine("unsupported", answer.not_run);
}
