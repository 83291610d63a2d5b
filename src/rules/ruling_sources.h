// SPDX-License-Identifier: MIT
//
// What a ruling rests on: the sentence of the specification, and who reads it how.
#pragma once

#include "rules/rule.h"

namespace edgecase {

// Of a number that nothing is known of, an empty one.
RulingSource source_of(int ruling);

}  // namespace edgecase
