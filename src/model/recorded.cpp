// SPDX-License-Identifier: MIT
#include "model/recorded.h"

namespace edgecase {

const std::string& known_as(const RendererInfo& info) {
  if (!info.name.starts_with(kRecordingPrefix)) return info.name;
  const auto recorded = info.traits.find(kRecordedTrait);
  return recorded == info.traits.end() ? info.name : recorded->second;
}

}  // namespace edgecase
