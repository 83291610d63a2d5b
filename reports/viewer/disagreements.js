// SPDX-License-Identifier: MIT Disagreements as text: the chosen one beside the pictures, all of
// them in pages below.

const PAGE = 25;

function legality(d) {
  const words = LEGALITIES[d.legality];
  return h("span.legal", {class: words.class},
    d.legality === "contested" && verdictIcon("contested"), words.label);
}

const pixelText = (d) =>
  "pixel (" + d.x + ", " + d.y + ")" + (d.sample === undefined ? "" : " sample " + d.sample);
const primitiveText = (d) => (d.primitive === undefined ? "" : "primitive " + d.primitive);

// The chosen disagreement: its kind, place, rule and explanation, and its numbers on a line.
function findingOf(d) {
  const long = d.explanation.length > 600;
  const lines = d.kind === "value" ? numberLines(d) : [];
  const sentence = h("p.sentence", {dir: "auto", tabindex: long ? "0" : undefined}, d.explanation);
  return [
    h("div.facts-line", {}, kindLabel(d.kind), h("b.mono", {}, pixelText(d)), legality(d)),
    lines, lines.length ? h("details", {}, h("summary", {}, "In words"), sentence) : sentence,
    h("div.facts-line", {}, ruleChip(d.rule), d.ruling && rulingChip(d.ruling),
      d.cause ? h("span", {}, "cause ", causeChips(d.cause)) : h("i.faint", {}, "no cause found")),
  ];
}

// Keyboard and buttons go through all of a result's disagreements, the worst first.
function stepper(index, count, choose) {
  if (count < 2) return null;
  const at = (step) => (Math.max(index, step < 0 ? 0 : -1) + step + count) % count;
  return h("span.stepper", {},
    h("button", {"aria-label": "Previous disagreement (p)", title: "Previous (p)",
      onclick: () => choose(at(-1))}, "\u2039"),
    h("span", {}, (index < 0 ? "\u2013" : index + 1) + " of " + count.toLocaleString("en")),
    h("button", {"aria-label": "Next disagreement (n)", title: "Next (n)",
      onclick: () => choose(at(1))}, "\u203a"));
}

function disagreementRow(d, index, count, chosen, choose) {
  return h("div.item", {
    role: "option", tabindex: "0", "aria-selected": index === chosen ? "true" : "false",
    "data-item": index, "aria-posinset": index + 1, "aria-setsize": count, onclick: () => choose(index),
    onkeydown: (event) => {
      if (event.key !== "Enter" && event.key !== " ") return;
      event.preventDefault();
      choose(index);
    },
  },
  h("span.number", {}, index + 1), kindLabel(d.kind),
  h("span.mono", {}, pixelText(d)), h("span", {}, primitiveText(d)),
  h("span.mono", {}, d.rule), legality(d),
  h("span", {}, d.ruling ? "ruling " + d.ruling : ""),
  h("span.mono.cause", {}, d.cause || h("i.faint", {}, "no cause found")),
  h("p", {dir: "auto"}, d.explanation));
}

// The list, one page at a time; show(index) marks a row and turns to its page. Empty before that.
class DisagreementList {
  constructor(answer, choose) {
    this.list = answer.disagreements;
    this.omitted = answer.omitted || 0;
    this.choose = choose;
    this.chosen = -1;
    this.page = 0;
    this.frame = 0;
    const sampled = this.list.some((d) => d.sample !== undefined);
    this.body = h("div.items", {
      class: sampled ? "sampled" : "", role: "listbox", "aria-label": "Disagreements",
    });
    this.pager = h("div.pager", {});
    const count = answer.total || this.list.length + this.omitted;
    this.element = count > 0 && h("section.card", {},
      h("h2", {}, "Disagreements ", h("span.faint", {}, count.toLocaleString("en")), this.pager),
      this.body,
      this.omitted > 0 && h("p.faint", {}, plural(this.omitted, "more is", "more are") +
        " left out of this report; the results file has all of them."),
      (answer.counted || []).map((line) => h("p.faint", {}, line)));
  }

  show(index) {
    this.chosen = index;
    if (index >= 0) this.page = Math.floor(index / PAGE);
    // The list is below the pictures, which are drawn first.
    cancelAnimationFrame(this.frame);
    this.frame = requestAnimationFrame(() => this.paint());
  }

  paint() {
    const from = this.page * PAGE;
    const rows = this.list.slice(from, from + PAGE);
    replace(this.body, rows.map((d, i) =>
      disagreementRow(d, from + i, this.list.length, this.chosen, this.choose)));
    const pages = Math.ceil(this.list.length / PAGE);
    if (pages < 2) return;
    const turn = (step) => {
      this.page = (this.page + step + pages) % pages;
      this.paint();
    };
    replace(this.pager,
      h("button", {"aria-label": "Previous page", onclick: () => turn(-1)}, "\u2039"),
      " " + (this.page + 1) + " / " + pages + " ",
      h("button", {"aria-label": "Next page", onclick: () => turn(1)}, "\u203a"));
  }
}
