// SPDX-License-Identifier: MIT
#include "rules/ruling_sources.h"

namespace edgecase {

RulingSource source_of(int ruling) {
  static const std::map<int, RulingSource> known = [] {
    std::map<int, RulingSource> all;
    add_coverage_sources(all);
    add_values_sources(all);
    add_samples_sources(all);
    add_textures_sources(all);
    add_output_sources(all);
    return all;
  }();
  const auto found = known.find(ruling);
  return found == known.end() ? RulingSource{} : found->second;
}

}  // namespace edgecase
