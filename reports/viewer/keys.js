// SPDX-License-Identifier: MIT
// The keyboard.

const KEYS = [
  ["j  \u2193", "next case or cause"], ["k  \u2191", "previous case or cause"], ["Enter", "open it"],
  ["a  x", "accept, reject: the cause, or the answer of a case"], ["e", "export the decisions"],
  ["l", "list of cases"], ["i", "statistics"], ["m", "generations"], ["/", "search"],
  ["n", "next disagreement"], ["p", "previous disagreement"],
  ["[  ]", "previous, next renderer"], ["+  -", "larger, smaller"], ["0", "whole image"],
  ["z", "close to the chosen pixel"], ["w", "slider between exact and rendered"],
  ["b", "blink between exact and rendered"],
  ["s", "pixels as samples, or resolved"], ["v", "the clip volume"], ["\u2190  \u2192", "along a plot of levels"],
  ["Esc", "back"], ["?", "these keys"],
];

function showHelp() {
  const dialog = byId("help");
  replace(dialog, h("h2", {}, "Keys"),
    h("dl", {}, KEYS.map(([key, what]) => [h("dt", {}, h("kbd", {}, key)), h("dd", {}, what)])),
    h("button", {onclick: () => dialog.close()}, "Close"));
  dialog.showModal();
}

function stepCase(by) {
  const cases = filteredCases(Route.read());
  const next = cases[cases.indexOf(CaseView.one) + by];
  if (next) Route.shift({case: next.id, at: "", px: ""});
}

function stepRenderer(by) {
  const all = CaseView.one.results;
  const next = all[(all.indexOf(CaseView.result) + by + all.length) % all.length];
  if (next) Route.shift({on: next.renderer, at: "", px: ""});
}

const CASE_KEYS = {
  j: () => stepCase(1), ArrowDown: () => stepCase(1),
  k: () => stepCase(-1), ArrowUp: () => stepCase(-1),
  n: () => CaseView.step(1), p: () => CaseView.step(-1),
  "]": () => stepRenderer(1), "[": () => stepRenderer(-1),
  "+": () => CaseView.pictures?.zoom(1.25), "=": () => CaseView.pictures?.zoom(1.25),
  "-": () => CaseView.pictures?.zoom(0.8), 0: () => CaseView.pictures?.fit(),
  z: () => CaseView.pictures?.close(), s: () => CaseView.pictures?.toggle("samples"),
  v: () => CaseView.pictures?.toggle("clip"),
  w: () => CaseView.pictures?.compare("slider"), b: () => CaseView.pictures?.compare("blink"),
  a: () => CaseView.form?.ask("accept"), x: () => CaseView.form?.ask("reject"),
  Escape: () => Route.leaveCase(),
};
const LIST_KEYS = {
  j: () => CaseList.move(1), ArrowDown: () => CaseList.move(1),
  k: () => CaseList.move(-1), ArrowUp: () => CaseList.move(-1),
  Escape: () => Route.go(isFiltered(Route.read()) ? {...NOWHERE, view: "cases"} : NOWHERE),
};
const OVERVIEW_KEYS = {
  j: () => Overview.move(1), ArrowDown: () => Overview.move(1),
  k: () => Overview.move(-1), ArrowUp: () => Overview.move(-1),
  a: () => Overview.ask("accept"), x: () => Overview.ask("reject"), Enter: () => Overview.open(),
};
const CAUSE_KEYS = {...LIST_KEYS, a: OVERVIEW_KEYS.a, x: OVERVIEW_KEYS.x, Escape: () => Route.go(NOWHERE)};
const PAGE_KEYS = {Escape: () => Route.go(NOWHERE)};
const VIEW_KEYS = {case: CASE_KEYS, cases: LIST_KEYS, overview: OVERVIEW_KEYS, cause: CAUSE_KEYS,
  statistics: PAGE_KEYS, generations: PAGE_KEYS};
const KEYS_EVERYWHERE = {
  "/": focusSearch, "?": showHelp, e: downloadDecisions,
  l: () => Route.go({...NOWHERE, view: "cases"}), i: () => Route.go({...NOWHERE, view: "statistics"}),
  m: () => Data.generations && Route.go({...NOWHERE, view: "generations"}),
};

function focusSearch() {
  if (!byId("search")) Route.go({...NOWHERE, view: "cases"});
  setTimeout(() => byId("search")?.focus());
}

addEventListener("keydown", (event) => {
  if (event.ctrlKey || event.metaKey || event.altKey || byId("help").open) return;
  const target = /** @type {HTMLInputElement} */ (event.target);
  if (target.closest("select, textarea, pre")) return;
  if (target.type === "text") return;
  if (target.type === "range" && event.key.startsWith("Arrow")) return;
  if (target.id === "search") {
    if (event.key === "Escape") target.blur();
    if (event.key !== "ArrowDown") return;
  }
  if (event.key === "Escape" && Tip.owner) return void Tip.hide();
  if (event.key === "Enter" && target.closest("a, button, summary")) return;
  const act = {...KEYS_EVERYWHERE, ...VIEW_KEYS[Route.viewOf(Route.read())]}[event.key];
  if (!act || (target.type === "checkbox" && event.key === " ")) return;
  event.preventDefault();
  act();
});
