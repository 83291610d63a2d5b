// SPDX-License-Identifier: MIT The measured profiles of renderers, side by side: the choices that
// differ between them, or from the policy `opengl`; and what the answers of this run say of each rule.

// "left-bottom; window: right-top": a choice, and other choices for single surfaces. A rule that a
// profile does not name has its standard choice.
function choiceText(profile, rule) {
  const parts = Object.entries(profile)
    .filter(([, choices]) => choices[rule] !== undefined)
    .map(([place, choices]) => (place ? place + ": " : "") + choices[rule]);
  return parts.join("; ") || Rules.get(rule)?.standard || "";
}

function profileRow(rule, texts) {
  const alike = texts.every((text) => text === texts[0]);
  const standard = Rules.get(rule)?.standard || "";
  return h("tr", {class: alike ? "" : "unlike"},
    h("th", {scope: "row"}, ruleChip(rule), !alike && h("small", {}, " differ")),
    texts.map((text) => h("td.mono", {class: text === standard ? "faint" : ""}, text || "\u2013")),
    h("td.mono.faint", {}, standard || "\u2013"));
}

function profileTable() {
  const told = Data.renderers.filter((info) => Object.keys(info.profile).length);
  const rules = [...new Set(told.flatMap((info) =>
    Object.values(info.profile).flatMap((choices) => Object.keys(choices))))].sort();
  const textsOf = (rule) => told.map((info) => choiceText(info.profile, rule));
  const rows = rules.map((rule) => [rule, textsOf(rule)]);
  const unlike = rows.filter(([, texts]) => texts.some((text) => text !== texts[0]));
  const alike = rows.filter((row) => !unlike.includes(row));
  return scrolled("Profiles", h("table.matrix.profiles", {},
    h("thead", {}, h("tr", {}, h("th", {scope: "col"}, "rule"),
      told.map((info) => h("th", {scope: "col"}, info.name)),
      h("th", {scope: "col"}, "policy opengl"))),
    h("tbody", {}, [...unlike, ...alike].map(([rule, texts]) => profileRow(rule, texts)))));
}

// What a renderer's answers say of a rule, surface by surface: the alternatives that remain. The
// tooltip has how many answers speak for each.
function answersCell(surfaces, rule) {
  const told = Object.entries(surfaces || {}).flatMap(([surface, list]) =>
    list.filter((answers) => answers.rule === rule).map((answers) => [surface, answers]));
  return h("td", {}, told.map(([surface, answers]) => {
    const counts = Object.entries(answers.for).sort(([, a], [, b]) => b - a);
    const most = (counts[0]?.[1] || 0).toLocaleString("en");
    return h("div", {title: counts.map(([name, count]) => name + ": " + count).join(", ")},
      h("span.mono", {}, answers.remain), h("small", {}, " " + most + " of " +
        answers.asked.toLocaleString("en") + ", " + surface));
  }));
}

function answersTable() {
  const told = Data.renderers.filter((info) => Data.answers[info.name]);
  const asked = new Set(told.flatMap((info) =>
    Object.values(Data.answers[info.name]).flat().map((answers) => answers.rule)));
  return scrolled("What the answers say of each rule", h("table.matrix.profiles", {},
    h("thead", {}, h("tr", {}, h("th", {scope: "col"}, "rule"),
      told.map((info) => h("th", {scope: "col"}, info.name)))),
    h("tbody", {}, Data.rules.filter(({id}) => asked.has(id)).map(({id}) => h("tr", {},
      h("th", {scope: "row"}, ruleChip(id)),
      told.map((info) => answersCell(Data.answers[info.name], id)))))));
}

const hasAnswers = () => Object.keys(Data.answers).length > 0;
const hasProfiles = () => Data.renderers.some((info) => Object.keys(info.profile).length);
