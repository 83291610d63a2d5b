// SPDX-License-Identifier: MIT
//
// Policy: a choice of alternative for every rule, as data.
#pragma once

#include <map>
#include <string>

#include "model/scene.h"

namespace edgecase {

enum class Latitude {
  opengl,  // a difference is judged by what OpenGL permits
  none,    // any difference is a violation of this policy
};

// rule id -> name of the alternative. A rule that is absent takes the default of its catalogue
// entry; triangle.snap, line.snap and point.snap default to subpixel.snap.
using Choices = std::map<std::string, std::string>;

struct Policy {
  std::string name = "opengl";
  Latitude latitude = Latitude::opengl;
  Choices rules;
  std::map<Surface, Choices> surfaces;  // overrides for one kind of surface
};

}  // namespace edgecase
