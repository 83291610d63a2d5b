// SPDX-License-Identifier: MIT The listed cases, their order, and the bar that filters them.

const SURPRISE = "not-expected";

// A result's verdict or, if a rule is chosen, the worst verdict under it.
function verdictBy(one, result, rule) {
  if (!rule || result.verdict === "not-run") return result.verdict;
  return result.found.get(rule) || "agree";
}

// The results that the filters concern: those of one renderer, or all.
function matches(one, state) {
  const words = state.q.toLowerCase().split(/\s+/).filter(Boolean);
  if (!words.every((word) => one.search.includes(word))) return false;
  if (state.rule && !one.hasRule(state.rule)) return false;
  return one.results.some((result) => {
    if (state.renderer && result.renderer !== state.renderer) return false;
    if (state.verdict && verdictBy(one, result, state.rule) !== state.verdict) return false;
    if (state.standing === SURPRISE && !isSurprise(result)) return false;
    if (state.review && !isReviewed(one, result, state.review)) return false;
    if (state.cause && result.group !== Groups[state.cause - 1]) return false;
    return !state.standing || state.standing === SURPRISE || result.standing === state.standing;
  }) || (one.results.length === 0 && !state.renderer && !state.verdict && !state.standing);
}

// `wanted`: "undecided" (and to be decided on), "decided", or a decision.
function isReviewed(one, result, wanted) {
  const decision = Review.of(one, result);
  if (wanted === "undecided") return !decision && isDecidable(result);
  return decision !== undefined && (wanted === "decided" || decision.decision === wanted);
}

let lastFilter = null;
let lastCases = [];

// Called after a decision, since cases may be filtered by decisions.
function forgetFilter() {
  lastFilter = null;
}

// Numbers within names in their order.
const inOrder = new Intl.Collator("en", {numeric: true}).compare;

// Unexpected ones first, then the worst verdicts, then those whose cause most cases share, then by
// id (the order of the data). The cases of a file stay together, at the place of the first of them,
// in the order of their sweep.
function filteredCases(state) {
  const key = FILTER_KEYS.map((k) => state[k]).join("\u0000");
  if (key === lastFilter) return lastCases;
  lastFilter = key;
  const files = new Map();
  const sorted = Cases.filter((one) => matches(one, state)).sort((a, b) =>
    Math.sign(b.surprises) - Math.sign(a.surprises) || b.worst - a.worst ||
    a.order - b.order || a.index - b.index);
  for (const one of sorted)
    if (files.has(one.head)) files.get(one.head).push(one);
    else files.set(one.head, [one]);
  lastCases = [...files.values()].flatMap((cases) => cases.sort((a, b) => inOrder(a.id, b.id)));
  return lastCases;
}

function choice(key, label, options, state) {
  const select = h("select", {
    "aria-label": "Filter by " + label,
    class: state[key] ? "active" : "",
    onchange: (event) => Route.shift({view: "cases", [key]: event.target.value}),
  });
  select.append(h("option", {value: ""}, "Any " + label));
  for (const [value, text] of options)
    select.append(h("option", {value, selected: state[key] === value}, text));
  return select;
}

function ruleOptions() {
  return [...Data.names].sort().map((id) => [id, id]);
}

function filterBar(state) {
  const standings = [[SURPRISE, "not as expected"],
    ...Object.entries(STANDINGS).map(([id, words]) => [id, words.label])];
  const names = [...new Set(Data.renderers.map((r) => r.name))];
  return h("div.filters", {role: "search"},
    h("input", {
      id: "search", type: "search", value: state.q, placeholder: "Search cases  ( / )",
      "aria-label": "Search cases", autocomplete: "off", spellcheck: "false",
      oninput: (event) => Route.shift({view: "cases", q: event.target.value}),
    }),
    choice("verdict", "verdict", WORST_FIRST.map((v) => [v, v]), state),
    choice("standing", "standing", standings, state),
    choice("review", "review", [["undecided", "to decide on"], ["decided", "decided"],
      ["accept", "accepted"], ["reject", "rejected"]], state),
    choice("rule", "rule", ruleOptions(), state),
    choice("renderer", "renderer", names.map((n) => [n, n]), state),
    h("span.count", {}, listCount(state)),
    isFiltered(state) &&
      h("button.quiet", {onclick: () => Route.shift({...NO_FILTERS, view: "cases"})}, "Clear filters"));
}

function listCount(state) {
  const shown = filteredCases(state).length;
  const all = plural(Cases.length, "case", "cases");
  return shown === Cases.length ? all : shown.toLocaleString("en") + " of " + all;
}

// Renews the bar after a change of filters, except the search field, in which the user may be typing.
function renewBar(state, isRenewed) {
  const bar = filterBar(state);
  const kept = isRenewed && document.activeElement === byId("search") ? byId("search") : null;
  if (kept) bar.querySelector("#search").replaceWith(kept);
  replace(byId("bar"), bar);
  kept?.focus();
}
