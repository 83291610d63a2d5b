// SPDX-License-Identifier: MIT
#include "rules/coverage/row_order.h"

#include <fmt/format.h>

namespace edgecase {

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

}  // namespace edgecase
