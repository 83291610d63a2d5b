// SPDX-License-Identifier: MIT The change of each case since earlier results (`edgecase report
// --since`).

const CHANGES = {
  "new-disagreement": {words: "agreed before, does not now", bad: true},
  worse: {words: "worse verdict", bad: true},
  "not-run": {words: "rendered before, not now", bad: true},
  changed: {words: "same verdict, another answer", bad: false},
  appeared: {words: "new case", bad: false},
  disappeared: {words: "case is gone", bad: false},
  runs: {words: "not rendered before, is now", bad: false},
  better: {words: "better verdict", bad: false},
  fixed: {words: "agrees now, did not before", bad: false},
};
const CHANGES_SHOWN = 20;

const changeName = (change) => h("span", {class: CHANGES[change].bad ? "alarm" : ""},
  CHANGES[change].bad && icon(BANG), CHANGES[change].words);
const answerWords = (answer) => (answer ? verdictBadge(answer.verdict) : "\u2013");

function changedCases(compared) {
  const order = Object.keys(CHANGES);
  const cases = [...compared.cases].sort((a, b) =>
    order.indexOf(a.change) - order.indexOf(b.change));
  const list = h("tbody", {});
  const more = h("p.more", {});
  const paint = (count) => {
    replace(list, cases.slice(0, count).map((one) => h("tr", {},
      h("td", {}, changeName(one.change)), h("td", {}, answerWords(one.before)),
      h("td", {}, answerWords(one.after)),
      h("td", {}, CasesById.has(one.id) ? h("a.mono", {
        href: Route.href({case: one.id, on: compared.after})}, one.id)
        : h("span.mono", {}, one.id)))));
    replace(more, cases.length > count && h("button.link", {onclick: () => paint(count + 200)},
      "Show more of " + cases.length.toLocaleString("en")));
  };
  paint(CHANGES_SHOWN);
  return [scrolled("Changed cases", h("table.clusters.changes", {},
    h("thead", {}, h("tr", {}, ["change", "before", "now", "case"].map((text) =>
      h("th", {scope: "col"}, text)))), list)), more];
}

function changesOf(compared) {
  const counts = Object.keys(CHANGES).filter((change) => compared.counts[change]);
  return h("div.card", {},
    h("h3", {}, compared.after, compared.before !== compared.after &&
      h("span.faint", {}, " before: " + compared.before)),
    h("p.facts", {}, compared.facts.map((fact) =>
      h("span", {}, fact.what + ": " + fact.before + " \u2192 " + fact.after))),
    h("p.facts", {}, counts.map((change) => h("span", {}, changeName(change), " ",
      h("b", {}, compared.counts[change].toLocaleString("en")))),
    h("span", {}, "same ", compared.same.toLocaleString("en"))),
    compared.cases.length > 0 && changedCases(compared));
}

function changesSection() {
  const {since} = Data;
  if (!since) return null;
  return h("section.first", {}, h("h2", {}, "Changed since the earlier results"),
    h("p.facts", {}, since.facts.map((fact) =>
      h("span", {}, fact.what + ": " + fact.before + " \u2192 " + fact.after)),
    since.only_before.map((name) => h("span", {}, name + ": only before")),
    since.only_after.map((name) => h("span", {}, name + ": only now"))),
    since.renderers.map(changesOf));
}
