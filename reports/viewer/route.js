// SPDX-License-Identifier: MIT
// The place in the report lives in the URL's fragment, so that a filtered list, a case or one
// disputed pixel can be linked, and the browser's Back works.
// q, verdict, standing, rule, renderer: filters; case, on (renderer), at (disagreement): a case.

const FILTER_KEYS = ["q", "verdict", "standing", "rule", "renderer"];
const PLACE_KEYS = ["case", "on", "at"];

const Route = {
  read() {
    const found = new URLSearchParams(location.hash.slice(1));
    const state = {};
    for (const key of [...FILTER_KEYS, ...PLACE_KEYS]) state[key] = found.get(key) || "";
    return state;
  },
  // The fragment of the present state with `changes`; empty values are left out.
  href(changes) {
    const state = {...Route.read(), ...changes};
    const next = new URLSearchParams();
    for (const key of [...FILTER_KEYS, ...PLACE_KEYS])
      if (state[key] !== "") next.set(key, String(state[key]));
    return "#" + next;
  },
  // To another place, which Back leaves again.
  go(changes) {
    const href = Route.href(changes);
    if (href === (location.hash || "#")) return;
    location.hash = href;
  },
  // The same place, further on: replaces the entry in the history.
  shift(changes) {
    history.replaceState(null, "", Route.href(changes));
    showRoute();
  },
  openCase(id, changes) {
    Route.go({case: id, on: Route.read().on, at: "", ...changes});
  },
  leaveCase() {
    Route.go({case: "", on: "", at: ""});
  },
};
