// SPDX-License-Identifier: MIT
// What the page is for stands in its data.

/** @returns {any} */
function pageOf(data) {
  switch (data.mode) {
    case "serve": return new ServePage();
    case "show": return new ShowPage(data);
    default: return new RunPage(data);
  }
}

const page = pageOf(JSON.parse(byId("data").textContent));
page.begin();
