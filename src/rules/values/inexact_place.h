// SPDX-License-Identifier: MIT
//
// An inexact place: what interpolate_inexact yields for several attributes of one primitive at one
// sample. What the attributes share is worked out once.
#pragma once

#include <optional>

#include "rules/values/inexact_shares.h"

namespace edgecase {

class InexactPlace {
 public:
  explicit InexactPlace(Point sample) : sample_(sample) {}

  // Attributes have the same vertices and line parameter and, with perspective, the same w.
  Interval value(const Interpolant& f) const;

 private:
  Point sample_;
  // When they are first asked for.
  mutable std::optional<Shares> shares_;
  mutable std::optional<SharesOverW> over_w_;
};

}  // namespace edgecase
