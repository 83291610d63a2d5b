// SPDX-License-Identifier: MIT
//
// The result of a comparison: disagreements, aggregated values, and a case's verdict.
#pragma once

#include <algorithm>
#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "model/figure.h"
#include "model/names.h"
#include "model/rule_id.h"

namespace edgecase {

// Causes: the alternatives of rules that would have drawn what a renderer drew. The catalogue has
// their names; rules/all_rules.h has the text of a cause.

struct AlternativeId {
  RuleId rule = RuleId::none;
  // Index among the rule's alternatives; 0 if it has none and the rule itself is the cause.
  std::uint8_t index = 0;
  friend auto operator<=>(const AlternativeId&, const AlternativeId&) = default;
};

// Alternatives of different rules that apply together. Without any, no cause is known.
struct Cause {
  std::vector<AlternativeId> parts;

  Cause() = default;
  Cause(AlternativeId part) : parts{part} {}
  explicit Cause(std::vector<AlternativeId> all) : parts(std::move(all)) {}

  bool empty() const { return parts.empty(); }
  std::size_t size() const { return parts.size(); }
  // The rule of the first alternative, or none.
  RuleId rule() const { return parts.empty() ? RuleId::none : parts.front().rule; }
  friend auto operator<=>(const Cause&, const Cause&) = default;
};

// Appends the alternatives of `more`.
inline Cause operator+(Cause cause, const Cause& more) {
  cause.parts.insert(cause.parts.end(), more.parts.begin(), more.parts.end());
  return cause;
}

// A set of alternatives of any rules.
class AlternativeSet {
 public:
  static constexpr std::size_t kMostOfARule = 32;

  static AlternativeSet all() {
    AlternativeSet set;
    set.words_.fill(~std::uint32_t{0});
    return set;
  }

  void add(AlternativeId id) { words_[word_of(id)] |= bit_of(id); }
  bool contains(AlternativeId id) const { return (words_[word_of(id)] & bit_of(id)) != 0; }
  // Calls `visit` with each alternative, in order.
  template <class Visit>
  void for_each(const Visit& visit) const {
    for (const RuleId rule : values_of<RuleId>())
      for (std::uint8_t index = 0; index < kMostOfARule; ++index)
        if (contains({rule, index})) visit(AlternativeId{rule, index});
  }
  friend bool operator==(const AlternativeSet&, const AlternativeSet&) = default;

 private:
  static std::size_t word_of(AlternativeId id) { return static_cast<std::size_t>(id.rule); }
  static std::uint32_t bit_of(AlternativeId id) { return std::uint32_t{1} << id.index; }

  std::array<std::uint32_t, values_of<RuleId>().size()> words_{};
};

enum class DisagreementKind {
  missing,    // exact draws the sample, the renderer does not
  extra,      // the renderer draws it, exact does not
  duplicate,  // the renderer draws it more often than exact does
  value,      // both draw it, with different values
};

template <>
inline constexpr auto kNames<DisagreementKind> =
    std::to_array<Named<DisagreementKind>>({{DisagreementKind::missing, "missing"},
                                            {DisagreementKind::extra, "extra"},
                                            {DisagreementKind::duplicate, "duplicate"},
                                            {DisagreementKind::value, "value"}});

// Whether the specification allows a difference, by the ruling that decides.
enum class Legality {
  legal,      // whatever explains it
  contested,  // the wording forbids it, and there is good reason to read it otherwise
  illegal,
};

template <>
inline constexpr auto kNames<Legality> =
    std::to_array<Named<Legality>>({{Legality::legal, "legal"},
                                    {Legality::contested, "contested"},
                                    {Legality::illegal, "illegal"}});

// For people: "allowed", "contested", "not allowed".
constexpr const char* describe(Legality legality) {
  return legality == Legality::legal     ? "allowed"
         : legality == Legality::illegal ? "not allowed"
                                         : name_of(legality);
}

// Legality by the wording of the specification; the ruling decides whether that is contested
// (rules/all_rules.h).
constexpr Legality by_letter(bool is_allowed) {
  return is_allowed ? Legality::legal : Legality::illegal;
}

// What a disagreement is judged and counted by. Those of one class differ only in where they are.
struct DisagreementClass {
  // In a multisampled target, the sample's index, or -1 for an invocation or the whole pixel. In a
  // supersampled scene, the pass's index, or -1 for the image of all passes. Otherwise 0.
  int sample = 0;
  int primitive = -1;  // index in drawing order; -1: the pixel as a whole
  DisagreementKind kind = DisagreementKind::missing;
  RuleId rule = RuleId::none;
  // compare() decides by the wording; judge() separates contested from illegal.
  Legality legality = Legality::illegal;
  Cause cause;                 // empty: no alternatives are found that draw this
  int ruling = 0;              // number of the ruling that decided `legality`
  bool policy_agrees = false;  // the policy draws it too: judged against the specification alone
  // Set if the whole answer is reported as upside down (rule window.origin): the report on this
  // sample without that.
  struct Upright {
    RuleId rule = RuleId::none;
    int ruling = 0;
    Legality legality = Legality::illegal;
    Cause cause;
    friend bool operator==(const Upright&, const Upright&) = default;
  };
  std::optional<Upright> upright;
  friend bool operator==(const DisagreementClass&, const DisagreementClass&) = default;
};

// One fragment or sample on which a renderer differs from exact, in full.
struct Disagreement : DisagreementClass {
  int x = 0;                  // pixel column
  int y = 0;                  // pixel row, y up
  std::string situation;      // where it lies on the primitive, as text (situation_of)
  std::vector<double> exact;  // hits (missing, extra, duplicate) or components (value)
  std::vector<double> rendered;
  std::string explanation;  // a sentence with numbers
  Figure figure;            // drawn over this pixel, in addition to the case's figure
};

// Neighbouring pixels of a row, y up: columns `begin` to `end` - 1.
struct PixelRun {
  int y = 0;
  int begin = 0;
  int end = 0;
  friend auto operator<=>(const PixelRun&, const PixelRun&) = default;
};

// Disagreements of one class that are judged and counted, without a sentence and a figure each.
struct CountedDisagreements : DisagreementClass {
  std::vector<PixelRun> runs;  // a pixel as often as it disagrees

  std::size_t count() const {
    std::size_t pixels = 0;
    for (const PixelRun& run : runs) pixels += static_cast<std::size_t>(run.end - run.begin);
    return pixels;
  }
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
  // What is permitted there, both ends inclusive; NaN where only its being permitted is known.
  double worst_low = std::numeric_limits<double>::quiet_NaN();
  double worst_high = std::numeric_limits<double>::quiet_NaN();
  // Error in units of the last place of the value's format, for the larger of the two.
  double worst_ulp = 0;
  double mean_ulp = 0;  // over all components compared, including those without error
  // Largest error relative to the attribute's range over the vertices of its primitive; 0 if it has
  // no range.
  double worst_relative = 0;
  std::map<int, std::uint64_t> ulp_histogram;  // floor(log2(error in ULP)) -> components
};

inline bool is_legal(const DisagreementClass& disagreement) {
  return disagreement.legality == Legality::legal;
}

// Of a policy.
enum class Latitude {
  opengl,  // OpenGL's latitude decides which differences are permitted
  none,    // any difference is a violation of this policy
};

template <>
inline constexpr auto kNames<Latitude> =
    std::to_array<Named<Latitude>>({{Latitude::opengl, "opengl"}, {Latitude::none, "none"}});

// Ordered from best to worst; a case gets the worst that applies. Another verdict is a value and a
// name here, a line of verdict_of, and a row in reports/verdict_looks.h.
enum class Verdict { agree, convention, permitted, contested, violation, not_run };

template <>
inline constexpr auto kNames<Verdict> =
    std::to_array<Named<Verdict>>({{Verdict::agree, "agree"},
                                   {Verdict::convention, "convention"},
                                   {Verdict::permitted, "permitted"},
                                   {Verdict::contested, "contested"},
                                   {Verdict::violation, "violation"},
                                   {Verdict::not_run, "not-run"}});

// The verdict on a difference. `is_open`: the specification leaves its cause open (is_open_choice
// in rules/all_rules.h). Never `agree`.
constexpr Verdict verdict_of(Legality legality, bool is_open, Latitude latitude) {
  if (latitude == Latitude::none || legality == Legality::illegal) return Verdict::violation;
  if (legality == Legality::contested) return Verdict::contested;
  return is_open ? Verdict::convention : Verdict::permitted;
}

// Verdicts on what was drawn: all but not-run, from best to worst.
inline constexpr std::span kDrawnVerdicts(kValues<Verdict>.data(), kValues<Verdict>.size() - 1);

// From worst to best. Not-run comes last: nothing is known of it.
inline constexpr auto kWorstFirst = [] {
  auto order = kValues<Verdict>;
  std::reverse(order.begin(), order.end() - 1);
  return order;
}();

}  // namespace edgecase
