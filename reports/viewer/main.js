// SPDX-License-Identifier: MIT
// Shows what the URL's fragment names.

function showCase(one, state) {
  const fresh = CaseView.one !== one;
  document.title = visible(one.title || one.id) + " \u00b7 Edgecase";
  CaseView.show(one, state);
  if (!fresh) return;
  CaseList.cursor = filteredCases(state).indexOf(one);
  scrollTo(0, 0);
  document.querySelector("h1").focus({preventScroll: true});
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
