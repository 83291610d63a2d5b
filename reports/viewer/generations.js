// SPDX-License-Identifier: MIT
// Known faults by release of their driver, where results of several releases were given: where each
// begins and ends.

function generationRow(row, driver) {
  const link = (cases) => (row.smallest && CasesById.has(row.smallest)
    ? h("a", {href: Route.href({...NOWHERE, case: row.smallest})}, cases.toLocaleString("en"))
    : cases.toLocaleString("en"));
  return h("tr", {}, h("th", {scope: "row", class: row.reason ? "mono" : ""}, row.name),
    row.cases.map((cases, i) => h("td.count", {
      class: !cases ? "" : driver.releases.length > 1 && !row.cases[i - 1] && i > 0 ? "shows begins" : "shows",
    }, cases ? link(cases) : h("span.zero", {}, "0"))),
    h("td.seen", {}, row.seen), h("td.what", {dir: "auto"}, row.reason));
}

function generationsView() {
  return h("main.overview", {}, pageHead("generations"),
    h("p.faint", {}, "In how many cases of the whole suite each release of a driver shows each known fault."),
    Data.generations.map((driver) => h("section.first", {}, h("h2", {}, driver.driver),
      scrolled("Faults of " + driver.driver + " by release", h("table.clusters.generations", {},
        h("thead", {}, h("tr", {}, h("th", {scope: "col"}, "fault"),
          driver.releases.map((name) => h("th.count", {scope: "col"}, name)),
          ["seen", "what"].map((text) => h("th", {scope: "col", class: text}, text)))),
        h("tbody", {}, driver.rows.map((row) => generationRow(row, driver))))))));
}
