// SPDX-License-Identifier: MIT The causes of all differences: clusters of every renderer
// (results/clusters.h) that share a cause, or a rule and a kind, whatever their surface and
// legality, with the answers that are decided together.

const FAILURES = {
  crashed: "The renderer crashed", "timed-out": "The renderer gave no answer in time",
  garbage: "The renderer answered what nobody can read", unsupported: "The renderer lacks something",
  internal: "Edgecase itself failed",
};
const KIND_WORDS = {
  missing: "fragments are missing", extra: "fragments too many", duplicate: "fragments drawn twice",
  value: "values beyond what is permitted",
};
const LEGAL_ORDER = ["illegal", "contested", "legal"];

const keyOf = (cluster) => cluster.cause ||
  [cluster.rule, cluster.kind, cluster.attribute].join("\n");

// One cause: its clusters, the worst first, and the unexpected answers that begin with it.
class CauseGroup {
  constructor(key) {
    this.key = key;
    this.clusters = [];  // {...a cluster, renderer}
    this.answers = [];   // {one, result, fingerprint}
    this.failure = "";   // what came instead of answers
    this.number = 0;     // of the group, from 1, as links name it
  }

  get first() {
    return this.clusters[0];
  }

  get isRed() {
    return this.answers.length > 0;
  }

  get renderers() {
    return [...new Set([...this.answers.map(({result}) => result.renderer),
      ...this.clusters.map((cluster) => cluster.renderer)])];
  }

  // Where to look first: an unexpected answer's own case, else the smallest case of the worst cluster.
  get place() {
    const {first} = this;
    const of = this.answers.find(({one, result}) => first && one.id === first.smallest &&
      result.renderer === first.renderer);
    if (first && (of || !this.isRed))
      return {case: first.smallest, on: first.renderer, at: first.at || ""};
    if (!this.isRed) return null;
    const {one, result} = this.answers.reduce((least, answer) =>
      (answer.one.width * answer.one.height < least.one.width * least.one.height ? answer : least));
    return {case: one.id, on: result.renderer, at: ""};
  }
}

// "triangle.fill-rule" as people say it: "triangle fill rule".
const spoken = (id) => id.replace(/[.-]/g, " ");
const capital = (text) => text.charAt(0).toUpperCase() + text.slice(1);

// "triangle fill rule is left-bottom, not left-top".
function partWords(part) {
  const [id, alternative] = part.split("=");
  const rule = Rules.get(id);
  if (alternative === undefined) return rule ? rule.title : spoken(id);
  const standard = rule?.standard && rule.standard !== alternative ? ", not " + rule.standard : "";
  return spoken(id) + " is " + alternative + standard;
}

// What happened, in a line.
function groupTitle(group) {
  if (group.failure) return FAILURES[group.failure] || group.failure;
  const {first} = group;
  if (!first) return "Another answer when asked again";
  if (first.cause) return capital(first.cause.split(" + ").map(partWords).join("; "));
  return capital(spoken(first.rule)) + ": " + (first.attribute
    ? first.attribute + " within what is permitted" : KIND_WORDS[first.kind]);
}

// Where on their primitives the differences of a group without a cause lie, and what they look like
// in their case alone: [words, differences, cases], the most frequent first.
function situationsOf(group) {
  const all = new Map();
  for (const {situations} of group.clusters)
    for (const [words, differences, cases] of situations) {
      const [, d, c] = all.get(words) || [words, 0, 0];
      all.set(words, [words, d + differences, c + cases]);
    }
  return [...all.values()].filter(([words]) => words).sort((a, b) => b[1] - a[1]);
}

// What the alternatives of a cause mean, or where on a primitive most of the differences lie and what
// all have in common.
function groupMeaning(group) {
  const {first} = group;
  if (!first) return "";
  if (!first.cause) {
    const [most, ...others] = situationsOf(group);
    const common = group.clusters.map((cluster) => cluster.common).find(Boolean);
    const places = most ? most[0] + (others.length ? ", and " + plural(others.length, "other place", "other places") : "") : "";
    return [places, common && "all " + common].filter(Boolean).join("; ");
  }
  return first.cause.split(" + ").map((part) => {
    const [id, alternative] = part.split("=");
    return alternative && Rules.get(id)?.alternatives?.[alternative];
  }).filter(Boolean).map((meaning) => capital(meaning)).join("; ");
}

// [legality, kind or "", cases, differences] of each legality, the worst first. Cases are those of
// the renderer that has the most of them.
function groupCounts(group) {
  return LEGAL_ORDER.flatMap((legality) => {
    const list = group.clusters.filter((cluster) => cluster.legality === legality);
    if (!list.length) return [];
    const by = new Map();
    for (const {renderer, cases} of list) by.set(renderer, (by.get(renderer) || 0) + cases);
    const kinds = new Set(list.map((cluster) => cluster.kind));
    return [{legality, kind: kinds.size === 1 ? [...kinds][0] : "",
      cases: Math.max(...by.values()),
      differences: list.reduce((sum, cluster) => sum + cluster.disagreements, 0)}];
  });
}

// Red ones first, of these the ones with most answers; then by legality and cases.
function groupsInOrder(groups) {
  const rank = (group) => (group.first ? LEGAL_ORDER.indexOf(group.first.legality) : 1);
  const cases = (group) => Math.max(0, ...group.clusters.map((cluster) => cluster.cases));
  return groups.sort((a, b) => Number(b.isRed) - Number(a.isRed) || rank(a) - rank(b) ||
    b.answers.length - a.answers.length || cases(b) - cases(a));
}

function gatheredGroups() {
  const groups = new Map();
  const of = (key) => {
    if (!groups.has(key)) groups.set(key, new CauseGroup(key));
    return groups.get(key);
  };
  for (const info of Data.renderers)
    for (const cluster of info.clusters)
      of(keyOf(cluster)).clusters.push({...cluster, renderer: info.name});
  for (const [number, r, cluster, fingerprint] of Data.unexpected) {
    const one = Cases[number];
    const result = one.results[r];
    const isFlake = result.standing === "flake";
    const failed = typeof cluster === "string";
    const group = isFlake ? of("\nflake") : failed ? of("\n" + cluster)
      : of(keyOf(Data.renderers[r].clusters[cluster]));
    if (failed && !isFlake) group.failure = cluster;
    group.answers.push({one, result, fingerprint});
    result.group = group;
    result.fingerprint = fingerprint;
  }
  const worst = (a, b) => LEGAL_ORDER.indexOf(a.legality) - LEGAL_ORDER.indexOf(b.legality) ||
    b.cases - a.cases;
  for (const group of groups.values()) group.clusters.sort(worst);
  return groupsInOrder([...groups.values()]);
}

const Groups = gatheredGroups();
Groups.forEach((group, i) => { group.number = i + 1; });
const RedGroups = Groups.filter((group) => group.isRed);
