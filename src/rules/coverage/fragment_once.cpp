// SPDX-License-Identifier: MIT
#include "rules/coverage/fragment_once.h"

namespace edgecase {

Rule fragment_once_rule() {
  return {RuleId::fragment_once,
          "A primitive produces at most one fragment per pixel",
          "14.4 to 14.6",
          "none",
          "",
          {},
          {{7,
            "A primitive that produces two fragments of the same pixel violates the rule that "
            "produced it: point, line and triangle rules describe sets of fragments."}}};
}

}  // namespace edgecase
