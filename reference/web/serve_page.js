// SPDX-License-Identifier: MIT
// The page of a live renderer: a program on this machine hands it requests and takes its answers,
// one at a time (tools/edgecase_webgl).

class ServePage {
  constructor() {
    this.device = new Device();
  }

  async begin() {
    byId("title").textContent = "Edgecase draws here";
    byId("progress").hidden = true;
    const problem = this.device.open();
    // First, whether it can draw.
    let line = problem || "ready";
    for (;;) {
      const response = await fetch("scene", {method: "POST", body: line});
      if (!response.ok) return;
      const request = JSON.parse(await response.text());
      const answer = problem ? {not_run: problem} : await this.answer(request);
      line = lineOf({digest: request.digest, ...answer, renderer: this.device.claims});
    }
  }

  /** @param {SceneRequest} request */
  async answer(request) {
    const answer = this.device.answer(request);
    if (answer !== null) return answer;
    // The program that asks ends, which is what a lost context is to a renderer.
    await fetch("lost", {method: "POST", body: LOST});
    return {not_run: LOST};
  }
}
