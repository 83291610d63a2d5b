// SPDX-License-Identifier: MIT
//
// Policy: a choice of alternative for every rule, as data.
#pragma once

#include <map>
#include <string>

#include "model/scene.h"

namespace edgecase {

enum class Latitude {
  opengl,  // OpenGL's latitude decides which differences are permitted
  none,    // any difference is a violation of this policy
};

// rule id -> name of the alternative. An absent rule takes the default of its catalogue entry;
// triangle.snap, line.snap and point.snap default to subpixel.snap.
using Choices = std::map<std::string, std::string>;

struct Policy {
  std::string name = "opengl";
  Latitude latitude = Latitude::opengl;
  Choices rules;
  std::map<Surface, Choices> surfaces;  // overrides for one kind of surface
};

}  // namespace edgecase
