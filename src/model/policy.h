// SPDX-License-Identifier: MIT
//
// Policy: a choice of alternative for every rule, as data; and its gallery.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "model/scene.h"
#include "model/verdict.h"

namespace edgecase {

// rule id -> name of the alternative. An absent rule takes the default of its catalogue entry;
// triangle.snap, line.snap and point.snap default to subpixel.snap.
using Choices = std::map<std::string, std::string>;

// A rule as readers and schemas of policies know it: what a policy may name.
struct KnownRule {
  std::string id;
  std::vector<std::string> alternatives;
  std::string title = {};  // what the rule says, for people
};

struct Policy {
  std::string name = "opengl";
  Latitude latitude = Latitude::opengl;
  Choices rules;
  std::map<Surface, Choices> surfaces;  // overrides for one kind of surface
};

// Gallery: the cases that present a policy, with the text beside their pictures.

struct GalleryPicture {
  std::string case_id;  // of a case, or of a case file, which stands for the base case of its sweep
  std::string heading;
  std::string text;  // what to look at; may be empty
  Choices rules;     // deviations from the policy in this picture; usually none
};

struct Gallery {
  std::string title;
  std::string about;
  std::string policy;                // its name
  std::vector<std::string> sources;  // where the system is documented
  // rule id -> the reason for the choice; only rules that the policy chooses.
  std::map<std::string, std::string> choices;
  // rule id -> why no picture shows the choice.
  std::map<std::string, std::string> not_shown;
  std::vector<GalleryPicture> pictures;
};

}  // namespace edgecase
