// SPDX-License-Identifier: MIT
//
// What a comparison finds: disagreements, aggregated values, and the verdict over a case.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "model/cause.h"
#include "model/figure.h"

namespace edgecase {

enum class DisagreementKind {
  missing,    // exact draws the sample, the renderer does not
  extra,      // the renderer draws it, exact does not
  duplicate,  // the renderer draws it more often than exact does
  value,      // both draw it, with different values
};

const char* name_of(DisagreementKind);

// Does the specification allow a difference? By the ruling that decides.
enum class Legality {
  legal,      // whatever explains it
  contested,  // the letter of the text forbids it, and there is good reason to read it otherwise
  illegal,
};

const char* name_of(Legality);
bool parse_name(const std::string& name, Legality& value);
// For people: "allowed", "contested", "not allowed".
const char* describe(Legality);

// What the letter of the text makes of a difference; whether that is contested is the ruling's to
// say (rules/all_rules.h).
constexpr Legality by_letter(bool is_allowed) {
  return is_allowed ? Legality::legal : Legality::illegal;
}

// One fragment or sample on which a renderer differs from exact.
struct Disagreement {
  int x = 0;  // pixel column
  int y = 0;  // pixel row, y up
  // Of a multisampled target, the sample's index, or -1: an invocation, or the pixel as a whole. Of
  // a supersampled scene, the pass's index, or -1: the image of all passes. Of others 0.
  int sample = 0;
  int primitive = -1;  // index in drawing order; -1: the pixel as a whole
  DisagreementKind kind = DisagreementKind::missing;
  RuleId rule = RuleId::none;
  // compare() decides by the letter of the text; judge() tells what is contested from what is
  // illegal.
  Legality legality = Legality::illegal;
  Cause cause;                 // none: no alternatives are found that draw so
  std::string situation;       // where it lies on the primitive, in words (situation_of)
  int ruling = 0;              // number of the ruling by which `legality` was decided
  bool policy_agrees = false;  // the policy draws it too: held against the specification alone
  // Set where the whole answer is told to be upside down (rule window.origin): what is told of this
  // sample without that.
  struct Upright {
    RuleId rule = RuleId::none;
    int ruling = 0;
    Legality legality = Legality::illegal;
    Cause cause;
  };
  std::optional<Upright> upright;
  std::vector<double> exact;  // hits (missing, extra, duplicate) or components (value)
  std::vector<double> rendered;
  std::string explanation;  // a sentence with numbers
  Figure figure;            // what to draw over this pixel, beside the case's figure
};

// All values of one attribute of one case: how many differ inside what the specification permits.
// An error in units of the last place says little near zero, one relative to the attribute's range
// little of tiny numbers: both are told.
struct ValueAggregate {
  struct Place {
    int x = 0;
    int y = 0;
    int primitive = -1;
  };
  std::string attribute;  // "color", "depth", "dFdxFine", "gl_FragCoord.w", "pixel", "depth buffer"
  RuleId rule = RuleId::none;
  int ruling = 0;
  Cause cause;  // the open alternatives that yield all of `differing`; none: none are known to
  std::uint64_t compared = 0;    // fragments compared
  std::uint64_t components = 0;  // numbers compared
  std::vector<Place> differing;  // inside the permitted interval, not the correctly rounded value
  Place worst;                   // the place with the largest error in ULP of all that differ
  int worst_component = 0;
  double worst_exact = 0;
  double worst_rendered = 0;
  // Error in units of the last place of the value's format, of the larger of the two.
  double worst_ulp = 0;
  double mean_ulp = 0;  // over all components compared, those without error included
  // Largest error as a share of the attribute's range over the vertices of its primitive; 0 where
  // the attribute has no range.
  double worst_relative = 0;
  std::map<int, std::uint64_t> ulp_histogram;  // floor(log2(error in ULP)) -> components
};

inline bool is_legal(const Disagreement& disagreement) {
  return disagreement.legality == Legality::legal;
}

// Ordered from best to worst; a case gets the worst that applies.
enum class Verdict { agree, convention, permitted, contested, violation, not_run };

const char* name_of(Verdict);
bool parse_name(const std::string& name, Verdict& value);

}  // namespace edgecase
