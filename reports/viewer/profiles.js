// SPDX-License-Identifier: MIT The measured profiles of renderers, side by side: the choices that
// differ between them, or from the policy `opengl`.

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

const hasProfiles = () => Data.renderers.some((info) => Object.keys(info.profile).length);
