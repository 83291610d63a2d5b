// SPDX-License-Identifier: MIT
#include "model/fragment_operations.h"

namespace edgecase {
bool holds(CompareFunction function, bool less, bool equal) {
  switch (function) {
    case CompareFunction::never:
      return false;
    case CompareFunction::less:
      return less;
    case CompareFunction::equal:
      return equal;
    case CompareFunction::lequal:
      return less || equal;
    case CompareFunction::greater:
      return !less && !equal;
    case CompareFunction::notequal:
      return !equal;
    case CompareFunction::gequal:
      return !less;
    case CompareFunction::always:
      return true;
  }
  return true;
}

}  // namespace edgecase
