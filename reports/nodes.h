// SPDX-License-Identifier: MIT
//
// Functions that make the nodes of this folder's SVG pictures and static pages.
#pragma once

#include <fmt/format.h>

#include <pugixml.hpp>
#include <sstream>
#include <string>

#include "reports/text.h"

namespace edgecase {

// Sets an attribute that the node does not have yet. Numbers are written with the fewest digits
// that represent them exactly.
inline void set(pugi::xml_node node, const char* name, const std::string& value) {
  node.append_attribute(name).set_value(value.c_str());
}

inline void set(pugi::xml_node node, const char* name, double value) {
  set(node, name, fmt::format("{}", value));
}

// The root of an SVG picture of this size.
inline pugi::xml_node add_svg(pugi::xml_node parent, double width, double height) {
  pugi::xml_node svg = parent.append_child("svg");
  set(svg, "xmlns", std::string("http://www.w3.org/2000/svg"));
  set(svg, "width", width);
  set(svg, "height", height);
  set(svg, "viewBox", fmt::format("0 0 {} {}", width, height));
  return svg;
}

// A rectangle of CSS class `kind`; x, y is its upper left corner, in SVG units, y down.
inline pugi::xml_node add_rectangle(pugi::xml_node parent, const char* kind, double x, double y,
                                    double width, double height) {
  pugi::xml_node node = parent.append_child("rect");
  set(node, "class", std::string(kind));
  set(node, "x", x);
  set(node, "y", y);
  set(node, "width", width);
  set(node, "height", height);
  return node;
}

// Text of CSS class `kind` whose base line starts at x, y.
inline pugi::xml_node add_text(pugi::xml_node parent, const char* kind, double x, double y,
                               const std::string& words) {
  pugi::xml_node node = parent.append_child("text");
  set(node, "class", std::string(kind));
  set(node, "x", x);
  set(node, "y", y);
  node.text().set(words.c_str());
  return node;
}

// HTML: an element of a class or, if `kind` is null, of none; with a text; and a text alone.
inline pugi::xml_node add(pugi::xml_node parent, const char* name, const char* kind = nullptr) {
  pugi::xml_node node = parent.append_child(name);
  if (kind != nullptr) set(node, "class", std::string(kind));
  return node;
}

inline void append_text(pugi::xml_node node, const std::string& text) {
  node.append_child(pugi::node_pcdata).set_value(xml_text(text).c_str());
}

inline pugi::xml_node add_text(pugi::xml_node parent, const char* name, const char* kind,
                               const std::string& text) {
  pugi::xml_node node = add(parent, name, kind);
  append_text(node, text);
  return node;
}

inline pugi::xml_node add_link(pugi::xml_node parent, const std::string& target,
                               const std::string& text) {
  pugi::xml_node link = add_text(parent, "a", nullptr, text);
  set(link, "href", xml_text(target));
  return link;
}

// The nodes of a document as HTML.
inline std::string html_of(const pugi::xml_document& document) {
  std::ostringstream text;
  document.save(
      text, "",
      pugi::format_raw | pugi::format_no_declaration | pugi::format_no_empty_element_tags);
  return text.str();
}

// A text as the content of an element.
inline std::string html_of(const std::string& text) {
  pugi::xml_document document;
  append_text(document, text);
  return html_of(document);
}

}  // namespace edgecase
