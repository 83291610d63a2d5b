// SPDX-License-Identifier: MIT
// The list of cases. Only rows near the visible part exist, of few elements each, so that thousands
// scroll smoothly.

const ROW_HEIGHT = 58;
const SPARE_ROWS = 2;  // beyond the visible part, on either side
const PRINTED_ROWS = 200;

const CaseList = {
  cases: [],
  first: -1,
  last: -1,
  cursor: -1,
  printing: false,

  show(state) {
    CaseList.cases = filteredCases(state);
    CaseList.first = CaseList.last = -1;
    CaseList.cursor = Math.min(CaseList.cursor, CaseList.cases.length - 1);
    const list = byId("list");
    list.style.setProperty("--columns", String(Data.renderers.length));
    if (!CaseList.cases.length) {
      replace(list, h("p.empty", {}, "No case matches these filters."));
      return;
    }
    const body = h("nav.rows", {"aria-label": "Cases"});
    body.style.height = CaseList.cases.length * ROW_HEIGHT + "px";
    replace(list, listHead(), body);
    CaseList.paint();
  },

  // Makes the rows that can be seen now.
  paint() {
    const body = document.querySelector("#list .rows");
    if (!body || CaseList.printing) return;
    const top = -body.getBoundingClientRect().top;
    CaseList.paintRows(body, Math.max(0, Math.floor(top / ROW_HEIGHT) - SPARE_ROWS),
      Math.min(CaseList.cases.length, Math.ceil((top + innerHeight) / ROW_HEIGHT) + SPARE_ROWS));
  },

  // Paper shows the list from its beginning, wherever the screen is.
  paintForPrint() {
    const body = document.querySelector("#list .rows");
    if (!body) return;
    CaseList.printing = true;
    const count = Math.min(CaseList.cases.length, PRINTED_ROWS);
    CaseList.paintRows(body, 0, count);
    if (count < CaseList.cases.length) body.append(h("p.empty", {}, "The first " + count + " of " +
      plural(CaseList.cases.length, "case", "cases") + "; filters choose others."));
    CaseList.first = -1;  // paint anew on the screen
  },

  paintRows(body, first, last) {
    if (first === CaseList.first && last === CaseList.last) return;
    CaseList.first = first;
    CaseList.last = last;
    const active = /** @type {HTMLElement} */ (document.activeElement);
    const focused = body.contains(active) ? active.dataset.row : "";
    const rows = [];
    for (let i = first; i < last; ++i) rows.push(caseRow(CaseList.cases[i], i));
    replace(body, rows);
    if (focused) CaseList.focus(focused);
  },

  focus(index) {
    const row = /** @type {HTMLElement} */ (document.querySelector('[data-row="' + index + '"]'));
    row?.focus({preventScroll: true});
  },

  // Moves the keyboard's row by `step` and brings it into sight.
  move(step) {
    const count = CaseList.cases.length;
    if (!count) return;
    CaseList.reveal(Math.max(0, Math.min(count - 1, CaseList.cursor + step)));
  },

  // Brings a row into sight and gives it the keyboard.
  reveal(index) {
    const body = document.querySelector("#list .rows");
    if (!body || index < 0) return;
    const top = body.getBoundingClientRect().top + index * ROW_HEIGHT;
    const head = 96;
    if (top < head) scrollBy(0, top - head);
    else if (top + ROW_HEIGHT > innerHeight) scrollBy(0, top + ROW_HEIGHT - innerHeight + 8);
    CaseList.paint();
    CaseList.focus(index);
  },
};

function listHead() {
  return h("div.list-head", {"aria-hidden": "true"}, h("span", {}, "Case"), h("span", {}, "Rules"),
    Data.renderers.map((info) => h("span", {title: info.name}, info.name)));
}

function resultCell(one, result) {
  const decision = Review.of(one, result);
  return h("span.cell", {class: "v-" + result.verdict}, result.verdict,
    decision ? h("small", {class: decision.decision}, REVIEWED[decision.decision].label) :
      isSurprise(result) && h("small.alarm", {}, STANDINGS[result.standing].label));
}

function caseRow(one, index) {
  const row = h("a.row", {
    href: Route.href({...NO_PLACE, case: one.id}), "data-row": index,
    class: one.surprises ? "surprise" : "",
    onclick: () => { CaseList.cursor = index; },
    onfocus: () => { CaseList.cursor = index; },
  },
  h("span.words", {}, h("b", {dir: "auto"}, one.title || one.id), h("small.mono", {}, one.id)),
  h("span.rules.mono", {}, one.rules.join(" ")),
  one.results.map((result) => resultCell(one, result)));
  row.style.top = index * ROW_HEIGHT + "px";
  return row;
}

addEventListener("beforeprint", () => CaseList.paintForPrint());
addEventListener("afterprint", () => {
  CaseList.printing = false;
  CaseList.paint();
});
for (const event of ["scroll", "resize"])
  addEventListener(event, () => requestAnimationFrame(CaseList.paint), {passive: true});
