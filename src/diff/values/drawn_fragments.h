// SPDX-License-Identifier: MIT
//
// Finds a renderer's fragments among those that exact drew.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "model/rendering.h"

namespace edgecase {

class DrawnFragments {
 public:
  // `exact` must outlive this.
  explicit DrawnFragments(const Rendering& exact) : all_(exact.fragments) {}

  // Exact's fragment of the same pixel, primitive and coverage; null if there is none. Soonest
  // found where fragments are asked in the order of renderings.
  const Fragment* find(const Fragment& fragment) {
    const bool is_behind = next_ > 0 && !precedes(all_[next_ - 1], fragment);
    if (is_behind)
      next_ = static_cast<std::size_t>(
          std::ranges::lower_bound(all_.begin(), all_.begin() + static_cast<std::ptrdiff_t>(next_),
                                   fragment, precedes) -
          all_.begin());
    while (next_ < all_.size() && precedes(all_[next_], fragment)) ++next_;
    return next_ < all_.size() && !precedes(fragment, all_[next_]) ? &all_[next_] : nullptr;
  }

 private:
  const std::vector<Fragment>& all_;
  std::size_t next_ = 0;  // those before it precede the latest one that was asked
};

}  // namespace edgecase
