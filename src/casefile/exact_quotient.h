// SPDX-License-Identifier: MIT
//
// Sums and means of float32 numbers, rounded once.
#pragma once

#include <span>

namespace edgecase {

// The float32 number nearest to the sum of `terms` divided by `divisor`, a tie to the even one;
// never -0. Correct for up to 8 terms, each 0 or of magnitude 2^-149 to 2^148, whatever cancels
// among them, and for whole divisors of 1 to 2^20.
float nearest_quotient(std::span<const double> terms, double divisor);

}  // namespace edgecase
