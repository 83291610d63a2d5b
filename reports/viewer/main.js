// SPDX-License-Identifier: MIT Shows the place that the URL's fragment names.

async function showCase(one, state) {
  const fresh = CaseView.one !== one;
  document.title = visible(one.title || one.id) + " \u00b7 Edgecase";
  if (!one.loaded) {
    try {
      await loadDetails(one);
    } catch (fault) {
      return showFault(one, fault, state);
    }
    if (Route.read().case !== one.id) return;  // another place is shown by now
    state = Route.read();
  }
  CaseView.show(one, state);
  if (!fresh) return;
  scrollTo(0, 0);
  document.querySelector("h1").focus({preventScroll: true});
  requestIdleCallback(() => readNeighbours(one, state));
}

// Reads the neighbouring cases in advance, so that they open at once.
function readNeighbours(one, state) {
  const cases = filteredCases(state);
  const at = cases.indexOf(one);
  for (const other of [cases[at - 1], cases[at + 1]])
    if (other?.line !== undefined) Blocks.readAhead(other.line);
}

// The case's details cannot be read: what its line in the list knows is shown, and how to see the rest.
function showFault(one, fault, state) {
  CaseView.close();
  const result = CaseView.resultFor(one, state.on || state.renderer);
  for (const other of one.results) other.answer ??= NO_ANSWER;
  Object.assign(CaseView, {one, result});
  replace(byId("app"), caseHead(one, state), h("main.case", {}, caseTop(one, result),
    h("section.card", {},
      h("div.result-line", {}, verdictBadge(result.verdict), standingBadge(result.standing)),
      [...result.found.keys()].map((rule) => h("div.result-line", {},
        verdictIcon(verdictBy(one, result, rule)), verdictBy(one, result, rule) + " by", ruleChip(rule))),
      h("p.sentence", {}, "The details of this case cannot be read: " + fault.message + ". Or run:"),
      commandsFor(one, result, null).map(commandLine)), caseWords(one)));
}

const VIEWS = {
  overview, cases: casesView, statistics: statisticsView, generations: generationsView,
  cause: (state) => causeView(Groups[state.cause - 1]),
};

// The list of the present filters, if the view has one.
function showList(state, isRenewed) {
  if (!byId("list")) return;
  if (Route.viewOf(state) === "cases") renewBar(state, isRenewed);
  CaseList.show(state);
}

function showPage(state) {
  const view = Route.viewOf(state);
  document.title = "Edgecase report";
  const back = CaseView.one;
  CaseView.close();
  const main = /** @type {HTMLElement} */ (document.querySelector("main"));
  if (view === "cases" && main?.classList.contains("cases-view")) return showList(state, true);
  replace(byId("app"), VIEWS[view](state));
  showList(state, false);
  scrollTo(0, 0);
  if (back && byId("list")) CaseList.reveal(CaseList.rowOf(back));
  else if (main) document.querySelector("h1").focus({preventScroll: true});
}

function showRoute() {
  Tip.hide();
  const state = Route.read();
  const one = CasesById.get(state.case);
  if (one) showCase(one, state);
  else showPage(state);
}

addEventListener("hashchange", showRoute);
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => {
  CaseView.pictures?.colors();
  CaseView.pictures?.draw();
  for (const glance of Glance.shown) if (glance.element.isConnected) glance.colors();
  Thumbnails.clear();
  const rows = document.querySelector("#list .rows");
  if (rows) paintCharts(rows);
});
showRoute();
// In idle time, once the list is shown.
if (!Route.read().case)
  requestAnimationFrame(() => requestIdleCallback(() => CaseView.rehearse(4).catch(() => {})));
