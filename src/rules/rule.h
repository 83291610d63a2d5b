// SPDX-License-Identifier: MIT
//
// Rule: one statement of the OpenGL specification, as an entry of the catalogue.
//
// The predicate that decides stands beside the entry, in the rule's own pair of files. The entry
// describes the rule, its known alternatives, which of them the specification leaves open, and the
// rulings by which a difference is judged.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "exact/fixed.h"
#include "exact/numeral.h"
#include "model/figure.h"
#include "model/names.h"
#include "model/rule_id.h"

namespace edgecase {

struct CoverageTraits;
struct RuleChoices;
struct Scene;

enum class Openness {
  open,      // the specification leaves the choice to the implementation
  mandated,  // the only choice that conforms
  illegal,   // known from faulty implementations; never conforms by itself
};
template <>
inline constexpr auto kNames<Openness> = std::to_array<Named<Openness>>(
    {{Openness::open, "open"}, {Openness::mandated, "mandated"}, {Openness::illegal, "illegal"}});

struct Alternative {
  std::string name;
  Openness openness = Openness::open;
  std::string meaning;  // one sentence
};

// Most rules have their alternatives in one table beside their enumeration (model/names.h): the
// name that policies use, whether it conforms, and what it means.
template <class Enum>
struct TabledAlternative {
  Enum value;
  const char* name;
  Openness openness;
  const char* meaning;
};

template <HasNames Enum>
std::vector<Alternative> alternatives_of() {
  std::vector<Alternative> alternatives;
  for (const auto& row : kNames<Enum>)
    alternatives.push_back({row.name, row.openness, row.meaning});
  return alternatives;
}

// The basis of a ruling.
enum class Basis {
  normative,  // a sentence of the specification, compared with all others on its subject
  contested,  // its letter, which another sentence, an open issue or the conformance tests read
              // differently
};
template <>
inline constexpr auto kNames<Basis> =
    std::to_array<Named<Basis>>({{Basis::normative, "normative"}, {Basis::contested, "contested"}});

// The specification of the rulings, and its revision.
inline constexpr const char* kRevision = "OpenGL 4.6 core, May 5, 2022";

// The source of a ruling (all_rules.cpp adds it to the ruling).
struct RulingSource {
  std::string clause = {};           // "14.5.1 (Basic Line Segment Rasterization)"; or several
  std::string revision = kRevision;  // of the quoted text
  std::string quotation = {};        // the sentence, at most 25 words of it
  Basis basis = Basis::normative;
  std::string contest = {};    // for contested rulings: the reason to read the text otherwise
  std::string khronos = {};    // what the conformance tests require: group and tolerance
  std::string es = {};         // the differing text of OpenGL ES 3.2, or that it agrees
  std::string withdrawn = {};  // why it was withdrawn, and is cited no more; empty: in force
};

// Our reading of the specification where it is silent or vague. Numbers are unique and never
// reused. A ruling with a contested part becomes two, each with its own number.
struct Ruling {
  int number = 0;
  std::string text;
  RulingSource source = {};  // all_rules() fills it in
};

// Where choices (rules/choices.h) keep the choice for a rule; empty for a rule without a choice.
struct Slot {
  // The name must be one of the rule's alternatives.
  void (*put)(RuleChoices&, std::string_view alternative) = nullptr;
  std::string (*kept)(const RuleChoices&) = nullptr;
  // If a policy does not name the rule: false restores its standard, true keeps the earlier value.
  bool stays = false;
};

// Where, and when, a rule takes part.
struct Say {
  bool (*in_coverage)(const CoverageTraits&) = nullptr;  // which samples a primitive covers
  bool (*in_operations)(const Scene&) = nullptr;         // the outcome of per-fragment operations
  bool in_lookups = false;                               // of textures, except mip chains
};

struct Rule {
  RuleId id = RuleId::none;
  std::string title;
  std::string spec;      // section of OpenGL 4.6, core profile
  std::string latitude;  // what the specification allows an implementation to do differently
  std::string standard;  // the alternative of policy `opengl`; empty: the rule has no alternatives
  std::vector<Alternative> alternatives;
  std::vector<Ruling> rulings;
  Slot slot = {};  // all_rules() fills these in
  Say say = {};
  int ruling = 0;  // that judges a difference under the rule: its own first one, else another
};

// Text and marks that the coverage rules share in their explanations.

// A sentence and the geometry that belongs to it.
struct Explanation {
  std::string text;
  Figure figure;
};

// "(2.5, 3.5)".
inline std::string format_point(Point point) {
  return "(" + to_decimal(point.x) + ", " + to_decimal(point.y) + ")";
}

inline std::pair<double, double> position_of(Point point) {
  return {point.x.to_double(), point.y.to_double()};
}

inline Mark sample_mark(Point sample) {
  return {MarkRole::sample, false, {position_of(sample)}, ""};
}

inline Mark segment_mark(MarkRole role, Point from, Point to, std::string label = "") {
  return {role, false, {position_of(from), position_of(to)}, std::move(label)};
}

}  // namespace edgecase
