// SPDX-License-Identifier: MIT
// One case: the words of its author, one renderer's answer at a time, and its pictures.

const CaseView = {
  one: null,
  result: null,
  pictures: null,
  ramps: null,
  list: null,
  rehearsed: 0,
  form: null,  // of the decision on its answer
  index: -1,   // of the chosen disagreement
  pixel: null, // the chosen one, {x, y}
  frame: 0,    // of the pending display of fragments
  parts: null,

  close() {
    CaseView.pictures?.destroy();
    CaseView.ramps?.destroy();
    CaseView.one = CaseView.result = CaseView.pictures = CaseView.ramps = CaseView.form = null;
  },

  // The result to open first: the named renderer's, else the worst.
  resultFor(one, name) {
    const named = one.results.find((r) => r.renderer === name);
    const score = (r) => (isSurprise(r) ? 10 : 0) + VERDICTS[r.verdict].rank;
    return named || one.results.reduce((best, r) => (!best || score(r) > score(best) ? r : best),
      null);
  },

  show(one, state) {
    const result = CaseView.resultFor(one, state.on || state.renderer);
    if (one === CaseView.one && result === CaseView.result) CaseView.place(state);
    else CaseView.put(byId("app"), one, result, state);
  },

  // Into an element of the page.
  put(element, one, result, state) {
    CaseView.close();
    CaseView.one = one;
    CaseView.result = result;
    replace(element, caseHead(one, state), result ? CaseView.build(one, result)
      : h("main.case", {}, h("h1", {tabindex: "-1"}, one.title || one.id),
        h("p.card", {}, "No renderer was run on this case."), caseWords(one)));
    if (!result) return;
    CaseView.place(state);
    CaseView.pictures?.zoomTo(Number(state.zoom));
  },

  // Renders the cases of `left` off-screen in idle time and removes them: a browser takes twice as
  // long for the first cases that it shows.
  async rehearse(left) {
    const here = Cases.filter((one) => one.line !== undefined && Blocks.isHere(one.line));
    const one = here[left - 1];
    if (one) await loadDetails(one);
    if (!one || CaseView.one) return;  // a case was opened meanwhile
    const stage = h("div.rehearsal", {"aria-hidden": "true"});
    document.body.append(stage);
    CaseView.put(stage, one, CaseView.resultFor(one, ""), {...Route.read(), ...NO_PLACE});
    CaseView.close();
    stage.remove();
    ++CaseView.rehearsed;
    if (left > 1) requestIdleCallback(() => CaseView.rehearse(left - 1).catch(() => {}));
  },

  // Shows the place in a link: a disagreement, or a pixel.
  place(state) {
    const [x, y] = state.px.split(",").map(Number);
    const inside = Number.isInteger(x) && Number.isInteger(y) && x >= 0 && y >= 0 &&
      x < CaseView.one.width && y < CaseView.one.height;
    if (inside && state.px && !state.at) CaseView.pick(x, y);
    else CaseView.choose(state.at, false);
  },

  note(changes) {
    Route.note({case: CaseView.one.id, on: CaseView.result.renderer, ...changes});
  },

  build(one, result) {
    const {answer} = result;
    CaseView.parts = {
      finding: h("div.finding", {"aria-live": "polite"}), commands: h("div", {}),
      stepper: h("span.steps", {}), review: h("div", {}), fragments: h("div", {}),
    };
    CaseView.pictures = one.pixels
      ? new Pictures(one, result, CaseView.pick, (zoom) => CaseView.note({zoom})) : null;
    CaseView.showReview();
    CaseView.ramps = new Ramps(one, result, CaseView.pickOf);
    CaseView.list = new DisagreementList(answer, (index) => CaseView.choose(index, true));
    return h("main.case", {}, caseTop(one, result), h("div.stage", {},
      h("div.shown", {}, CaseView.ramps.element, CaseView.pictures?.element ||
        h("p.card.faint", {}, one.line === undefined
          ? "Every renderer agrees, as expected: this report has no pictures of such cases. The " +
            "command below draws them again." : "There are no pictures.")),
      CaseView.column(one, result)),
    CaseView.parts.fragments, CaseView.list.element,
    valuesSection(answer, CaseView.pick), evidenceSection(answer),
    h("section.card", {}, h("h2", {}, "Reproduce"), CaseView.parts.commands),
    h("section.card", {}, caseWords(one), samplePlan(one, result), verticesOf(one.figure),
      sourceOf(one)));
  },

  // Beside the pictures: verdict, what was found, the decision, and one more picture.
  column(one, result) {
    return h("section.answer", {role: "tabpanel", id: "answer", "aria-label": result.renderer},
      h("div.result-line", {}, verdictBadge(result.verdict), standingBadge(result.standing),
        CaseView.parts.stepper),
      truthFaults(one), CaseView.parts.finding, CaseView.parts.review,
      result.standing_reason && h("p.faint", {dir: "auto"}, result.standing_reason),
      CaseView.pictures && h("div.beside", {}, CaseView.pictures.side.element),
      pixelLine(result.pixel_counts));
  },

  // Chooses a disagreement by its number; `at` of the route is 1 for the first.
  choose(at, write) {
    const all = CaseView.result.answer.disagreements;
    const index = write ? at : Math.min(Math.max(Number(at) - 1 || 0, 0), all.length - 1);
    if (write) CaseView.note({at: index + 1, px: ""});
    CaseView.index = index;
    CaseView.tell(all[index] || null, all[index] || worstPlace(CaseView.result.answer));
    CaseView.list.show(index);
    CaseView.pictures?.select(all[index] || null, all[index] ? null : CaseView.pixel);
  },

  // A pixel was clicked: its (next) disagreement, or the pixel alone.
  pick(x, y) {
    const all = CaseView.result.answer.disagreements;
    const here = all.map((d, i) => [d, i]).filter(([d]) => d.x === x && d.y === y);
    if (here.length) {
      const next = here.find(([, i]) => i > CaseView.index) || here[0];
      return CaseView.choose(next[1], true);
    }
    CaseView.index = -1;
    CaseView.tell(null, {x, y});
    CaseView.note({at: "", px: x + "," + y});
    CaseView.list.show(-1);
    CaseView.pictures?.select(null, {x, y});
  },

  // A pixel of another renderer's answer was clicked: shows its disagreement with that renderer.
  pickOf(result, x, y) {
    const index = result.answer.disagreements.findIndex((d) => d.x === x && d.y === y);
    if (result.answer === CaseView.result.answer || index < 0) return CaseView.pick(x, y);
    Route.go({case: CaseView.one.id, on: result.renderer, at: index + 1, px: ""});
  },

  showReview() {
    CaseView.form = answerForm(CaseView.one, CaseView.result, () => {
      CaseView.showReview();
      document.querySelector("h1").focus({preventScroll: true});
    });
    replace(CaseView.parts.review, CaseView.form?.element);
  },

  step(by) {
    const count = CaseView.result ? CaseView.result.answer.disagreements.length : 0;
    if (!count) return;
    const from = CaseView.index < 0 && by < 0 ? 0 : CaseView.index;
    CaseView.choose((from + by + count) % count, true);
  },

  // Writes the finding and the commands for a disagreement or a pixel.
  tell(disagreement, pixel) {
    CaseView.pixel = pixel && {x: pixel.x, y: pixel.y};
    const count = CaseView.result.answer.disagreements.length;
    replace(CaseView.parts.finding,
      disagreement ? findingOf(disagreement) : nothingFound(CaseView.one, CaseView.result, pixel));
    replace(CaseView.parts.stepper,
      stepper(CaseView.index, count, (index) => CaseView.choose(index, true)));
    replace(CaseView.parts.commands,
      commandsFor(CaseView.one, CaseView.result, CaseView.pixel).map(commandLine));
    CaseView.ramps.mark(CaseView.pixel);
    CaseView.tellFragments();
  },

  // The fragments are below the pictures, which are drawn first.
  tellFragments() {
    const {parts, one, result, pixel} = CaseView;
    cancelAnimationFrame(CaseView.frame);
    CaseView.frame = requestAnimationFrame(() =>
      replace(parts.fragments, fragmentsSection(one, result.answer, pixel)));
  },
};

function worstPlace(answer) {
  const values = answer.values.find((v) => v.differing);
  return values ? values.worst : null;
}

function nothingFound(one, result, pixel) {
  const {answer} = result;
  if (result.failure)
    return h("p.sentence", {}, h("b", {}, result.failure.kind + ": "), result.failure.reason);
  if (answer.disagreements.length)
    return h("p.sentence", {}, "Nothing is listed at pixel (" + pixel.x + ", " + pixel.y + ").");
  const values = answer.values.filter((v) => v.differing);
  if (values.length)
    return h("p.sentence", {}, values.map((v) => v.differing.toLocaleString("en") + " of " +
      v.compared.toLocaleString("en") + " " + v.attribute + " values differ within what is " +
      "permitted; the worst, at pixel (" + v.worst.x + ", " + v.worst.y + "), by " +
      short(v.worst.ulp) + " ULP. "));
  return h("p.sentence", {}, "Nothing differs: both draw the same " +
    plural(one.fragments, "fragment", "fragments") + ".");
}

function rendererTabs(one, chosen) {
  if (one.results.length < 2) return h("span.faint", {}, chosen.renderer);
  return h("div.tabs", {role: "tablist", "aria-label": "Renderers"}, one.results.map((result) =>
    h("a", {
      role: "tab", "aria-selected": result === chosen ? "true" : "false", "aria-controls": "answer",
      href: Route.href({case: one.id, on: result.renderer, at: "", px: ""}),
      title: result.verdict + ", " + result.standing,
    }, verdictIcon(result.verdict), result.renderer,
    h("span.unseen", {}, " " + result.verdict),
    isSurprise(result) && h("span.standing.alarm", {}, icon(BANG),
      h("span.unseen", {}, STANDINGS[result.standing].label)))));
}

// The title and the renderers, on one line.
function caseTop(one, result) {
  return h("header.top", {},
    h("h1", {tabindex: "-1", dir: "auto"}, one.title || one.id), rendererTabs(one, result));
}

function caseHead(one, state) {
  const cases = filteredCases(state);
  const at = cases.indexOf(one);
  const link = (step, text, label) => {
    const next = cases[at + step];
    return next && at >= 0 ? h("a.button", {
      href: Route.href({case: next.id, at: "", px: ""}), "aria-label": label, title: label,
    }, text) : h("span.button.off", {"aria-hidden": "true"}, text);
  };
  const back = {overview: "Overview", cause: "Its cause", cases: "Cases", statistics: "Statistics",
    generations: "Generations"}[Route.viewOf({...state, ...NO_PLACE})];
  return h("nav.bar", {"aria-label": "Cases"},
    h("a.button", {href: Route.href(NO_PLACE), title: back + " (Esc)"}, "\u2190 " + back),
    h("span.mono.path", {}, one.id),
    h("span.group", {}, link(-1, "\u2039", "Previous case (k)"),
      at >= 0 && h("span.faint", {}, at + 1 + " of " + cases.length),
      link(1, "\u203a", "Next case (j)")),
    h("button.quiet", {onclick: showHelp, "aria-label": "Keys"}, h("kbd", {}, "?")));
}

function originOf(origin) {
  if (!origin) return null;
  if (!/^https?:\/\//i.test(origin)) return h("span", {}, origin);
  return h("a", {href: origin, rel: "noopener noreferrer", target: "_blank"}, "origin \u2197");
}

// What the author of the case says of it.
function caseWords(one) {
  return h("div.words", {}, h("h2", {}, "About this case"),
    one.why && h("p.why", {dir: "auto"}, one.why),
    h("p.facts", {}, one.rules.map(ruleChip), one.spec && h("span", {}, one.spec),
      h("span", {}, one.width + " \u00d7 " + one.height + " " + one.surface),
      one.samples && h("span", {}, plural(one.samples.count, "sample", "samples") + " a pixel"),
      one.tags.map((tag) => h("span", {}, "#" + tag)), originOf(one.origin)));
}

function truthFaults(one) {
  if (!one.expect_failures.length) return null;
  return h("div.card.alarm-box", {},
    h("b", {}, icon(BANG), " The exact side does not meet this case's hand-drawn truth"),
    one.expect_failures.map((text) => h("div.lines", {}, text)));
}
