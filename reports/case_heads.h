// SPDX-License-Identifier: MIT
//
// What the cases of a file share, said once.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "results/results.h"

namespace edgecase {

// The part of an id that all cases of a file share.
std::string_view stem_of(const std::string& id);

// The heads, and the index of each case's.
struct CaseHeads {
  std::vector<std::size_t> of_case;
  std::vector<CaseResults> list;  // the first case of each, as ShelvedCase::head
};

CaseHeads heads_of(const Results& results);

}  // namespace edgecase
