// SPDX-License-Identifier: MIT The page of numbers: verdicts by renderer, whole scenes, rules by
// renderer, plots, measured profiles.

function rendererHead(info, r) {
  return h("th", {scope: "col"},
    h("a.name", {href: Route.href({...NOWHERE, renderer: info.name})}, info.name),
    h("div.claim", {title: "device"}, info.device),
    h("div.claim", {title: "version, vendor"},
      [info.version, info.vendor].filter(Boolean).join(" \u00b7 ")),
    verdictBar(verdictCounts(r)));
}

function summaryCell(count, filter, className) {
  if (!count) return h("td", {}, h("span.zero", {}, "0"));
  return h("td", {}, h("a.figure", {class: className, href: Route.href({...NOWHERE, ...filter})},
    count.toLocaleString("en")));
}

function summaryRow(label, className, wanted, filter) {
  return h("tr", {class: className}, h("th", {scope: "row"}, label),
    Data.renderers.map((info, r) => summaryCell(resultsOf(r).filter(wanted).length,
      {...filter, renderer: info.name}, className)));
}

function summaryTable() {
  const rows = WORST_FIRST.map((verdict) => summaryRow(
    h("span.verdict", {title: VERDICTS[verdict].means}, verdictIcon(verdict), verdict),
    "n-" + verdict, (result) => result.verdict === verdict, {verdict}));
  const surprising = Cases.some((one) => one.surprises);
  return scrolled("Verdicts by renderer", h("table.summary", {},
    h("thead", {}, h("tr", {}, h("td", {}), Data.renderers.map(rendererHead))),
    h("tbody", {},
      summaryRow(
        h("span.verdict", {class: surprising ? "alarm" : ""}, icon(BANG), "not as expected"),
        surprising ? "alarm" : "", isSurprise, {standing: SURPRISE}),
      rows)));
}

function statisticsView() {
  return h("main.overview.statistics-view", {}, pageHead("statistics"), summaryTable(), scenesSection(),
    fold("Rules by renderer", true, matrixTable), fold("Plots", false, plots),
    hasAnswers() && fold("What the answers say of each rule", false, answersTable),
    hasProfiles() && fold("Profiles of the renderers", false, profileTable));
}
