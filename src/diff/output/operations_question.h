// SPDX-License-Identifier: MIT
//
// One sample of the target, what a renderer stored there, and what may have been stored: the basis
// for matching, naming and explaining.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "diff/output/operations_replay.h"

namespace edgecase {

class OperationsQuestion {
 public:
  // Everything referred to must outlive it. `fragments`: all of the pixel, in drawing order.
  OperationsQuestion(const ValueContext& context, const Arrivals& arrivals,
                     std::span<const Fragment> fragments, PixelPosition at, int of_sample,
                     StoredSample what)
      : pixel(at),
        sample(of_sample),
        stored(what),
        context_(context),
        arrivals_(arrivals),
        fragments_(fragments) {}

  PixelPosition pixel;
  int sample;
  StoredSample stored;

  const Target& target() const { return context_.scene.target; }
  std::span<const Fragment> fragments() const { return fragments_; }
  // Valid until the next question's.
  const std::vector<Arrival>& arrivals(const RuleChoices& choice,
                                       Tracked tracked = Tracked::permitted) const {
    return arrivals_.at(fragments_, sample, choice, tracked);
  }
  // What exact stores for the renderer's own fragments.
  ExactSample exact(const RuleChoices& choice) const;
  std::vector<PermittedSample> states(const RuleChoices& choice, OperationsFreedom freedom) const;
  // True if one of the states that these outcomes lead to agrees.
  bool agrees(const RuleChoices& choice, OperationsFreedom freedom,
              ComparedPlanes planes = {}) const;
  // True if a choice that is not the specification's yields what is stored. Everything else that
  // the specification leaves open stays open.
  bool yields(const RuleChoices& choice) const;

 private:
  const ValueContext& context_;
  const Arrivals& arrivals_;
  std::span<const Fragment> fragments_;
};

// The least of the specification's latitude that accounts for a sample.
enum class OperationsReason {
  conversion,  // of colours and depths, including the precision of blending
  depth_test,  // a comparison of depths that may go either way
  facing,
  alpha,
  test_of_one,  // a test of one sample for all, without GL_MULTISAMPLE: of whole pixels alone
  none,         // nothing accounts for it
};
OperationsReason reason_for(const OperationsQuestion& question);

// The rule that is broken, if no latitude accounts for a sample and no alternative is known to.
RuleId broken_rule(const OperationsQuestion& question);

// The contested ruling that a sample breaks if only a depth is one code off, or colours that were
// blended are up to five codes off; 0: it breaks another ruling.
int contested_ruling(const OperationsQuestion& question);

// Sentences with numbers: the fragments in order, what should be stored, and what is.
std::string explain_operations(const OperationsQuestion& question, const RuleChoices& chosen);

}  // namespace edgecase
