// SPDX-License-Identifier: MIT
#include "diff/moved_answer.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace edgecase {
namespace {

auto what_is_there(const Fragment& f) {
  return std::tuple(f.primitive, f.coverage);
}

// By so many pixels. The order of fragments stays when all of them move.
bool is_moved_by(const Rendering& exact, const Rendering& rendered, int dx, int dy) {
  const auto is_seen = [&](int x, int y) {
    return x >= 0 && x < exact.width && y >= 0 && y < exact.height;
  };
  auto own = exact.fragments.begin();
  auto other = rendered.fragments.begin();
  bool some = false;
  for (;;) {
    while (own != exact.fragments.end() && !is_seen(own->x + dx, own->y + dy)) ++own;
    while (other != rendered.fragments.end() && !is_seen(other->x - dx, other->y - dy)) ++other;
    const bool is_end = own == exact.fragments.end();
    if (is_end || other == rendered.fragments.end())
      return some && is_end && other == rendered.fragments.end();
    if (own->x + dx != other->x || own->y + dy != other->y ||
        what_is_there(*own) != what_is_there(*other))
      return false;
    some = true;
    ++own;
    ++other;
  }
}

}  // namespace

bool is_covered_moved(const Rendering& exact, const Rendering& rendered) {
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx)
      if ((dx != 0 || dy != 0) && is_moved_by(exact, rendered, dx, dy)) return true;
  return false;
}

void note_moved(Result& result) {
  result.evidence.push_back({kMovedAnswer, {}, {}, "", -1});
}

bool is_noted_moved(const Result& result) {
  return std::ranges::any_of(result.evidence, [](const Result::Evidence& evidence) {
    return evidence.primitive == kMovedAnswer;
  });
}

}  // namespace edgecase
