// SPDX-License-Identifier: MIT
// Building elements. Every string becomes a text node: nothing in a report is ever read as markup.

// Control characters and those that reorder or hide text, shown by their numbers.
const UNSEEN =
  /[\u0000-\u0008\u000b-\u001f\u007f-\u009f\u061c\u200b-\u200f\u2028-\u202e\u2060-\u2069\ufeff]/g;

function visible(text) {
  return String(text).replace(UNSEEN, (c) =>
    "\u27e8U+" + c.charCodeAt(0).toString(16).toUpperCase().padStart(4, "0") + "\u27e9");
}

function append(parent, children) {
  for (const child of children.flat(Infinity)) {
    if (child === null || child === undefined || child === false) continue;
    parent.append(child instanceof Node ? child : document.createTextNode(visible(child)));
  }
  return parent;
}

// h("a.chip", {href: "#", onclick: f, "aria-label": "x"}, children...); `on...` are listeners.
function h(name, props, ...children) {
  const [tag, ...classes] = name.split(".");
  const element = document.createElement(tag);
  if (classes.length) element.className = classes.join(" ");
  for (const [key, value] of Object.entries(props || {})) {
    if (value === undefined || value === null || value === false) continue;
    if (key.startsWith("on")) element.addEventListener(key.slice(2), value);
    else if (key === "class") element.className += " " + value;
    else element.setAttribute(key, value === true ? "" : visible(value));
  }
  return append(element, children);
}

// A 16 x 16 line drawing; `path` always comes from words.js.
function icon(path, className) {
  const space = "http://www.w3.org/2000/svg";
  const svg = document.createElementNS(space, "svg");
  svg.setAttribute("viewBox", "0 0 16 16");
  svg.setAttribute("aria-hidden", "true");
  svg.setAttribute("class", "icon " + (className || ""));
  const line = document.createElementNS(space, "path");
  line.setAttribute("d", path);
  svg.append(line);
  return svg;
}

function replace(parent, ...children) {
  parent.replaceChildren();
  return append(parent, children);
}

// A box for content wider than the page, which the keyboard can scroll.
const scrolled = (label, ...children) =>
  h("div.scroll", {tabindex: "0", role: "region", "aria-label": label}, children);

/** @returns {any} of whatever kind it is */
const byId = (id) => document.getElementById(id);

// Announces a text to screen readers without moving the focus.
function say(text) {
  byId("said").textContent = visible(text);
}

const plural = (count, one, many) => count.toLocaleString("en") + " " + (count === 1 ? one : many);
