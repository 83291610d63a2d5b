// SPDX-License-Identifier: MIT
// Which cases are listed, in which order, and the bar that chooses them.

const SURPRISE = "not-expected";

// Results that the filters speak of: those of one renderer, or all.
function matches(one, state) {
  const words = state.q.toLowerCase().split(/\s+/).filter(Boolean);
  if (!words.every((word) => one.search.includes(word))) return false;
  if (state.rule && !one.allRules.has(state.rule)) return false;
  return one.results.some((result) => {
    if (state.renderer && result.renderer !== state.renderer) return false;
    if (state.verdict && result.verdict !== state.verdict) return false;
    if (state.standing === SURPRISE) return isSurprise(result);
    return !state.standing || result.standing === state.standing;
  }) || (one.results.length === 0 && !state.renderer && !state.verdict && !state.standing);
}

let lastFilter = null;
let lastCases = [];

// Unexpected ones first, then the worst verdicts, then by id (the order of the data).
function filteredCases(state) {
  const key = FILTER_KEYS.map((k) => state[k]).join("\u0000");
  if (key === lastFilter) return lastCases;
  lastFilter = key;
  lastCases = Report.cases.filter((one) => matches(one, state)).sort((a, b) =>
    Math.sign(b.surprises) - Math.sign(a.surprises) || b.worst - a.worst || a.index - b.index);
  return lastCases;
}

const isFiltered = (state) => FILTER_KEYS.some((key) => state[key] !== "");
const NO_FILTERS = Object.fromEntries(FILTER_KEYS.map((key) => [key, ""]));

function choice(key, label, options, state) {
  const select = h("select", {
    "aria-label": "Filter by " + label,
    class: state[key] ? "active" : "",
    onchange: (event) => Route.shift({[key]: event.target.value}),
  });
  select.append(h("option", {value: ""}, "Any " + label));
  for (const [value, text] of options)
    select.append(h("option", {value, selected: state[key] === value}, text));
  return select;
}

function ruleOptions() {
  const ids = new Set(Report.cases.flatMap((one) => [...one.allRules]));
  return [...ids].sort().map((id) => [id, id]);
}

function filterBar(state) {
  const standings = [[SURPRISE, "not as expected"],
    ...Object.entries(STANDINGS).map(([id, words]) => [id, words.label])];
  const names = [...new Set(Report.renderers.map((r) => r.name))];
  return h("div.filters", {role: "search"},
    h("input", {
      id: "search", type: "search", value: state.q, placeholder: "Search cases  ( / )",
      "aria-label": "Search cases", autocomplete: "off", spellcheck: "false",
      oninput: (event) => Route.shift({q: event.target.value}),
    }),
    choice("verdict", "verdict", WORST_FIRST.map((v) => [v, v]), state),
    choice("standing", "standing", standings, state),
    choice("rule", "rule", ruleOptions(), state),
    choice("renderer", "renderer", names.map((n) => [n, n]), state),
    h("span.count", {}, listCount(state)),
    isFiltered(state) &&
      h("button.quiet", {onclick: () => Route.shift(NO_FILTERS)}, "Clear filters"));
}

function listCount(state) {
  const shown = filteredCases(state).length;
  const all = plural(Report.cases.length, "case", "cases");
  return shown === Report.cases.length ? all : shown.toLocaleString("en") + " of " + all;
}
