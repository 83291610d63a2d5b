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

// How we read the specification where it is silent or loose. Numbers are unique and never reused.
struct Ruling {
  int number = 0;
  std::string text;
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
