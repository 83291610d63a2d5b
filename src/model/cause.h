// SPDX-License-Identifier: MIT
//
// Causes: the alternatives of rules that would have drawn what a renderer drew. The catalogue has
// their names; rules/all_rules.h has the text of a cause.
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <utility>
#include <vector>

#include "model/rule_id.h"

namespace edgecase {

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

}  // namespace edgecase
