// SPDX-License-Identifier: MIT
//
// Code rounding: how a number of 0 to 1 becomes an unsigned integer of some bits, of a colour or of
// a depth buffer.
//
// The specification asks for one of the two integers next to the number times 2^bits - 1 (GL 4.6
// core, 2.3.5.2; rulings 10 and 18), so that this is no rule with alternatives of its own.
#pragma once

#include <string>
#include <utility>

#include "profile/output/output_profile.h"
#include "profile/profile.h"
#include "profile/tally.h"

namespace edgecase {

// Numbers beyond 0 to 1 are clamped first. With M = 2^bits - 1:
enum class CodeRounding {
  nearest,             // to the exact product by M, a tie to the even code
  nearest_of_float,    // the same of the product rounded to float32
  half_up_of_float,    // that product and 1/2, added in float32, truncated
  truncated,           // the exact product by M
  truncated_of_float,  // that product rounded to float32
  up,                  // the exact product by M, to the next code
  power_nearest,       // the product by 2^bits, at most M
  power_truncated,     // the same
};

// `value`: a float32 number. At most 24 bits.
long code_by(CodeRounding rounding, double value, int bits);

// Finds the one that yields all codes.
class CodeTally {
 public:
  CodeTally(std::string id, int bits);

  void add(double value, long code);
  Trait trait(std::string id) const { return tally_.fitting(std::move(id)); }
  const CodeEvidence& evidence() const { return evidence_; }

 private:
  Tally tally_;
  CodeEvidence evidence_;
};

}  // namespace edgecase
