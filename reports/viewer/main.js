// SPDX-License-Identifier: MIT Shows the place that the URL's fragment names.

async function showCase(one, state) {
  const fresh = CaseView.one !== one;
  document.title = visible(one.title || one.id) + " \u00b7 Edgecase";
  if (!one.loaded) {
    try {
      await loadDetails(one);
    } catch (fault) {
      return showFault(one, fault);
    }
    if (Route.read().case !== one.id) return;  // another place is shown by now
    state = Route.read();
  }
  CaseView.show(one, state);
  if (!fresh) return;
  CaseList.cursor = filteredCases(state).indexOf(one);
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

// The case's details cannot be read, so only its line in the list is shown.
function showFault(one, fault) {
  CaseView.close();
  replace(byId("app"), h("main.case", {}, caseWords({...one, expect_failures: []}),
    h("p.card.alarm-box", {}, "The details of this case cannot be read: " + fault.message + "."),
    h("p", {}, h("a.button", {href: Route.href(NO_PLACE)}, "\u2190 All cases"))));
}

function showOverview(state) {
  document.title = "Edgecase report";
  const back = CaseView.one !== null;
  CaseView.close();
  if (document.querySelector("main.overview")) return refreshOverview(state);
  replace(byId("app"), overview(state));
  CaseList.show(state);
  if (back) CaseList.reveal(CaseList.cursor);
}

function showRoute() {
  Tip.hide();
  const state = Route.read();
  const one = CasesById.get(state.case);
  if (one) showCase(one, state);
  else showOverview(state);
}

addEventListener("hashchange", showRoute);
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => {
  CaseView.pictures?.colors();
  CaseView.pictures?.draw();
});
showRoute();
// In idle time, once the list is shown.
if (!Route.read().case)
  requestAnimationFrame(() => requestIdleCallback(() => CaseView.rehearse(4).catch(() => {})));
