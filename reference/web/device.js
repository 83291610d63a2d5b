// SPDX-License-Identifier: MIT
// The device's GPU as a page has it: a context that can be lost, and is then made anew.

const ATTRIBUTES = {antialias: false, depth: false, stencil: false, preserveDrawingBuffer: false,
  powerPreference: "high-performance"};
const PATIENCE = 10;  // attempts to come by another context, a second apart

const pause = (milliseconds) => new Promise((done) => setTimeout(done, milliseconds));

class Device {
  constructor() {
    /** @type {SceneRenderer} */
    this.renderer = null;
    this.losses = 0;
  }

  /** Why there is no context; empty if there is one. */
  open() {
    this.canvas = document.createElement("canvas");
    const gl = /** @type {WebGL2RenderingContext} */ (
      this.canvas.getContext("webgl2", ATTRIBUTES));
    if (!gl) return "this browser has no WebGL 2, or it is switched off for this device";
    try {
      this.renderer = new SceneRenderer(gl);
      this.claims = claimsOf(this.renderer);
      return "";
    } catch (fault) {
      if (gl.isContextLost()) return "the WebGL context was lost at once";
      return String(fault.message || fault);
    }
  }

  /** The name under which recordings know it: "webgl:chromium". */
  get name() {
    return "webgl:" + this.claims.traits.browser.split(" ")[0].toLowerCase();
  }

  /** Another context for one that was lost; false if there is none to be had. */
  async reopen() {
    ++this.losses;
    for (let i = 0; i < PATIENCE; ++i) {
      await pause(i === 0 ? 100 : 1000);
      if (this.open() === "") return true;
    }
    return false;
  }

  /** An answer, or null if the context was lost over it. @param {SceneRequest} request @returns {Answer} */
  answer(request) {
    const {gl} = this.renderer;
    let answer = null;
    try {
      answer = answerTo(this.renderer, request);
    } catch (fault) {
      if (!gl.isContextLost()) throw fault;
    }
    return gl.isContextLost() ? null : answer;
  }
}

const LOST = "the WebGL context was lost while this scene was drawn";
