// SPDX-License-Identifier: MIT
//
// The few ways in which the SVG pictures of this folder make nodes.
#pragma once

#include <fmt/format.h>

#include <pugixml.hpp>
#include <string>

namespace edgecase {

// Sets an attribute that the node does not have yet. Numbers are written with the fewest digits
// that give them back, so that the same picture gives the same bytes.
inline void set(pugi::xml_node node, const char* name, const std::string& value) {
  node.append_attribute(name).set_value(value.c_str());
}

inline void set(pugi::xml_node node, const char* name, double value) {
  set(node, name, fmt::format("{}", value));
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

}  // namespace edgecase
