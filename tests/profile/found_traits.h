// SPDX-License-Identifier: MIT
//
// Measures one subject of a profile, and says what tests expect of the traits that are found.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "profile/evidence/findings.h"

namespace edgecase {

// `findings`: what was found before. As many scenes must be reported as the subject says.
inline SurfaceFindings measured(const Subject& subject, Renderer& renderer,
                                const Question& question, SurfaceFindings findings = {}) {
  std::size_t reported = 0;
  measure_subject(
      subject, renderer, question, [&](std::size_t more) { reported += more; }, nullptr, findings);
  EXPECT_EQ(reported, subject.scene_count(question.scenes_per_kind));
  return findings;
}

// The trait of an id, "offset.unit:depth16"; a failure where there is none.
inline const Trait& trait_of(const SurfaceFindings& findings, const std::string& id) {
  for (const Trait& trait : findings.traits)
    if (text_of(trait.id) == id) return trait;
  ADD_FAILURE() << "no trait " << id;
  static const Trait none;
  return none;
}

// Found, agreed with by all evidence, and by more of it than the runner-up.
inline void expect_found(const SurfaceFindings& findings, const std::string& id,
                         const std::string& alternative) {
  const Trait& trait = trait_of(findings, id);
  EXPECT_EQ(trait.alternative, alternative) << id;
  EXPECT_GT(trait.rate.of, 50u) << id;
  EXPECT_EQ(trait.rate.agreeing, trait.rate.of) << id << " " << trait.remark;
  EXPECT_LT(trait.runner_up_rate.agreeing, trait.rate.agreeing) << id << " " << trait.runner_up;
  EXPECT_EQ(findings.choices.at(id), alternative) << id;
}

}  // namespace edgecase
