// SPDX-License-Identifier: MIT The reviewer's decisions on unexpected answers: all that begin with
// one cause at once, or single ones, which overrule that. They are kept in the browser for this
// report, and exported as the file that `edgecase bless --from` applies (src/results/decisions.h).

const REVIEW_PLACE = "edgecase-review:" + Data.key;
const REVIEWED = {
  accept: {label: "accepted", path: VERDICTS.agree.path, verb: "Accept"},
  reject: {label: "rejected", path: VERDICTS.violation.path, verb: "Reject"},
};

const isDecidable = (result) => result.group !== undefined && result.standing !== "flake";

const Review = {
  own: new Map(),     // case and renderer -> {decision, reason}; without a decision: none holds
  causes: new Map(),  // key of a group -> {decision, reason}
  kept: true,         // does the browser keep them?

  key: (id, renderer) => JSON.stringify([id, renderer]),

  // The decision that holds for an answer, {decision, reason, isOwn}; undefined: none.
  of(one, result) {
    if (!isDecidable(result)) return undefined;
    const own = Review.own.get(Review.key(one.id, result.renderer));
    if (own) return own.decision ? {...own, isOwn: true} : undefined;
    return Review.causes.get(result.group.key);
  },

  read() {
    try {
      const kept = JSON.parse(localStorage.getItem(REVIEW_PLACE) || "{}");
      Review.own = new Map(kept.own || []);
      Review.causes = new Map(kept.causes || []);
    } catch (fault) {
      Review.kept = false;
    }
  },

  keep() {
    try {
      localStorage.setItem(REVIEW_PLACE,
        JSON.stringify({own: [...Review.own], causes: [...Review.causes]}));
    } catch (fault) {
      Review.kept = false;
    }
    forgetFilter();
  },

  // `word`: "accept", "reject", or "" for none although its cause has one.
  decide(one, result, word, reason) {
    const key = Review.key(one.id, result.renderer);
    if (word || Review.causes.has(result.group.key)) Review.own.set(key, {decision: word, reason});
    else Review.own.delete(key);
    Review.keep();
  },

  // Decides on all answers of a group; earlier decisions on single ones go.
  decideAll(group, word, reason) {
    for (const {one, result} of group.answers) Review.own.delete(Review.key(one.id, result.renderer));
    if (word) Review.causes.set(group.key, {decision: word, reason});
    else Review.causes.delete(group.key);
    Review.keep();
  },

  clear() {
    Review.own.clear();
    Review.causes.clear();
    Review.keep();
  },

  // All answers that can be decided on, with the decision on each.
  answers() {
    return RedGroups.flatMap((group) => group.answers)
      .filter(({result}) => isDecidable(result))
      .map((answer) => ({...answer, decided: Review.of(answer.one, answer.result)}));
  },

  // The file of decisions.
  text() {
    const decisions = Review.answers().filter(({decided}) => decided)
      .map(({one, result, fingerprint, decided}) => ({
        case: one.id, renderer: result.renderer, verdict: result.verdict, fingerprint,
        decision: decided.decision, reason: decided.reason,
      }));
    decisions.sort((a, b) =>
      a.renderer < b.renderer ? -1 : a.renderer > b.renderer ? 1 : a.case < b.case ? -1 : 1);
    return JSON.stringify({edgecase_decisions: 2, decisions}, null, 2) + "\n";
  },
};
Review.read();

function downloadDecisions() {
  if (!Review.own.size && !Review.causes.size) return say("Nothing is decided.");
  const url = URL.createObjectURL(new Blob([Review.text()], {type: "application/json"}));
  h("a", {href: url, download: "decisions.json"}).click();
  setTimeout(() => URL.revokeObjectURL(url), 1000);
  say("Exported decisions.json");
}

// How far the review is, and its export.
function reviewBar() {
  const answers = Review.answers();
  if (!answers.length) return null;
  const decided = answers.filter((answer) => answer.decided).length;
  return h("section.review-bar", {"aria-label": "Review"},
    h("span", {}, decided.toLocaleString("en") + " of " + answers.length.toLocaleString("en") +
      " decided"),
    decided < answers.length && h("a", {href: Route.href({...NO_FILTERS, review: "undecided"})},
      "left to decide"),
    decided > 0 && [h("button", {id: "export", type: "button", onclick: downloadDecisions},
      "Export ", h("kbd", {}, "e")),
    h("code", {}, "edgecase bless --from decisions.json --apply"),
    h("button.quiet", {type: "button", onclick: () => {
      if (confirm("Forget all decisions?")) Review.clear();
      showRoute();
    }}, "Forget all")],
    !Review.kept && h("span.alarm", {}, "This browser keeps nothing of a page from disk: export " +
      "before you leave."));
}

// The form of one decision. `decide(word, reason)` is called with a reason, or with "" for none.
// Each form begins with an empty field: no reason is taken over from another decision.
class DecisionForm {
  // `ofCause`: does a decision on all answers of its cause count here?
  constructor(title, what, decided, ofCause, decide) {
    this.what = what;
    this.ofCause = ofCause;
    this.decided = decided;
    this.decide = decide;
    this.word = "";
    this.element = h("form.review", {"aria-label": "Decision: " + title, onsubmit: (event) => {
      event.preventDefault();
      this.submit();
    }});
    this.paint();
  }

  paint() {
    const button = (word, key) => h("button.decide", {
      class: word, type: "button", "aria-pressed": this.decided?.decision === word ? "true" : "false",
      title: REVIEWED[word].verb + " " + this.what + " (" + key + ")",
      onclick: () => this.ask(word),
    }, icon(REVIEWED[word].path), REVIEWED[word].verb, " ", h("kbd", {}, key));
    const {decided} = this;
    this.field = this.word && h("input.reason", {
      type: "text", placeholder: "Reason, then Enter", maxlength: 2000, autocomplete: "off",
      "aria-label": REVIEWED[this.word].verb + " " + this.what + ", because",
      value: decided?.decision === this.word ? decided.reason : undefined,
      onkeydown: (event) => {
        if (event.key !== "Escape") return;
        event.stopPropagation();
        this.cancel();
      },
    });
    replace(this.element, button("accept", "a"), button("reject", "x"),
      this.word ? this.field
        : decided && [h("span.decided", {class: decided.decision, dir: "auto"},
          REVIEWED[decided.decision].label + (this.ofCause && !decided.isOwn ? " with its cause" : "") +
          ": " + decided.reason),
        h("button.quiet", {type: "button", onclick: () => this.decide("", "")}, "Forget")]);
  }

  // Asks for the reason of a decision.
  ask(word) {
    this.word = word;
    this.paint();
    this.field.focus();
  }

  cancel() {
    this.word = "";
    this.paint();
    this.element.closest("[tabindex]")?.focus();
  }

  submit() {
    const reason = this.field ? this.field.value.trim() : "";
    if (!reason) {
      this.field?.focus();
      return say("Give a reason first.");
    }
    const {word} = this;
    this.word = "";
    this.decide(word, reason);
    say(REVIEWED[word].label);
  }
}

// The form for one answer of a case.
function answerForm(one, result, changed) {
  if (!isSurprise(result)) return null;
  if (!isDecidable(result))
    return new Notice("Asked again, the renderer answered otherwise: nothing to decide on.");
  return new DecisionForm(one.id, "this answer", Review.of(one, result), true, (word, reason) => {
    Review.decide(one, result, word, reason);
    changed();
  });
}

// The form for all answers of a group.
function groupForm(group, changed) {
  if (!group.answers.some(({result}) => isDecidable(result)))
    return group.isRed ? new Notice("Such answers cannot be decided on.") : null;
  const count = group.answers.length;
  return new DecisionForm(groupTitle(group), count === 1 ? "this answer"
    : "all " + count.toLocaleString("en") + " answers", Review.causes.get(group.key), false, (word, reason) => {
      Review.decideAll(group, word, reason);
      changed(word);
    });
}

// A sentence in the place of a form.
class Notice {
  constructor(text) {
    this.element = h("p.faint", {}, text);
  }

  ask() {}
}
