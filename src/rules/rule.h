// SPDX-License-Identifier: MIT
//
// Rule: one statement of the OpenGL specification, as an entry of the catalogue.
//
// The predicate that decides lives beside the entry, in the rule's own pair of files; the entry
// says in words what it is, which alternatives are known, which of them the specification leaves
// open, and by which rulings a difference is judged.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "model/names.h"
#include "model/rule_id.h"

namespace edgecase {

struct CoverageTraits;
struct RuleChoices;
struct Scene;

enum class Openness {
  open,      // the specification leaves the choice to the implementation
  mandated,  // the only choice that conforms
  illegal,   // known from faulty implementations; never conforms as such
};
template <>
inline constexpr auto kNames<Openness> = std::to_array<Named<Openness>>(
    {{Openness::open, "open"}, {Openness::mandated, "mandated"}, {Openness::illegal, "illegal"}});

struct Alternative {
  std::string name;
  Openness openness = Openness::open;
  std::string meaning;  // one sentence
};

// Most rules have their alternatives in one table beside the enumeration that stands for them
// (model/names.h): the name that policies use, whether it conforms, and what it means.
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

// What a ruling rests on.
enum class Basis {
  normative,  // a sentence of the specification, held against all others of its subject
  contested,  // its letter; another sentence, an open issue or the conformance tests read it
              // otherwise
};
template <>
inline constexpr auto kNames<Basis> =
    std::to_array<Named<Basis>>({{Basis::normative, "normative"}, {Basis::contested, "contested"}});

// The specification that rulings are held against, and its revision.
inline constexpr const char* kRevision = "OpenGL 4.6 core, May 5, 2022";

// What a ruling rests on (all_rules.cpp puts them beside the rulings).
struct RulingSource {
  std::string clause = {};           // "14.5.1 (Basic Line Segment Rasterization)"; or several
  std::string revision = kRevision;  // of the text that is quoted
  std::string quotation = {};        // the sentence, at most 25 words of it
  Basis basis = Basis::normative;
  std::string contest = {};    // of contested ones: the reason to read it otherwise
  std::string khronos = {};    // what the conformance tests ask: group and tolerance
  std::string es = {};         // what OpenGL ES 3.2 says instead, or that it says the same
  std::string withdrawn = {};  // why the ruling fell; empty: it holds. Nothing cites one that fell
};

// How we read the specification where it is silent or loose. Numbers are unique and never reused. A
// ruling with a part that is contested is two, each with a number of its own.
struct Ruling {
  int number = 0;
  std::string text;
  RulingSource source = {};  // all_rules() fills it in
};

// Where choices (rules/choices.h) keep what is chosen for a rule. Rules that are not about a choice
// have none.
struct Slot {
  // The name must be one of the rule's alternatives.
  void (*put)(RuleChoices&, std::string_view alternative) = nullptr;
  std::string (*kept)(const RuleChoices&) = nullptr;
  // A policy that says nothing of the rule has its standard; or, of these, what is there before.
  bool stays = false;
};

// In what a rule has a say, and when.
struct Say {
  bool (*in_coverage)(const CoverageTraits&) = nullptr;  // which samples a primitive covers
  bool (*in_fate)(const Scene&) = nullptr;  // what becomes of a scene's fragments on the way
  bool in_lookups = false;                  // of textures, mip chains aside
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
  int ruling =
      0;  // by which a difference under the rule is judged: its own first one, else another
};

}  // namespace edgecase
