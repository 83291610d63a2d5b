// SPDX-License-Identifier: MIT
// The place in the report lives in the URL's fragment, so that a filtered list, a case or one
// disputed pixel can be linked, and the browser's Back works.
// q, verdict, standing, rule, renderer, review: filters; case, on (renderer), at (disagreement), px
// (pixel, "x,y"), zoom (screen pixels per pixel): a case.

const FILTER_KEYS = ["q", "verdict", "standing", "rule", "renderer", "review"];
const PLACE_KEYS = ["case", "on", "at", "px", "zoom"];
const NO_PLACE = {case: "", on: "", at: "", px: "", zoom: ""};

const Route = {
  read() {
    const found = new URLSearchParams(location.hash.slice(1));
    const state = {};
    for (const key of [...FILTER_KEYS, ...PLACE_KEYS]) state[key] = found.get(key) || "";
    return state;
  },
  // The fragment of the present state with `changes`, without empty values.
  href(changes) {
    const state = {...Route.read(), ...changes};
    const next = new URLSearchParams();
    for (const key of [...FILTER_KEYS, ...PLACE_KEYS])
      if (state[key] !== "") next.set(key, String(state[key]));
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
