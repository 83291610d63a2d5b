// SPDX-License-Identifier: MIT
//
// What tests say of the traits that a measurement found.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "profile/profile.h"

namespace edgecase {

// The trait of a measurement's findings; a failure where there is none.
template <class Findings>
const Trait& trait_of(const Findings& findings, const std::string& id) {
  for (const Trait& trait : findings.traits)
    if (trait.id == id) return trait;
  ADD_FAILURE() << "no trait " << id;
  static const Trait none;
  return none;
}

// Found, agreed with by all that tells, and by nothing as well as by it.
template <class Findings>
void expect_found(const Findings& findings, const std::string& id, const std::string& alternative) {
  const Trait& trait = trait_of(findings, id);
  EXPECT_EQ(trait.alternative, alternative) << id;
  EXPECT_GT(trait.rate.of, 50u) << id;
  EXPECT_EQ(trait.rate.agreeing, trait.rate.of) << id << " " << trait.remark;
  EXPECT_LT(trait.runner_up_rate.agreeing, trait.rate.agreeing) << id << " " << trait.runner_up;
  EXPECT_EQ(findings.choices.at(id), alternative) << id;
}

}  // namespace edgecase
