// SPDX-License-Identifier: MIT
#include "kernels/kernels.h"

#include <hwy/highway.h>

#include <algorithm>
#include <cstdint>

namespace edgecase {
namespace {

constexpr const char* kNone = "none";

// Highway keeps the target for the whole program, as this variable does.
bool are_used = true;

// All compiled targets that this machine has, regardless of earlier choices.
std::vector<std::int64_t> machine_targets() {
  hwy::SetSupportedTargetsForTest(0);
  return hwy::SupportedAndGeneratedTargets();
}

}  // namespace

std::vector<std::string> kernel_names() {
  std::vector<std::string> names;
  const std::int64_t used = hwy::SupportedTargets();
  for (const std::int64_t target : machine_targets()) names.emplace_back(hwy::TargetName(target));
  hwy::SetSupportedTargetsForTest(used);
  names.emplace_back(kNone);
  return names;
}

bool use_kernels(std::string_view name) {
  if (name == kNone) {
    are_used = false;
    return true;
  }
  const std::int64_t used = hwy::SupportedTargets();
  for (const std::int64_t target : machine_targets()) {
    if (name != hwy::TargetName(target)) continue;
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    are_used = true;
    return true;
  }
  hwy::SetSupportedTargetsForTest(used);
  return false;
}

bool kernels_are_used() {
  return are_used;
}

}  // namespace edgecase
