// SPDX-License-Identifier: MIT
#include "rules/values/framebuffer.h"

#include <algorithm>
#include <cmath>

namespace edgecase {

Unorm8Range unorm8_permitted(Interval value) {
  const double low = std::clamp(value.low, 0.0, 1.0) * 255;
  const double high = std::clamp(value.high, 0.0, 1.0) * 255;
  return {static_cast<int>(std::floor(low)), static_cast<int>(std::ceil(high))};
}

Rule unorm8_rule() {
  return {RuleId::framebuffer_unorm8,
          "A colour is stored as the nearest 8-bit value",
          "2.3.5.2 (conversion from floating-point to normalized fixed-point)",
          "either of the two nearest values; the nearest is preferred",
          "",
          {},
          {{10,
            "Pixels of an 8-bit target: either integer next to 255 times the clamped colour of "
            "the last fragment, as the renderer itself reports it, or of any colour that ruling "
            "9 permits if it reports none. The alpha of a multisampled point smaller than 1 may "
            "first be multiplied by the square of its size (17.2). A pixel without fragments "
            "holds the clear colour, likewise rounded. Dithering is always disabled; that the "
            "choice between two integers then does not depend on the pixel (17.3.8) is not "
            "judged."}}};
}

Rule order_rule() {
  return {RuleId::framebuffer_order,
          "Primitives take effect in the order in which they are drawn",
          "2.1 (execution model)",
          "none",
          "",
          {},
          {{11,
            "Without blending and depth test the last primitive drawn determines a pixel. The "
            "colour of an earlier one there is a violation."}}};
}

}  // namespace edgecase
