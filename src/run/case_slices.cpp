// SPDX-License-Identifier: MIT
#include "run/case_slices.h"

#include <algorithm>

namespace edgecase {
namespace {

// What a case weighs beside its samples.
constexpr std::size_t kCaseWeight = 256;

std::size_t weight_of(const Scene& scene) {
  const Target& target = scene.target;
  return kCaseWeight + static_cast<std::size_t>(target.width) *
                           static_cast<std::size_t>(target.height) *
                           static_cast<std::size_t>(target.samples) *
                           std::max<std::size_t>(1, scene.supersampling.size());
}

}  // namespace

std::vector<CaseSlice> cut_cases(const std::vector<Case>& cases, SliceLimits most) {
  std::vector<CaseSlice> slices;
  std::size_t weight = 0;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const std::size_t more = weight_of(cases[i].scene);
    const bool is_full =
        weight + more > most.weight || (!slices.empty() && i - slices.back().begin == most.cases);
    if (slices.empty() || is_full) {
      slices.push_back({i, i});
      weight = 0;
    }
    weight += more;
    slices.back().end = i + 1;
  }
  return slices;
}

}  // namespace edgecase
