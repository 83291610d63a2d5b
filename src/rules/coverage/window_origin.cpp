// SPDX-License-Identifier: MIT
#include "rules/coverage/window_origin.h"

namespace edgecase {

Rule window_origin_rule() {
  Rule rule;
  rule.id = kWindowOrigin;
  rule.title = "The window's origin is its lower left corner: y points up";
  rule.spec = "13.8.1 (controlling the viewport), 14 (rasterization), 18.2.2 (reading pixels)";
  rule.latitude = "none";
  rule.rulings = {
      {kRulingOnOrigin,
       "An answer is upside down where it disagrees as it stands and nothing of it does with its "
       "rows in the opposite order. Its cause is then window.origin, if more cases of the run are "
       "upside down and break another ruling as they stand than are not. All that disagrees in an "
       "upside-down answer breaks this rule, and no other."}};
  return rule;
}

}  // namespace edgecase
