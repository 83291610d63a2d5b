// SPDX-License-Identifier: MIT
//
// One sample of the target, what a renderer stored there, and what may have been stored: the
// questions that matching, naming and explaining ask.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "diff/output/fate.h"

namespace edgecase {

class FateQuestion {
 public:
  // All must outlive it. `fragments`: all of the pixel, in drawing order.
  FateQuestion(const ValueContext& context, const Arrivals& arrivals,
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
  std::vector<Arrival> arrivals(const RuleChoices& choice) const {
    return arrivals_.at(fragments_, sample, choice);
  }
  // What exact stores by the renderer's own fragments.
  FateState exact(const RuleChoices& choice) const;
  std::vector<FateState> states(const RuleChoices& choice, FateFreedom freedom) const;
  // Is there a state, of those that these outcomes lead to, that agrees?
  bool agrees(const RuleChoices& choice, FateFreedom freedom, FatePlanes planes = {}) const;
  // Does a choice that is no longer the specification's yield what is stored? What it leaves open
  // stays open.
  bool yields(const RuleChoices& choice) const;

 private:
  const ValueContext& context_;
  const Arrivals& arrivals_;
  std::span<const Fragment> fragments_;
};

// What of the specification's latitude accounts for a sample, the least that does.
enum class FateReason {
  conversion,  // of colours and depths, and the precision of blending
  depth_test,  // a comparison of depths that may go either way
  facing,
  alpha,
  none,  // nothing does
};
FateReason reason_for(const FateQuestion& question);

// The rule that is broken where nothing accounts for a sample and no alternative is known to.
RuleId broken_rule(const FateQuestion& question);

// The contested ruling that a sample breaks where it would agree but for a depth that is one code
// off, or colours that blending led up to five codes too far; 0: it breaks another.
int contested_ruling(const FateQuestion& question);

// Sentences with numbers: what met there, what should be stored, what is.
std::string explain_fate(const FateQuestion& question, const RuleChoices& chosen);

}  // namespace edgecase
