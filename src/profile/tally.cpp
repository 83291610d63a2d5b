// SPDX-License-Identifier: MIT
#include "profile/tally.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace edgecase {

void Tally::add(const std::vector<bool>& yields) {
  const auto count = std::count(yields.begin(), yields.end(), true);
  ++all_;
  if (count == 0) ++none_;
  if (count == 0 || count == static_cast<std::ptrdiff_t>(yields.size())) return;
  ++of_;
  for (std::size_t i = 0; i < yields.size(); ++i)
    if (yields[i]) ++agreeing_[i];
}

std::size_t Tally::best() const {
  const auto most = std::max_element(agreeing_.begin(), agreeing_.end());
  if (agreeing_[standard_] == *most) return standard_;
  return static_cast<std::size_t>(most - agreeing_.begin());
}

Trait Tally::trait(std::string id, None none) const {
  const std::size_t first = best();
  const std::size_t of = of_ + (none == None::counted ? none_ : 0);
  Trait trait{std::move(id), names_[first], {agreeing_[first], of}, "", {}, ""};
  if (none_ > 0) trait.remark = fmt::format("nothing catalogued yields {} of {}", none_, all_);
  if (of == 0) {
    if (none_ == 0) trait.remark = "nothing that is told tells the alternatives apart";
    return trait;
  }
  std::size_t second = first == 0 ? 1 : 0;
  for (std::size_t i = 0; i < names_.size(); ++i)
    if (i != first && agreeing_[i] > agreeing_[second]) second = i;
  trait.runner_up = names_[second];
  trait.runner_up_rate = {agreeing_[second], of};
  return trait;
}

Trait Tally::fitting(std::string id) const {
  Trait found = trait(std::move(id), None::counted);
  const auto [agreeing, of] = found.rate;
  if (agreeing == of) return found;
  found.runner_up = found.alternative;
  found.runner_up_rate = found.rate;
  found.alternative = kNoneFits;
  found.rate = {of - agreeing, of};
  return found;
}

}  // namespace edgecase
