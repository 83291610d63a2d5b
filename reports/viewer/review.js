// SPDX-License-Identifier: MIT The reviewer's decisions on answers: accepted or rejected, with a
// reason. They are kept in the browser for this report, and exported as the file that `edgecase
// bless --from` applies (src/results/decisions.h).

const REVIEW_PLACE = "edgecase-review:" + Data.key;
const REVIEWED = {
  accept: {label: "accepted", path: VERDICTS.agree.path},
  reject: {label: "rejected", path: VERDICTS.violation.path},
};

const Review = {
  decisions: new Map(),  // case and renderer -> a decision as the file has it
  kept: true,            // does the browser keep them?

  key: (id, renderer) => JSON.stringify([id, renderer]),

  of(one, result) {
    return Review.decisions.get(Review.key(one.id, result.renderer));
  },

  read() {
    try {
      const text = localStorage.getItem(REVIEW_PLACE);
      for (const decision of text ? JSON.parse(text) : [])
        Review.decisions.set(Review.key(decision.case, decision.renderer), decision);
    } catch (fault) {
      Review.kept = false;
    }
  },

  keep() {
    try {
      localStorage.setItem(REVIEW_PLACE, JSON.stringify([...Review.decisions.values()]));
    } catch (fault) {
      Review.kept = false;
    }
    forgetFilter();
  },

  // `word`: "accept" or "reject". The case's details are there.
  decide(one, result, word, reason) {
    Review.decisions.set(Review.key(one.id, result.renderer), {
      case: one.id, renderer: result.renderer, verdict: result.verdict,
      fingerprint: result.answer.fingerprint,
      decision: word, reason,
    });
    Review.keep();
  },

  forget(one, result) {
    Review.decisions.delete(Review.key(one.id, result.renderer));
    Review.keep();
  },

  clear() {
    Review.decisions.clear();
    Review.keep();
  },

  // The file of decisions.
  text() {
    const decisions = [...Review.decisions.values()].sort((a, b) =>
      a.renderer < b.renderer ? -1 : a.renderer > b.renderer ? 1 : a.case < b.case ? -1 : 1);
    return JSON.stringify({edgecase_decisions: 2, decisions}, null, 2) + "\n";
  },
};
Review.read();

function downloadDecisions() {
  const url = URL.createObjectURL(new Blob([Review.text()], {type: "application/json"}));
  h("a", {href: url, download: "decisions.json"}).click();
  setTimeout(() => URL.revokeObjectURL(url), 1000);
}

// The section of the first page with the decisions and their export.
function reviewSection() {
  const undecided = Cases.reduce((sum, one) => sum +
    one.results.filter((r) => isSurprise(r) && !Review.of(one, r)).length, 0);
  const count = Review.decisions.size;
  if (!undecided && !count) return null;
  return h("section.review-bar", {"aria-label": "Review"},
    h("b", {}, "Review"),
    undecided > 0 && h("a", {href: Route.href({...NO_FILTERS, review: "undecided"})},
      plural(undecided, "answer", "answers") + " to decide on"),
    count > 0 && h("a", {href: Route.href({...NO_FILTERS, review: "decided"})},
      plural(count, "decision", "decisions")),
    count > 0 && h("button", {onclick: downloadDecisions}, "Export decisions.json"),
    count > 0 && h("code", {}, "edgecase bless --from decisions.json"),
    count > 0 && h("button.quiet", {onclick: () => {
      if (confirm("Forget all decisions?")) Review.clear();
      showRoute();
    }}, "Forget all"),
    !Review.kept && h("span.alarm", {}, "This browser keeps nothing of a page from disk: export " +
      "before you leave."));
}

// The form for one answer: buttons, the reason, and the decision.
function reviewForm(one, result, changed) {
  if (result.again)
    return h("p.faint", {}, "Asked again, the renderer answered otherwise: nothing to decide on.");
  const decision = Review.of(one, result);
  const reason = h("input", {
    id: "reason", type: "text", value: decision?.reason, placeholder: "Reason",
    "aria-label": "Reason of the decision", maxlength: 2000, autocomplete: "off",
  });
  const decide = (word) => {
    if (!reason.value.trim()) {
      reason.focus();
      return say("Give a reason first.");
    }
    Review.decide(one, result, word, reason.value.trim());
    changed();
    say(REVIEWED[word].label);
  };
  const button = (word, label, key) => h("button.decide", {
    class: word, id: word, type: "button", title: label + " this answer (" + key + ")",
    "aria-pressed": decision?.decision === word ? "true" : "false", onclick: () => decide(word),
  }, icon(REVIEWED[word].path), label);
  return h("form.review", {"aria-label": "Review", onsubmit: (event) => {
    event.preventDefault();
    decide(decision?.decision || "accept");
  }},
  button("accept", "Accept", "a"), button("reject", "Reject", "x"), reason,
  decision && h("button.quiet", {type: "button", onclick: () => {
    Review.forget(one, result);
    changed();
  }}, "Forget"));
}
