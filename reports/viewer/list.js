// SPDX-License-Identifier: MIT
// The list of cases: the cases of a sweep are one row that opens. Only rows near the visible part
// exist, of few elements each, so that thousands scroll smoothly.

const ROW_HEIGHT = 58;
const SPARE_ROWS = 2;  // beyond the visible part, on either side
const PRINTED_ROWS = 200;

// One row: a case, or the cases of a sweep.
class ListRow {
  constructor(cases, isPart) {
    this.cases = cases;
    this.isPart = isPart;  // of an open sweep
  }

  get isSweep() {
    return this.cases.length > 1;
  }

  // The worst case, the first of equals.
  get worst() {
    return this.cases.reduce((worst, one) =>
      (one.surprises > worst.surprises || (one.surprises === worst.surprises && one.worst > worst.worst)
        ? one : worst));
  }
}

const CaseList = {
  cases: [],
  rows: [],
  open: new Set(),  // heads of sweeps
  first: -1,
  last: -1,
  cursor: -1,       // of rows
  printing: false,

  show(state) {
    CaseList.cases = filteredCases(state);
    CaseList.first = CaseList.last = -1;
    CaseList.makeRows();
    CaseList.cursor = Math.min(CaseList.cursor, CaseList.rows.length - 1);
    const list = byId("list");
    list.style.setProperty("--columns", String(Data.renderers.length));
    list.style.setProperty("--bar", byId("bar").offsetHeight + "px");
    if (!CaseList.cases.length) {
      replace(list, h("p.empty", {}, "No case matches these filters."));
      return;
    }
    replace(list, listHead(), h("nav.rows", {"aria-label": "Cases"}));
    CaseList.resize();
    CaseList.paint();
  },

  // Cases of one file stand together in `cases` (filters.js).
  makeRows() {
    CaseList.rows = sweepsOf(CaseList.cases).flatMap((cases) => {
      const row = new ListRow(cases, false);
      return row.isSweep && CaseList.open.has(cases[0].head)
        ? [row, ...cases.map((one) => new ListRow([one], true))] : [row];
    });
  },

  resize() {
    const body = /** @type {HTMLElement} */ (document.querySelector("#list .rows"));
    body.style.height = CaseList.rows.length * ROW_HEIGHT + "px";
  },

  // Opens or closes the sweep of a row.
  toggle(index) {
    const {head} = CaseList.rows[index].cases[0];
    if (!CaseList.open.delete(head)) CaseList.open.add(head);
    CaseList.makeRows();
    CaseList.first = CaseList.last = -1;
    CaseList.resize();
    CaseList.paint();
    CaseList.focus(index);
  },

  // The row that shows a case.
  rowOf(one) {
    const at = CaseList.rows.findLastIndex((row) => row.cases.includes(one));
    return at < 0 ? CaseList.cursor : at;
  },

  // Makes the rows that can be seen now.
  paint() {
    const body = document.querySelector("#list .rows");
    if (!body || CaseList.printing) return;
    const top = -body.getBoundingClientRect().top;
    CaseList.paintRows(body, Math.max(0, Math.floor(top / ROW_HEIGHT) - SPARE_ROWS),
      Math.min(CaseList.rows.length, Math.ceil((top + innerHeight) / ROW_HEIGHT) + SPARE_ROWS));
  },

  // Paper shows the list from its beginning, wherever the screen is.
  paintForPrint() {
    const body = document.querySelector("#list .rows");
    if (!body) return;
    CaseList.printing = true;
    const count = Math.min(CaseList.rows.length, PRINTED_ROWS);
    CaseList.paintRows(body, 0, count);
    if (count < CaseList.rows.length) body.append(h("p.empty", {}, "The first " + count + " of " +
      plural(CaseList.rows.length, "row", "rows") + "; filters choose others."));
    CaseList.first = -1;  // paint anew on the screen
  },

  paintRows(body, first, last) {
    if (first === CaseList.first && last === CaseList.last) return;
    CaseList.first = first;
    CaseList.last = last;
    const active = /** @type {HTMLElement} */ (document.activeElement);
    const focused = body.contains(active) ? active.dataset.row : "";
    const rows = [];
    for (let i = first; i < last; ++i) rows.push(listRow(CaseList.rows[i], i));
    replace(body, rows);
    paintCharts(body);
    if (focused) CaseList.focus(focused);
  },

  focus(index) {
    const row = /** @type {HTMLElement} */ (document.querySelector('[data-row="' + index + '"]'));
    row?.focus({preventScroll: true});
  },

  // Moves the keyboard's row by `step` and brings it into sight.
  move(step) {
    const count = CaseList.rows.length;
    if (!count) return;
    CaseList.reveal(Math.max(0, Math.min(count - 1, CaseList.cursor + step)));
  },

  // Brings a row into sight and gives it the keyboard.
  reveal(index) {
    const body = document.querySelector("#list .rows");
    if (!body || index < 0) return;
    const top = body.getBoundingClientRect().top + index * ROW_HEIGHT;
    const head = byId("bar").offsetHeight + 30;
    if (top < head) scrollBy(0, top - head);
    else if (top + ROW_HEIGHT > innerHeight) scrollBy(0, top + ROW_HEIGHT - innerHeight + 8);
    CaseList.paint();
    CaseList.focus(index);
  },
};

// Neighbours of one file together.
function sweepsOf(cases) {
  const sweeps = [];
  for (const one of cases)
    if (sweeps.at(-1)?.[0].head === one.head) sweeps.at(-1).push(one);
    else sweeps.push([one]);
  return sweeps;
}

function listHead() {
  return h("div.list-head", {"aria-hidden": "true"}, h("span", {}), h("span", {}, "Case"),
    h("span.rules", {}, "Rules"),
    Data.renderers.map((info) => h("span.name", {title: info.name}, info.name)));
}

function resultCell(one, result) {
  const decision = Review.of(one, result);
  return h("span.cell", {class: "v-" + result.verdict, title: result.verdict}, result.verdict,
    decision ? h("small", {class: decision.decision}, REVIEWED[decision.decision].label) :
      isSurprise(result) && h("small.alarm", {}, STANDINGS[result.standing].label));
}

// How many cases of a sweep have its worst verdict, and a chart of all along the sweep.
function sweepCell(cases, r) {
  const counts = {};
  for (const one of cases) {
    const {verdict} = one.results[r];
    counts[verdict] = (counts[verdict] || 0) + 1;
  }
  const worst = WORST_FIRST.find((verdict) => counts[verdict]);
  const words = WORST_FIRST.filter((verdict) => counts[verdict])
    .map((verdict) => counts[verdict] + " " + verdict).join(", ");
  return h("span.cell", {class: "v-" + worst, title: words}, counts[worst] + " " + worst,
    h("canvas", {class: "chart", role: "img", "aria-label": words, "data-renderer": r}));
}

function listRow(row, index) {
  const {worst, isSweep} = row;
  const isOpen = isSweep && CaseList.open.has(worst.head);
  const thumbnail = h("canvas", {class: "thumbnail", "data-case": worst.index, "aria-hidden": "true"});
  const red = row.cases.reduce((sum, one) => sum + one.surprises, 0);
  const words = h("span.words", {}, h("b", {dir: "auto"}, worst.title || worst.id),
    h("small.mono", {}, isSweep ? Heads[worst.head].stem + "  " +
      plural(row.cases.length, "case", "cases") : worst.id));
  const props = {
    "data-row": index, class: (red ? "surprise" : "") + (row.isPart ? " part" : ""),
    onfocus: () => { CaseList.cursor = index; },
  };
  const inner = [thumbnail, words, h("span.rules.mono", {}, worst.rules.join(" "))];
  const element = isSweep
    ? h("button.row.sweep", {...props, type: "button", "aria-expanded": String(isOpen),
      onclick: () => CaseList.toggle(index)}, inner, worst.results.map((_, r) => sweepCell(row.cases, r)))
    : h("a.row", {...props, href: Route.href({...NO_PLACE, case: worst.id}),
      onclick: () => { CaseList.cursor = index; }}, inner,
    worst.results.map((result) => resultCell(worst, result)));
  element.style.top = index * ROW_HEIGHT + "px";
  return element;
}

addEventListener("beforeprint", () => CaseList.paintForPrint());
addEventListener("afterprint", () => {
  CaseList.printing = false;
  CaseList.paint();
});
for (const event of ["scroll", "resize"])
  addEventListener(event, () => requestAnimationFrame(CaseList.paint), {passive: true});

function casesView(state) {
  return h("main.overview.cases-view", {}, pageHead("cases"), h("div", {id: "review"}, reviewBar()),
    h("div", {id: "bar"}, filterBar(state)), h("div", {id: "list"}));
}
