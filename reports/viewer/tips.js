// SPDX-License-Identifier: MIT Rules, rulings and causes: small chips that show their text on
// hover, focus or click.

const Tip = {
  owner: null,
  pinned: false,
  show(owner, content) {
    const tip = replace(byId("tip"), content);
    tip.hidden = false;
    Tip.owner = owner;
    owner.setAttribute("aria-describedby", "tip");
    const box = owner.getBoundingClientRect();
    const below = box.bottom + 6 + tip.offsetHeight < innerHeight;
    tip.style.top = (below ? box.bottom + 6 : Math.max(4, box.top - 6 - tip.offsetHeight)) + "px";
    tip.style.left = Math.max(8, Math.min(box.left, innerWidth - tip.offsetWidth - 8)) + "px";
  },
  hide() {
    if (Tip.owner) Tip.owner.removeAttribute("aria-describedby");
    byId("tip").hidden = true;
    Tip.owner = null;
    Tip.pinned = false;
  },
};

function chip(label, content) {
  if (!content) return h("span.chip", {}, label);
  const button = h("button.chip.told", {type: "button"}, label);
  const show = () => Tip.show(button, content());
  button.addEventListener("pointerenter", show);
  button.addEventListener("focus", show);
  button.addEventListener("pointerleave", () => Tip.pinned || Tip.hide());
  button.addEventListener("blur", Tip.hide);
  button.addEventListener("click", (event) => {
    event.stopPropagation();
    Tip.pinned = !(Tip.pinned && Tip.owner === button);
    if (Tip.pinned) show();
    else Tip.hide();
  });
  return button;
}

function ruleText(rule) {
  return [
    h("strong", {}, rule.title || rule.id), h("div.mono", {}, rule.id),
    rule.spec && h("p", {}, h("b", {}, "Specification "), rule.spec),
    rule.latitude && h("p", {}, h("b", {}, "Left open "), rule.latitude),
  ];
}

function ruleChip(id) {
  const rule = Rules.get(id);
  return chip(id, rule && (() => ruleText(rule)));
}

function rulingChip(number) {
  const ruling = Rulings.get(number);
  return chip("ruling " + number,
    ruling && (() => [h("strong", {}, "Ruling " + number), h("p", {}, ruling.text),
      ...ruling.facts.map(([name, fact]) => h("p", {}, h("b", {}, name + ": "), fact))]));
}

// "line.end=closed + line.snap=4": a chip for each part.
function causeChips(cause) {
  return cause.split(" + ").map((part, i) => {
    const rule = Rules.get(part.split("=")[0]);
    return [i ? " + " : null, chip(part, rule && (() => ruleText(rule)))];
  });
}
