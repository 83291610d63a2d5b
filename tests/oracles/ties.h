// SPDX-License-Identifier: MIT
//
// What the name of a tie rule says, read word by word: `left-bottom` owns left edges first, then
// bottom ones, so it moves a sample right by e and up by e^2; `open` and `closed` move nothing.
#pragma once

#include <string_view>

#include "tests/oracles/oracles.h"

namespace edgecase::oracle {

struct Ties {
  Move move{0, 0};
  bool closed = false;

  // Of a place that lies inside (positive), outside (negative) or on the boundary.
  bool accept(int where) const { return where > 0 || (where == 0 && closed); }
};

inline Ties ties_named(std::string_view name) {
  Ties ties;
  if (name == "open" || name == "closed") {
    ties.closed = name == "closed";
    return ties;
  }
  const std::size_t dash = name.find('-');
  const auto read = [&](std::string_view word, int size) {
    if (word == "left") ties.move.x = size;
    if (word == "right") ties.move.x = -size;
    if (word == "bottom") ties.move.y = size;
    if (word == "top") ties.move.y = -size;
  };
  read(name.substr(0, dash), 1);
  read(name.substr(dash + 1), 2);
  return ties;
}

}  // namespace edgecase::oracle
