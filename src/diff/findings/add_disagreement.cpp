// SPDX-License-Identifier: MIT
#include "diff/findings/add_disagreement.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "diff/findings/patience.h"

namespace edgecase {
namespace {

bool is_of_kind(const DisagreementClass& a, const DisagreementClass& b) {
  return a.kind == b.kind && a.rule == b.rule && a.ruling == b.ruling && a.legality == b.legality;
}

bool lacks_examples(const Result& result, const DisagreementClass& of) {
  return std::ranges::count_if(result.disagreements, [&](const Disagreement& d) {
           return is_of_kind(d, of);
         }) < static_cast<std::ptrdiff_t>(kExamplesOfKind);
}

// The counted ones of the class; null if there are none yet. Neighbours are mostly of one class, so
// the latest comes first.
CountedDisagreements* find_counted(Result& result, const DisagreementClass& of) {
  const auto found = std::find_if(result.counted.rbegin(), result.counted.rend(),
                                  [&](const CountedDisagreements& counted) {
                                    return static_cast<const DisagreementClass&>(counted) == of;
                                  });
  return found != result.counted.rend() ? &*found : nullptr;
}

}  // namespace

void append_pixel(std::vector<PixelRun>& runs, PixelPosition pixel) {
  if (!runs.empty() && runs.back().y == pixel.y && runs.back().end == pixel.x)
    ++runs.back().end;
  else
    runs.push_back({pixel.y, pixel.x, pixel.x + 1});
}

Disagreement* add_disagreement(Result& result, PixelPosition pixel, const DisagreementClass& of) {
  Patience::check();
  if (result.disagreements.size() >= kMostInFull) {
    CountedDisagreements* counted = find_counted(result, of);
    if (counted == nullptr && !lacks_examples(result, of)) {
      counted = &result.counted.emplace_back();
      static_cast<DisagreementClass&>(*counted) = of;
    }
    if (counted != nullptr) {
      append_pixel(counted->runs, pixel);
      return nullptr;
    }
  }
  Disagreement& d = result.disagreements.emplace_back();
  static_cast<DisagreementClass&>(d) = of;
  d.x = pixel.x;
  d.y = pixel.y;
  return &d;
}

void add_disagreement(Result& result, Disagreement disagreement) {
  Disagreement* const added =
      add_disagreement(result, {disagreement.x, disagreement.y}, disagreement);
  if (added != nullptr) *added = std::move(disagreement);
}

void add_counted(Result& result, CountedDisagreements counted) {
  CountedDisagreements* const known = find_counted(result, counted);
  if (known == nullptr)
    result.counted.push_back(std::move(counted));
  else
    known->runs.insert(known->runs.end(), counted.runs.begin(), counted.runs.end());
}

}  // namespace edgecase
