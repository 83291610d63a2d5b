// SPDX-License-Identifier: MIT The first page: the run and its outcome, faults of the suite, and
// the list of cases.

function headlineOf() {
  const results = Cases.flatMap((one) => one.results);
  const surprises = results.filter(isSurprise).length;
  const tolerated = results.filter((result) => result.standing === "tolerated").length;
  const known = results.filter((result) => result.standing === "known").length;
  const broken = new Set(Data.diagnostics.map((d) => d.file)).size;
  const drawn = Data.untrue.reduce((sum, [, texts]) => sum + texts.length, 0);
  const parts = [];
  if (surprises) parts.push(plural(surprises, "result is", "results are") + " not as expected");
  if (broken) parts.push(plural(broken, "case file", "case files") + " cannot be loaded");
  if (drawn) parts.push(plural(drawn, "hand-drawn truth is", "hand-drawn truths are") + " not met");
  const grown = Data.faults.filter((fault) => fault.state === "grown").length;
  if (grown) parts.push(plural(grown, "known fault has", "known faults have") + " grown");
  if (Data.interrupted)
    parts.push("the run was interrupted" + (Data.left_out
      ? "; " + plural(Data.left_out, "case is", "cases are") + " missing" : ""));
  if (!parts.length)
    return h("p.headline.good", {}, icon(VERDICTS.agree.path),
      !results.length ? "Nothing was run." : "Every result is as expected" +
        (known ? ", or a known fault: " + known.toLocaleString("en") : "") +
        (tolerated ? ", or tolerated: " + tolerated.toLocaleString("en") : "") + ".");
  return h("p.headline.alarm", {}, icon(BANG), parts.join("; ") + ".");
}

function pageHead() {
  return h("header.head", {},
    h("h1", {}, "Edgecase report"),
    h("p.facts", {},
      h("span", {}, Data.tool), h("span", {}, "policy ", h("b", {}, Data.policy)),
      h("span", {}, plural(Cases.length, "case", "cases")),
      h("span", {}, plural(Data.renderers.length, "renderer", "renderers"))),
    h("button.quiet.help", {onclick: showHelp, "aria-label": "Keys"}, "Keys ", h("kbd", {}, "?")));
}

const resultsOf = (r) => Cases.map((one) => one.results[r]).filter(Boolean);

function proportions(r) {
  const counts = {};
  for (const {verdict} of resultsOf(r)) counts[verdict] = (counts[verdict] || 0) + 1;
  return verdictBar(counts);
}

function rendererHead(info, r) {
  return h("th", {scope: "col"},
    h("a.name", {href: Route.href({...NO_FILTERS, renderer: info.name})}, info.name),
    h("div.claim", {title: "device"}, info.device),
    h("div.claim", {title: "version, vendor"},
      [info.version, info.vendor].filter(Boolean).join(" \u00b7 ")),
    proportions(r));
}

function summaryCell(count, filter, className) {
  if (!count) return h("td", {}, h("span.zero", {}, "0"));
  const state = Route.read();
  const chosen = FILTER_KEYS.every((key) => state[key] === (filter[key] || ""));
  return h("td", {}, h("a.figure", {
    class: className + (chosen ? " chosen" : ""),
    href: Route.href({...NO_FILTERS, ...(chosen ? {} : filter)}),
    "aria-current": chosen ? "true" : undefined,
  }, count.toLocaleString("en")));
}

function summaryRow(head, className, test, filter) {
  return h("tr", {class: className}, h("th", {scope: "row"}, head),
    Data.renderers.map((info, r) => summaryCell(
      resultsOf(r).filter(test).length, {...filter, renderer: info.name}, className)));
}

function summaryTable() {
  const rows = WORST_FIRST.map((verdict) => summaryRow(
    h("span.verdict", {title: VERDICTS[verdict].means}, verdictIcon(verdict), verdict),
    "n-" + verdict, (result) => result.verdict === verdict, {verdict}));
  const surprising = Cases.some((one) => one.surprises);
  return h("div.scroll", {}, h("table.summary", {},
    h("thead", {}, h("tr", {}, h("td", {}), Data.renderers.map(rendererHead))),
    h("tbody", {},
      summaryRow(
        h("span.verdict", {class: surprising ? "alarm" : ""}, icon(BANG), "not as expected"),
        surprising ? "alarm" : "", isSurprise, {standing: SURPRISE}),
      rows)));
}

function diagnosticItem(d) {
  const place = d.file + (d.line ? ":" + d.line : "");
  return h("li", {}, h("code", {}, place), d.pointer && [" ", h("code.faint", {}, d.pointer)],
    h("div", {}, d.message, d.remedy && h("span.remedy", {}, " \u2192 " + d.remedy)));
}

function faultItem(fault) {
  return h("li", {}, h("code", {}, fault.id), " " + fault.renderer + ": " + fault.told,
    h("div", {dir: "auto"}, fault.reason));
}

function problems() {
  const drawn = Data.untrue.flatMap(([number, texts]) => texts.map((text) => h("li", {},
    h("a", {href: Route.href({case: Cases[number].id})}, Cases[number].title || Cases[number].id),
    h("div.lines", {}, text))));
  const box = (title, items) => items.length > 0 && h("details.problem", {open: items.length < 4},
    h("summary", {}, icon(BANG), title + " (" + items.length + ")"), h("ul", {}, items));
  return h("div.problems", {},
    box("Case files that cannot be loaded", Data.diagnostics.map(diagnosticItem)),
    box("Hand-drawn truths that the exact side does not meet", drawn),
    box("Known faults that are not as their files say; edgecase bless --apply renews these",
      Data.faults.filter((fault) => fault.state !== "known").map(faultItem)),
    box("Known faults", Data.faults.filter((fault) => fault.state === "known").map(faultItem)));
}

// Which sections were opened or closed; kept while the page lives.
const opened = new Map();

// A section whose content is made when it is opened.
function fold(title, open, make) {
  const body = h("div", {});
  const section = h("details.first.fold", {open: opened.get(title) ?? open},
    h("summary", {}, h("h2", {}, title)), body);
  const fill = () => {
    if (section.open && !body.hasChildNodes()) replace(body, make());
  };
  section.addEventListener("toggle", () => {
    opened.set(title, section.open);
    fill();
  });
  fill();
  return section;
}

function overview(state) {
  return h("main.overview", {}, pageHead(), headlineOf(), summaryTable(), problems(),
    reviewSection(), changesSection(), scenesSection(), clustersSection(),
    fold("Rules by renderer", true, matrixTable), fold("Plots", false, plots),
    hasProfiles() && fold("Profiles of the renderers", false, profileTable),
    h("div", {id: "bar"}, filterBar(state)), h("div", {id: "list"}));
}

// Renews everything after a change of filters, except the search field, in which the user may be
// typing.
function refreshOverview(state) {
  const typing = document.activeElement && document.activeElement.id === "search";
  const bar = filterBar(state);
  if (typing) {
    const kept = byId("search");
    bar.querySelector("#search").replaceWith(kept);
    replace(byId("bar"), bar);
    kept.focus();
  } else {
    replace(byId("bar"), bar);
  }
  document.querySelector(".summary").parentElement.replaceWith(summaryTable());
  CaseList.show(state);
}
