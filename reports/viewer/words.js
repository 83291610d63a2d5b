// SPDX-License-Identifier: MIT The texts and shapes of the report: each verdict, standing and kind
// has a text, a shape and a colour (by its class), so that no meaning depends only on colour. Those
// of verdicts come with the data.

const STANDINGS = {
  unexpected: {
    label: "unexpected", means: "It differs as nothing allows, and no known fault accounts for it.",
  },
  known: {label: "known", means: "Known faults account for all that the specification forbids."},
  tolerated: {
    label: "tolerated", means: "It is contested or not supported: reported, but not a failure.",
  },
  flake: {label: "flake", means: "Asked a second time, the renderer answered otherwise."},
  expected: {label: "expected", means: "It agrees, or differs as the specification allows."},
};

// The legalities of a difference or a cluster.
const LEGALITIES = {
  illegal: {label: "not allowed", class: "alarm"},
  contested: {label: "contested", class: "v-contested"},
  legal: {label: "allowed", class: ""},
};

const KINDS = {
  missing: {path: "M8 2.6a5.4 5.4 0 1 0 .01 0z", means: "exact draws it, the renderer does not"},
  extra: {path: "M8 2v12M2 8h12", means: "the renderer draws it, exact does not"},
  duplicate: {
    path: "M2.2 2.2h8v8h-8zM5.8 5.8h8v8h-8z",
    means: "the renderer draws it more often than exact",
  },
  value: {path: "M8 1.8 14.2 8 8 14.2 1.8 8z", means: "both draw it, with different values"},
};

const BANG = "M8 2.5v7M8 12.4v1";

// True for standings that count as failures.
const isRed = (standing) => standing === "unexpected" || standing === "flake";

const verdictIcon = (verdict) => icon(VERDICTS[verdict].path, "v-" + verdict);
const kindIcon = (kind) => icon(KINDS[kind].path, "k-" + kind);

function verdictBadge(verdict, extra) {
  return h("span.badge", {class: "b-" + verdict, title: VERDICTS[verdict].means},
    icon(VERDICTS[verdict].path), verdict, extra);
}

function standingBadge(standing) {
  const known = !isRed(standing);
  return h("span.standing", {class: known ? "" : "alarm", title: STANDINGS[standing].means},
    known ? null : icon(BANG), STANDINGS[standing].label);
}

function kindLabel(kind) {
  return h("span.kind", {class: "k-" + kind, title: KINDS[kind].means}, kindIcon(kind), kind);
}

// "2.50390625 (2+129/256)": a dyadic number in both forms, whole numbers as they are.
function coordinate(value) {
  if (typeof value !== "number" || Number.isInteger(value)) return String(value);
  const sign = value < 0 ? "-" : "";
  const size = Math.abs(value);
  for (let below = 2; below <= 65536; below *= 2) {
    const above = size * below;
    if (!Number.isInteger(above)) continue;
    const whole = Math.floor(size);
    const part = above - whole * below + "/" + below;
    return value + " (" + sign + (whole ? whole + (sign || "+") : "") + part + ")";
  }
  return String(value);
}

const short = (value) =>
  typeof value === "number" ? String(Number(value.toPrecision(9))) : String(value);
const tuple = (values) => "(" + values.map(short).join(", ") + ")";

// The values of exact and the renderer at a disputed sample.
function compared(d) {
  const hits = (n) => (n === 1 ? "1 hit" : n + " hits");
  const text = (list) =>
    d.kind === "value" ? tuple(list) : list.length === 1 ? hits(list[0]) : tuple(list);
  return ["exact " + text(d.exact), "rendered " + text(d.rendered)];
}
