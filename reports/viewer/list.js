// SPDX-License-Identifier: MIT
// The list of cases. Only rows near the visible part exist, so that thousands scroll smoothly.

const ROW_HEIGHT = 58;

const CaseList = {
  cases: [],
  first: -1,
  last: -1,
  cursor: -1,

  show(state) {
    CaseList.cases = filteredCases(state);
    CaseList.first = CaseList.last = -1;
    CaseList.cursor = Math.min(CaseList.cursor, CaseList.cases.length - 1);
    const list = byId("list");
    list.style.setProperty("--columns", String(Report.renderers.length));
    if (!CaseList.cases.length) {
      replace(list, h("p.empty", {}, "No case matches these filters."));
      return;
    }
    const body = h("div.rows", {role: "list", "aria-label": "Cases"});
    body.style.height = CaseList.cases.length * ROW_HEIGHT + "px";
    replace(list, listHead(), body);
    CaseList.paint();
  },

  // Makes the rows that can be seen now.
  paint() {
    const body = document.querySelector("#list .rows");
    if (!body) return;
    const top = -body.getBoundingClientRect().top;
    const first = Math.max(0, Math.floor(top / ROW_HEIGHT) - 8);
    const last = Math.min(CaseList.cases.length,
      Math.ceil((top + innerHeight) / ROW_HEIGHT) + 8);
    if (first === CaseList.first && last === CaseList.last) return;
    CaseList.first = first;
    CaseList.last = last;
    const focused = body.contains(document.activeElement) ? document.activeElement.dataset.row : "";
    const rows = [];
    for (let i = first; i < last; ++i) rows.push(caseRow(CaseList.cases[i], i));
    replace(body, rows);
    if (focused) body.querySelector('[data-row="' + focused + '"]')?.focus({preventScroll: true});
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
    body.querySelector('[data-row="' + index + '"]')?.focus({preventScroll: true});
  },
};

function listHead() {
  return h("div.list-head", {"aria-hidden": "true"}, h("span", {}, "Case"), h("span", {}, "Rules"),
    Report.renderers.map((info) => h("span", {title: info.name}, info.name)));
}

function resultCell(result) {
  if (!result) return h("span.cell", {}, "\u2013");
  return h("span.cell", {}, verdictBadge(result.verdict),
    isSurprise(result) && h("small.alarm", {}, STANDINGS[result.standing].label));
}

function caseRow(one, index) {
  const row = h("a.row", {
    href: Route.href({case: one.id, on: "", at: ""}), "data-row": index,
    class: one.surprises ? "surprise" : "",
    onclick: () => { CaseList.cursor = index; },
    onfocus: () => { CaseList.cursor = index; },
  },
  h("span.words", {}, h("b", {dir: "auto"}, one.title || one.id), h("small.mono", {}, one.id)),
  h("span.rules", {}, one.rules.map((id) => h("span.chip", {}, id))),
  one.results.map(resultCell));
  row.style.top = index * ROW_HEIGHT + "px";
  return h("div", {role: "listitem"}, row);
}

for (const event of ["scroll", "resize"])
  addEventListener(event, () => requestAnimationFrame(CaseList.paint), {passive: true});
