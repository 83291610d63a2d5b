// SPDX-License-Identifier: MIT
//
// The result of a comparison: disagreements, aggregated values, and a case's verdict.
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

// Whether the specification allows a difference, by the ruling that decides.
enum class Legality {
  legal,      // whatever explains it
  contested,  // the wording forbids it, and there is good reason to read it otherwise
  illegal,
};

const char* name_of(Legality);
bool parse_name(const std::string& name, Legality& value);
// For people: "allowed", "contested", "not allowed".
const char* describe(Legality);

// Legality by the wording of the specification; the ruling decides whether that is contested
// (rules/all_rules.h).
constexpr Legality by_letter(bool is_allowed) {
  return is_allowed ? Legality::legal : Legality::illegal;
}

// One fragment or sample on which a renderer differs from exact.
struct Disagreement {
  int x = 0;  // pixel column
  int y = 0;  // pixel row, y up
  // In a multisampled target, the sample's index, or -1 for an invocation or the whole pixel. In a
  // supersampled scene, the pass's index, or -1 for the image of all passes. Otherwise 0.
  int sample = 0;
  int primitive = -1;  // index in drawing order; -1: the pixel as a whole
  DisagreementKind kind = DisagreementKind::missing;
  RuleId rule = RuleId::none;
  // compare() decides by the wording; judge() separates contested from illegal.
  Legality legality = Legality::illegal;
  Cause cause;                 // empty: no alternatives are found that draw this
  std::string situation;       // where it lies on the primitive, as text (situation_of)
  int ruling = 0;              // number of the ruling that decided `legality`
  bool policy_agrees = false;  // the policy draws it too: judged against the specification alone
  // Set if the whole answer is reported as upside down (rule window.origin): the report on this
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
  Figure figure;            // drawn over this pixel, in addition to the case's figure
};

// All values of one attribute of one case, and how many differ within the specification's limits.
// Near zero an error in units of the last place means little, as does one relative to the
// attribute's range for tiny numbers, so both are reported.
struct ValueAggregate {
  struct Place {
    int x = 0;
    int y = 0;
    int primitive = -1;
  };
  std::string attribute;  // "color", "depth", "dFdxFine", "gl_FragCoord.w", "pixel", "depth buffer"
  RuleId rule = RuleId::none;
  int ruling = 0;
  Cause cause;  // the open alternatives that yield all of `differing`; empty if none are known
  std::uint64_t compared = 0;    // fragments compared
  std::uint64_t components = 0;  // numbers compared
  std::vector<Place> differing;  // permitted, but not correctly rounded
  Place worst;                   // the place with the largest error in ULP of all that differ
  int worst_component = 0;
  double worst_exact = 0;
  double worst_rendered = 0;
  // Error in units of the last place of the value's format, for the larger of the two.
  double worst_ulp = 0;
  double mean_ulp = 0;  // over all components compared, including those without error
  // Largest error relative to the attribute's range over the vertices of its primitive; 0 if it has
  // no range.
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
