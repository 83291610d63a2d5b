// SPDX-License-Identifier: MIT
// The place in the report lives in the URL's fragment, so that a filtered list, a case or one
// disputed pixel can be linked, and the browser's Back works.
// view: "cases", "statistics", "generations"; q, verdict, standing, rule, renderer, review, cause:
// filters; case, on (renderer), at (disagreement), px (pixel, "x,y"), zoom (screen pixels per
// pixel): a case.

const FILTER_KEYS = ["q", "verdict", "standing", "rule", "renderer", "review", "cause"];
const PLACE_KEYS = ["case", "on", "at", "px", "zoom"];
const ROUTE_KEYS = ["view", ...FILTER_KEYS, ...PLACE_KEYS];
const NO_PLACE = {case: "", on: "", at: "", px: "", zoom: ""};
const NO_FILTERS = Object.fromEntries(FILTER_KEYS.map((key) => [key, ""]));
const NOWHERE = Object.fromEntries(ROUTE_KEYS.map((key) => [key, ""]));
const isFiltered = (state) => FILTER_KEYS.some((key) => state[key] !== "");

const Route = {
  read() {
    const found = new URLSearchParams(location.hash.slice(1));
    const state = {};
    for (const key of ROUTE_KEYS) state[key] = found.get(key) || "";
    return state;
  },
  // "case", "cause", "cases", "statistics", "generations" or "overview".
  viewOf(state) {
    if (CasesById.has(state.case)) return "case";
    if (Groups[state.cause - 1]) return "cause";
    if (state.view === "statistics" || (state.view === "generations" && Data.generations))
      return state.view;
    return state.view === "cases" || isFiltered(state) ? "cases" : "overview";
  },
  // The fragment of the present state with `changes`, without empty values.
  href(changes) {
    const state = {...Route.read(), ...changes};
    const next = new URLSearchParams();
    for (const key of ROUTE_KEYS) if (state[key] !== "") next.set(key, String(state[key]));
    return "#" + next;
  },
  // Goes to another place, with a new entry in the history.
  go(changes) {
    const href = Route.href(changes);
    if (href === (location.hash || "#")) return;
    location.hash = href;
  },
  // Records the present view of the case without showing anything anew.
  note(changes) {
    history.replaceState(null, "", Route.href(changes));
  },
  // Goes to another place by replacing the entry in the history.
  shift(changes) {
    history.replaceState(null, "", Route.href(changes));
    showRoute();
  },
  openCase(id, changes) {
    Route.go({...NO_PLACE, case: id, on: Route.read().on, ...changes});
  },
  leaveCase() {
    Route.go(NO_PLACE);
  },
};
