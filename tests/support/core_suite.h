// SPDX-License-Identifier: MIT
//
// The core of the suite, for tests that ask about all that it tells apart.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include "suite/selection.h"

namespace edgecase {

inline Suite core_suite() {
  const std::filesystem::path cases = std::filesystem::path(EDGECASE_ROOT) / "cases";
  Selection selection;
  selection.paths = {cases};
  selection.only.emplace();
  std::ifstream list(cases / "core.txt");
  for (std::string line; std::getline(list, line);)
    if (!line.empty() && line[0] != '#') selection.only->ids.insert(line);
  return load_suite(selection);
}

}  // namespace edgecase
