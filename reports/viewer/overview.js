// SPDX-License-Identifier: MIT The first page: what the run comes to in a sentence, a card for each
// cause of unexpected answers, known faults by fault, and what has changed.

const CARDS_SHOWN = 8;      // until the reader asks for all
const PICTURED = 3;         // of these, the first ones with pictures

// What makes the run red besides answers.
function redFacts() {
  const broken = new Set(Data.diagnostics.map((d) => d.file)).size;
  const drawn = Data.untrue.reduce((sum, [, texts]) => sum + texts.length, 0);
  const grown = Data.faults.filter((fault) => fault.state === "grown").length;
  return [
    broken && plural(broken, "case file", "case files") + " cannot be loaded",
    drawn && plural(drawn, "hand-drawn truth is", "hand-drawn truths are") + " not met",
    grown && plural(grown, "known fault has", "known faults have") + " grown",
    Data.interrupted && "the run was interrupted" + (Data.left_out
      ? "; " + plural(Data.left_out, "case is", "cases are") + " missing" : ""),
  ].filter(Boolean);
}

// What goes before a cause in a sentence: a portrait says what the renderer does, rules have names.
function subjectOf(cause) {
  if (!cause) return "";
  return cause.split(" + ").some((part) => part.includes(" ")) ? "it " : "the ";
}

// What all answers that are not as expected come to.
function redSentence() {
  const answers = RedGroups.reduce((sum, group) => sum + group.answers.length, 0);
  if (!answers) return "";
  const [first] = RedGroups;
  const title = groupTitle(first);
  const words = RedGroups.length === 1 ? " not as expected: "
    : " not as expected, from " + RedGroups.length + " causes. The worst, in " +
      plural(first.answers.length, "case", "cases") + ": ";
  return plural(answers, "answer is", "answers are") + words +
    subjectOf(first.first?.cause) + title.charAt(0).toLowerCase() + title.slice(1);
}

function greenSentence() {
  const results = Cases.flatMap((one) => one.results);
  if (!results.length) return "Nothing was run.";
  const of = (standing) => results.filter((result) => result.standing === standing).length;
  const [known, tolerated] = [of("known"), of("tolerated")];
  return "Every answer is as expected" +
    (known ? ", or a known fault: " + known.toLocaleString("en") : "") +
    (tolerated ? ", or tolerated: " + tolerated.toLocaleString("en") : "") + ".";
}

function headline() {
  const parts = [redSentence(), ...redFacts()].filter(Boolean);
  return parts.length ? h("p.headline.alarm", {}, icon(BANG), h("span", {dir: "auto"}, parts.join("; ") + "."))
    : h("p.headline.good", {}, icon(VERDICTS.agree.path), greenSentence());
}

// What all answers of a renderer together say of it.
function portraits() {
  return Data.renderers.flatMap(({name, portrait}) => portrait.map((sentence) =>
    h("p.portrait", {dir: "auto"}, Data.renderers.length > 1 && [h("b", {}, name), ": "], sentence)));
}

function pageHead(view) {
  const link = (name, label, key) => h("a", {
    href: Route.href({...NOWHERE, view: name}), "aria-current": view === (name || "overview") ? "page" : undefined,
    title: key && label + " (" + key + ")",
  }, label);
  return h("header.head", {},
    h("h1", {tabindex: "-1"}, "Edgecase report"),
    h("nav.views", {"aria-label": "Views"}, link("", "Overview"),
      link("cases", "Cases " + Cases.length.toLocaleString("en"), "l"),
      link("statistics", "Statistics", "i"),
      Data.generations && link("generations", "Generations", "m")),
    h("p.facts", {}, h("span", {}, Data.tool), h("span", {}, "policy ", h("b", {}, Data.policy)),
      h("span", {}, plural(Data.renderers.length, "renderer", "renderers"))),
    h("button.quiet.help", {onclick: showHelp, "aria-label": "Keys"}, "Keys ", h("kbd", {}, "?")));
}

const resultsOf = (r) => Cases.map((one) => one.results[r]).filter(Boolean);

function verdictCounts(r) {
  const counts = {};
  for (const {verdict} of resultsOf(r)) counts[verdict] = (counts[verdict] || 0) + 1;
  return counts;
}

// Each renderer's verdicts on one line.
function statisticsLine() {
  return h("section.statistics", {"aria-label": "Verdicts"}, Data.renderers.map((info, r) => {
    const counts = verdictCounts(r);
    return h("div.of-renderer", {}, h("b", {title: info.device + ", " + info.version}, info.name),
      verdictBar(counts), WORST_FIRST.filter((verdict) => counts[verdict]).map((verdict) =>
        h("a", {class: "v-" + verdict, href: Route.href({...NOWHERE, renderer: info.name, verdict})},
          verdictIcon(verdict), counts[verdict].toLocaleString("en") + " " + verdict)));
  }));
}

function diagnosticItem(d) {
  const place = d.file + (d.line ? ":" + d.line : "");
  return h("li", {}, h("code", {}, place), d.pointer && [" ", h("code.faint", {}, d.pointer)],
    h("div", {}, d.message, d.remedy && h("span.remedy", {}, " \u2192 " + d.remedy)));
}

function problems() {
  const drawn = Data.untrue.flatMap(([number, texts]) => texts.map((text) => h("li", {},
    h("a", {href: Route.href({case: Cases[number].id})}, Cases[number].title || Cases[number].id),
    h("div.lines", {}, text))));
  const box = (title, items) => items.length > 0 && h("details.problem", {open: items.length < 4},
    h("summary", {}, icon(BANG), title + " (" + items.length + ")"), h("ul", {}, items));
  return h("div.problems", {},
    box("Case files that cannot be loaded", Data.diagnostics.map(diagnosticItem)),
    box("Hand-drawn truths that the exact side does not meet", drawn));
}

// Known faults, a row each, with their cases by renderer.
function knownSection() {
  if (!Data.faults.length) return null;
  const rows = new Map();
  for (const fault of Data.faults) {
    const key = fault.id + "\n" + fault.reason;
    if (!rows.has(key)) rows.set(key, {fault, by: new Map()});
    rows.get(key).by.set(fault.renderer, fault);
  }
  const names = Data.renderers.map((info) => info.name)
    .filter((name) => Data.faults.some((fault) => fault.renderer === name));
  const moved = (fault) => fault.state !== "known";
  const cell = (name, fault) => h("td.count", {}, fault && [
    fault.smallest ? h("a", {href: Route.href({...NOWHERE, case: fault.smallest, on: name})},
      fault.cases.toLocaleString("en")) : fault.cases.toLocaleString("en"),
    moved(fault) && h("small", {class: fault.state === "grown" ? "alarm" : ""}, fault.told)]);
  const sorted = [...rows.values()].sort((a, b) =>
    Number([...b.by.values()].some(moved)) - Number([...a.by.values()].some(moved)));
  return h("section.first", {}, h("h2", {}, "Known faults ",
    h("span.faint", {}, plural(rows.size, "fault", "faults"),
      Data.faults.some(moved) && "; edgecase bless --apply renews their counts")),
  scrolled("Known faults", h("table.clusters.known", {},
    h("thead", {}, h("tr", {}, ["fault", "what"].map((text) => h("th", {scope: "col", class: text}, text)),
      names.map((name) => h("th.count", {scope: "col"}, name)))),
    h("tbody", {}, sorted.map(({fault, by}) => h("tr", {},
      h("th.mono", {scope: "row"}, fault.id),
      h("td.what", {dir: "auto"}, fault.reason, " ", originOf(fault.link)),
      names.map((name) => cell(name, by.get(name)))))))));
}

function causeCards() {
  if (!RedGroups.length) return null;
  const list = h("div.causes", {});
  const more = h("p.more", {});
  const paint = (count) => {
    replace(list, RedGroups.slice(0, count).map((group, i) => causeCard(group, i < PICTURED)));
    replace(more, RedGroups.length > count && h("button.link", {onclick: () => paint(RedGroups.length)},
      "Show " + (RedGroups.length - count).toLocaleString("en") + " more causes"));
  };
  paint(CARDS_SHOWN);
  return [list, more];
}

// Causes of which nothing is unexpected, a line each.
function legalSection() {
  const rest = Groups.filter((group) => !group.isRed);
  if (!rest.length) return null;
  return fold("Other differences, allowed, contested or known: " + plural(rest.length, "cause", "causes"), false,
    () => scrolled("Other differences", h("table.clusters", {}, h("tbody", {}, rest.map((group) =>
      h("tr", {}, h("td", {}, legality(group.first)),
        h("td.what", {}, h("a", {href: Route.href({...NOWHERE, cause: group.number})},
          groupTitle(group)), !group.first.cause && h("div.faint", {}, groupMeaning(group))),
        h("td.count", {}, plural(groupCounts(group)[0].cases, "case", "cases")),
        h("td", {}, group.renderers.join(", "))))))));
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

function overview() {
  return h("main.overview", {}, pageHead("overview"), headline(), portraits(),
    h("div", {id: "review"}, reviewBar()),
    causeCards(), problems(), changesSection(), knownSection(), legalSection(), statisticsLine());
}
