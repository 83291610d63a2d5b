// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>

#include "results/results.h"

namespace edgecase {

// Member by member: of an aggregate in an aggregate, g++ 12 warns that its strings are destroyed
// uninitialised where a later one throws.
inline MissingCase missing_case(std::string renderer, std::string id, Judgement expected,
                                std::string reason) {
  MissingCase result;
  result.renderer = std::move(renderer);
  result.id = std::move(id);
  result.expected = std::move(expected);
  result.reason = std::move(reason);
  return result;
}

}  // namespace edgecase
