// SPDX-License-Identifier: MIT
#include "model/renderer.h"

namespace edgecase {

const char* name_of(FailureKind kind) {
  switch (kind) {
    case FailureKind::unsupported:
      return "unsupported";
    case FailureKind::crashed:
      return "crashed";
    case FailureKind::timed_out:
      return "timed-out";
    case FailureKind::garbage:
      return "garbage";
    case FailureKind::unavailable:
      return "unavailable";
  }
  return "?";
}

const std::string& known_as(const RendererInfo& info) {
  if (!info.name.starts_with(kRecordingPrefix)) return info.name;
  const auto recorded = info.traits.find(kRecordedTrait);
  return recorded == info.traits.end() ? info.name : recorded->second;
}

}  // namespace edgecase
