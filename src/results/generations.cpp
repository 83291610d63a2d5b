// SPDX-License-Identifier: MIT
#include "results/generations.h"

#include <algorithm>

namespace edgecase {
namespace {

void raise(CasesOn& cases, const std::string& release, std::size_t count) {
  std::size_t& most = cases[release];
  most = std::max(most, count);
}

// By product, then from older to newer releases.
bool is_older(const Release& a, const Release& b) {
  if (a.product != b.product) return a.product < b.product;
  if (a.numbers != b.numbers) return is_before(a.numbers, b.numbers);
  return a.is_es < b.is_es;
}

void add_release(DriverGenerations& driver, const Release& release) {
  const auto place =
      std::lower_bound(driver.releases.begin(), driver.releases.end(), release, is_older);
  if (place == driver.releases.end() || *place != release) driver.releases.insert(place, release);
}

}  // namespace

std::optional<std::string> add_generation(Generations& generations, const Results& results) {
  if (!is_whole(results))
    return "they are not of the whole suite; a fault that they do not show need not be gone";
  for (std::size_t r = 0; r < results.renderers.size(); ++r) {
    const RendererInfo& info = results.renderers[r];
    DriverGenerations& driver = generations[driver_of(info)];
    const Release release = release_of(info);
    const std::string name = text_of(release);
    add_release(driver, release);
    raise(driver.unexpected, name, count_unexpected(results, r));
    for (const FaultSeen& seen : results.faults) {
      if (seen.renderer != info.name || seen.cases == 0) continue;
      raise(driver.faults[seen.id], name, seen.cases);
      if (driver.releases.back() == release) driver.reasons[seen.id] = seen.reason;
      driver.reasons.emplace(seen.id, seen.reason);
    }
  }
  return std::nullopt;
}

}  // namespace edgecase
