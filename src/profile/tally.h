// SPDX-License-Identifier: MIT
//
// Tally: which alternatives of a rule yield what a renderer tells.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "profile/profile.h"

namespace edgecase {

// What is followed where nothing catalogued yields everything.
inline constexpr const char* kNoneFits = "none fits";

// Counts, observation by observation, which of a rule's alternatives yield it. What
// all of them yield says nothing.
class Tally {
 public:
  // `standard`: the alternative that is preferred where several do as well.
  Tally(std::vector<std::string> names, std::size_t standard)
      : names_(std::move(names)), agreeing_(names_.size()), standard_(standard) {}

  void add(const std::vector<bool>& yields);
  std::size_t best() const;
  // The rate is of what some alternatives yield and some do not; what none yields is remarked, or
  // counted too.
  enum class None { remarked, counted };
  Trait trait(std::string id, None none = None::remarked) const;
  // The alternative that yields everything that tells them apart, and nothing is left over; where
  // there is none, "none fits", with the one that comes closest as runner-up.
  Trait fitting(std::string id) const;

 private:
  std::vector<std::string> names_;
  std::vector<std::size_t> agreeing_;
  std::size_t standard_;
  std::size_t of_ = 0;    // what some yield and some do not
  std::size_t none_ = 0;  // what none yields
  std::size_t all_ = 0;
};

}  // namespace edgecase
