// SPDX-License-Identifier: MIT A card for each cause: what in words, its smallest case as a live
// picture, rule and clause, where it shows, and what can be done about it.

// "7 cases, fragments drawn twice: not allowed".
function countLine(group) {
  const counts = groupCounts(group);
  return h("p.counts", {}, counts.map(({legality: of, kind, cases, differences}) => h("span", {},
    legality({legality: of}), ": " + plural(differences, "difference", "differences") + " in " +
    plural(cases, "case", "cases") + (kind && counts.length > 1 && KIND_WORDS[kind]
      ? " (" + KIND_WORDS[kind] + ")" : ""))));
}

// Rule, ruling and clause of the disagreement that the card shows.
function clauseLine(group, d) {
  const rule = Rules.get(d?.rule || group.first?.rule || group.first?.cause.split(/[=+]/)[0]);
  return h("p.facts", {}, rule && ruleChip(rule.id), d?.ruling && rulingChip(d.ruling),
    rule?.spec && h("span", {}, rule.spec));
}

function rendererLine(group) {
  const answers = (name) => group.answers.filter(({result}) => result.renderer === name).length;
  return h("p.facts", {}, group.renderers.map((name) => h("span", {}, name +
    (answers(name) ? ": " + plural(answers(name), "answer", "answers") : ""))));
}

// The actions of a card; `form` is its decision's.
function cardActions(group, form) {
  const {place} = group;
  const one = place && CasesById.get(place.case);
  const result = one?.results.find((r) => r.renderer === place.on);
  return h("div.actions", {}, form?.element,
    place && h("a.button", {href: Route.href({...NOWHERE, cause: group.isRed ? group.number : "", ...place}),
      title: "Its smallest case (Enter)"}, "Open"),
    group.isRed && h("a.button", {href: Route.href({...NOWHERE, cause: group.number})},
      plural(group.answers.length, "case", "cases")),
    one && h("button", {type: "button", title: "Copy the command that asks for this case again",
      onclick: (event) => copyText(commandsFor(one, result, null)[0], event.currentTarget)},
    "Copy command"));
}

// Shows the cause's smallest case when its details are there.
function fillGlance(group, glance, words) {
  const {place} = group;
  const one = CasesById.get(place?.case);
  if (!one) return;
  loadDetails(one).then(() => {
    const result = one.results.find((r) => r.renderer === place.on);
    const d = result.answer.disagreements[Number(place.at || 1) - 1];
    replace(words, clauseLine(group, d), h("p.sentence", {dir: "auto"}, result.failure
      ? result.failure.reason : d ? d.explanation : ""));
    if (glance && one.pixels) glance.show(one, result, d);
  }, (fault) => replace(words, h("p.faint", {}, "The details of its smallest case: " + fault.message)));
}

function causeCard(group, isPictured, isWhole) {
  const {place} = group;
  const words = h("div", {}, clauseLine(group, null));
  const href = place && Route.href({...NOWHERE, cause: group.isRed ? group.number : "", ...place});
  const glance = isPictured && place ? new Glance(href, place.case) : null;
  const form = groupForm(group, () => Overview.decided(group));
  const decided = group.isRed && Review.answers().filter((a) => a.result.group === group && a.decided).length;
  const card = h("article.card.cause", {
    tabindex: "-1", "data-cause": group.number, "aria-label": groupTitle(group),
    class: group.first ? "c-" + group.first.legality : "c-illegal",
  },
  glance?.element,
  h("div.cause-words", {},
    h(isWhole ? "h1" : "h2", {tabindex: isWhole ? "-1" : undefined, dir: "auto"}, groupTitle(group)),
    groupMeaning(group) && h("p.faint", {dir: "auto"}, groupMeaning(group)),
    countLine(group), words, rendererLine(group),
    decided > 0 && h("p.faint", {}, decided + " of " + group.answers.length + " decided"),
    cardActions(group, form)));
  Overview.forms.set(group, {form, card});
  fillGlance(group, glance, words);
  return card;
}

// What the keyboard does with cards.
const Overview = {
  forms: new Map(),  // group -> {form, card}

  cards: () => [...document.querySelectorAll(".cause")].filter((card) => card instanceof HTMLElement),

  // The group of the card that has the keyboard, else the first one that is not decided.
  group() {
    const card = document.activeElement.closest(".cause");
    const number = card instanceof HTMLElement ? Number(card.dataset.cause) : 0;
    const shown = Overview.cards().map((each) => Groups[Number(each.dataset.cause) - 1]);
    return Groups[number - 1] || shown.find((group) => !Review.causes.has(group.key)) || shown[0];
  },

  ask(word) {
    const group = Overview.group();
    Overview.forms.get(group)?.form?.ask(word);
  },

  open() {
    const {place, isRed, number} = Overview.group() || {};
    if (place) Route.go({...NOWHERE, cause: isRed ? number : "", ...place});
  },

  move(step) {
    const cards = Overview.cards();
    const at = cards.indexOf(document.activeElement.closest(".cause"));
    const next = cards[Math.max(0, Math.min(cards.length - 1, at + step))];
    next?.focus();
    next?.scrollIntoView({block: "nearest"});
  },

  // After a decision the keyboard goes on to the next cause, or to the export.
  decided(group) {
    const card = causeCard(group, Overview.forms.get(group).card.querySelector("canvas") !== null,
      Route.viewOf(Route.read()) === "cause");
    const old = [...Overview.cards()].find((each) => Number(each.dataset.cause) === group.number);
    old.replaceWith(card);
    replace(byId("review"), reviewBar());
    if (byId("list")) CaseList.show(Route.read());
    const next = RedGroups.find((one) => !Review.causes.has(one.key) && Overview.forms.get(one)?.form?.decide);
    const target = Review.causes.has(group.key) && next && Overview.forms.get(next).card.isConnected
      ? Overview.forms.get(next).card : byId("export") || card;
    target.focus();
  },
};

// The page of one cause: its card, and the list of its cases.
function causeView(group) {
  return h("main.overview.of-cause", {}, pageHead(""),
    h("div", {id: "review"}, reviewBar()), causeCard(group, true, true),
    otherPlaces(group), situationTable(group), group.isRed && [h("div", {id: "bar"}), h("div", {id: "list"})]);
}

// Where on their primitives differences without a cause lie.
function situationTable(group) {
  const situations = situationsOf(group);
  if (situations.length < 2) return null;
  return scrolled("Where on a primitive", h("table.clusters", {},
    h("thead", {}, h("tr", {}, ["where on a primitive", "differences", "cases"]
      .map((text) => h("th", {scope: "col"}, text)))),
    h("tbody", {}, situations.map(([words, differences, cases]) => h("tr", {},
      h("td.what", {dir: "auto"}, words), h("td.count", {}, differences.toLocaleString("en")),
      h("td.count", {}, cases.toLocaleString("en")))))));
}

// Where else it shows: the smallest case of each renderer, surface and legality.
function otherPlaces(group) {
  if (group.clusters.length < 2) return null;
  return scrolled("Where it shows", h("table.clusters", {},
    h("thead", {}, h("tr", {}, ["renderer", "surface", "", "differences", "cases", "smallest case"]
      .map((text) => (text ? h("th", {scope: "col"}, text) : h("td", {}))))),
    h("tbody", {}, group.clusters.map((cluster) => h("tr", {},
      h("td", {}, cluster.renderer), h("td", {}, cluster.surface), h("td", {}, legality(cluster)),
      h("td.count", {}, cluster.disagreements.toLocaleString("en")),
      h("td.count", {}, cluster.cases.toLocaleString("en")),
      h("td.smallest", {}, h("a.mono", {href: Route.href({...NOWHERE, case: cluster.smallest,
        on: cluster.renderer, at: cluster.at || ""})}, cluster.smallest)))))));
}
