// SPDX-License-Identifier: MIT
#include "model/figure.h"

namespace edgecase {

const char* name_of(MarkRole role) {
  switch (role) {
    case MarkRole::primitive:
      return "primitive";
    case MarkRole::vertex:
      return "vertex";
    case MarkRole::snapped_vertex:
      return "snapped-vertex";
    case MarkRole::region:
      return "region";
    case MarkRole::owned:
      return "owned";
    case MarkRole::sample:
      return "sample";
    case MarkRole::edge:
      return "edge";
  }
  return "?";
}

}  // namespace edgecase
