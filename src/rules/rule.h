// SPDX-License-Identifier: MIT
//
// Rule: one statement of the OpenGL specification, as an entry of the catalogue.
//
// The predicate that decides lives beside the entry, in the rule's own pair of files; the entry
// says in words what it is, which alternatives are known, which of them the specification leaves
// open, and by which rulings a difference is judged.
#pragma once

#include <string>
#include <vector>

namespace edgecase {

enum class Openness {
  open,      // the specification leaves the choice to the implementation
  mandated,  // the only choice that conforms
  illegal,   // known from faulty implementations; never conforms as such
};

const char* name_of(Openness);

struct Alternative {
  std::string name;
  Openness openness = Openness::open;
  std::string meaning;  // one sentence
};

// What a ruling rests on.
enum class Basis {
  normative,  // a sentence of the specification, held against all others of its subject
  contested,  // its letter; another sentence, an open issue or the conformance tests read it
              // otherwise
};

const char* name_of(Basis);

// The specification that rulings are held against, and its revision.
inline constexpr const char* kRevision = "OpenGL 4.6 core, May 5, 2022";

// What a ruling rests on (rules/ruling_sources.cpp has all of them).
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

struct Rule {
  std::string id;
  std::string title;
  std::string spec;      // section of OpenGL 4.6, core profile
  std::string latitude;  // what the specification allows an implementation to do differently
  std::string standard;  // the alternative of policy `opengl`; empty: the rule has no alternatives
  std::vector<Alternative> alternatives;
  std::vector<Ruling> rulings;
};

}  // namespace edgecase
