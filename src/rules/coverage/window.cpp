// SPDX-License-Identifier: MIT
#include "rules/coverage/window.h"

#include <fmt/format.h>

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

Rule row_order_rule(RuleId id) {
  Rule rule;
  rule.id = id;
  const std::string name = name_of(id);
  const std::string kind = name.substr(0, name.find('.'));
  rule.title =
      fmt::format("Ties and rounding of {}s are decided with y up, as in window coordinates",
                  static_cast<char>(kind[0] - 'a' + 'A') + kind.substr(1));
  rule.spec = "14 (rasterization), which does not speak of memory";
  rule.latitude = "any, as long as the rulings on what is drawn hold";
  rule.standard = "bottom-up";
  rule.alternatives = alternatives_of<RowOrder>();
  return rule;
}

Point turned_over(Point point, int height) {
  return {point.x, Fixed::from_integer(height) - point.y};
}

HomogeneousPoint turned_over(const HomogeneousPoint& point, int height) {
  return {point.x, height * point.w - point.y, point.w};
}

PixelBounds turned_over(const PixelBounds& bounds, int height) {
  return {bounds.x_min, height - 1 - bounds.y_max, bounds.x_max, height - 1 - bounds.y_min};
}

Rule fragment_once_rule() {
  return {RuleId::fragment_once,
          "A primitive produces at most one fragment per pixel",
          "14.4 to 14.6",
          "none",
          "",
          {},
          {{7,
            "A primitive that produces two fragments of the same pixel violates the rule that "
            "produced it: point, line and triangle rules describe sets of fragments."}}};
}

}  // namespace edgecase
