// SPDX-License-Identifier: MIT The clusters of each renderer, each with its smallest case: those
// that are not allowed first, then contested ones, then the rest.

const CLUSTERS_SHOWN = 5;

// Which renderers' tables show all their rows; kept while the page lives.
const openClusters = new Set();

// The place of a cluster's first pixel in its smallest case.
function smallestLink(cluster, renderer) {
  const one = CasesById.get(cluster.smallest);
  return h("a.mono", {
    href: Route.href({case: cluster.smallest, on: renderer, at: cluster.at || ""}),
    title: one ? one.title : cluster.smallest,
  }, cluster.smallest);
}

function clusterWhat(cluster) {
  if (cluster.cause) return h("td.what", {}, causeChips(cluster.cause));
  return h("td.what", {}, ruleChip(cluster.rule), " ",
    cluster.attribute ? [h("b", {}, cluster.attribute), " within what is permitted"]
      : kindLabel(cluster.kind),
    cluster.situation && h("div", {}, cluster.situation));
}

function clusterRow(cluster, renderer) {
  return h("tr", {},
    h("td", {}, legality(cluster)), clusterWhat(cluster), h("td", {}, cluster.surface),
    h("td.count", {}, cluster.disagreements.toLocaleString("en")),
    h("td.count", {}, cluster.cases.toLocaleString("en")),
    h("td.smallest", {}, smallestLink(cluster, renderer)));
}

// A table of clusters that shows the first few until the user asks for the rest.
function clusterTable(kind, clusters, renderer) {
  const key = renderer + "\n" + kind;
  const body = h("tbody", {});
  const more = h("p.more", {});
  const paint = () => {
    const all = openClusters.has(key);
    const shown = all ? clusters : clusters.slice(0, CLUSTERS_SHOWN);
    replace(body, shown.map((cluster) => clusterRow(cluster, renderer)));
    const rest = clusters.length - CLUSTERS_SHOWN;
    if (rest <= 0) return;
    replace(more, h("button.link", {onclick: () => {
      if (all) openClusters.delete(key);
      else openClusters.add(key);
      paint();
    }}, all ? "Show the first " + CLUSTERS_SHOWN : "Show " + rest.toLocaleString("en") + " more"));
  };
  paint();
  return [h("div.scroll", {}, h("table.clusters", {},
    h("thead", {}, h("tr", {}, h("td", {}), [kind, "surface", "differences", "cases",
      "smallest case"].map((text) => h("th", {scope: "col"}, text)))), body)), more];
}

// One table each for clusters that are not allowed, contested, and allowed without a cause; those
// allowed with a cause are folded.
function rendererClusters(info) {
  const of = (legality) => info.clusters.filter((cluster) => cluster.legality === legality);
  const unexplained = of("legal").filter((cluster) => !cluster.cause);
  const explained = of("legal").filter((cluster) => cluster.cause);
  const facts = [[of("illegal"), "not allowed"], [of("contested"), "contested"],
    [of("legal"), "allowed"]].filter(([list]) => list.length)
    .map(([list, words]) => list.length.toLocaleString("en") + " " + words);
  const table = (kind, list) => list.length > 0 && clusterTable(kind, list, info.name);
  return h("div.card.unexplained", {},
    h("h3", {}, info.name, " ", h("span.faint", {}, facts.join(", "))),
    table("not allowed", of("illegal")), table("contested", of("contested")),
    table("allowed, without a cause", unexplained),
    explained.length > 0 && h("details", {},
      h("summary", {}, plural(explained.length, "cluster", "clusters") + " allowed, with a cause"),
      clusterTable("cause", explained, info.name)));
}

function clustersSection() {
  const differing = Data.renderers.filter((info) => info.clusters.length);
  if (!differing.length) return null;
  return h("section.first", {}, h("h2", {}, "What differs"),
    h("p.faint", {}, "Differences that share a cause, or a rule, a kind and a situation, are one " +
      "cluster. What the specification does not allow comes first, then what is contested; of " +
      "these, what most cases share."),
    differing.map(rendererClusters));
}
