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

}  // namespace edgecase
