// SPDX-License-Identifier: MIT
#include "diff/findings/most_meet.h"

#include <algorithm>
#include <utility>

namespace edgecase {

std::optional<Interval> where_most_meet(const std::vector<Weighed>& all) {
  struct End {
    double at;
    bool is_last;  // at the same number, ends come after beginnings
    std::size_t weight;
  };
  std::vector<End> ends;
  for (const auto& [interval, weight] : all) {
    ends.push_back({interval.low, false, weight});
    ends.push_back({interval.high, true, weight});
  }
  std::ranges::sort(ends, {}, [](const End& end) { return std::pair(end.at, end.is_last); });
  std::optional<Interval> best;
  std::size_t open = 0;
  std::size_t most = 0;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    open = ends[i].is_last ? open - ends[i].weight : open + ends[i].weight;
    if (open <= most) continue;
    most = open;
    best = {ends[i].at, ends[i + 1].at};
  }
  return best;
}

}  // namespace edgecase
