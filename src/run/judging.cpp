// SPDX-License-Identifier: MIT
#include "run/judging.h"

#include <map>
#include <vector>

#include "diff/judge.h"

namespace edgecase {
namespace {

constexpr const char* kReading = "lines read with snap, ";

}  // namespace

void judge_all(Results& results) {
  for (std::size_t r = 0; r < results.renderers.size(); ++r) {
    std::map<std::string, std::string>& traits = results.renderers[r].traits;
    std::erase_if(traits, [](const auto& trait) { return is_of_judging(trait.first); });
    std::map<std::string, std::vector<Result*>> by_surface;
    for (CaseResults& one : results.cases) by_surface[one.surface].push_back(&one.results[r]);
    for (const auto& [surface, group] : by_surface)
      traits[kReading + surface] = judge(group, results.latitude);
  }
}

bool is_of_judging(const std::string& trait) {
  return trait.starts_with(kReading);
}

}  // namespace edgecase
