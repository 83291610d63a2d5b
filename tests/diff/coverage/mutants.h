// SPDX-License-Identifier: MIT
//
// Mutants: renderings that are wrong on purpose, each with the verdict that it must get. They test
// the tester: a comparison that lets one through would let a faulty driver through.
//
// A mutant is applied to the exact rendering of each scene that it names. It says how bad it must
// be found, which rule must be among those that it breaks (or that allow it) and, where a
// catalogued alternative draws exactly that, the cause that must be given. It is killed by exactly
// this, and by a fingerprint that is not the right rendering's.
//
// Swapped samples wait for scenes with more than one sample per pixel.
#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "model/policy.h"
#include "model/rendering.h"
#include "model/scene.h"
#include "model/verdict.h"

namespace edgecase {

// The rule of coverage of a primitive that differs, whatever its kind.
inline constexpr const char* kCoverage = "coverage";

// Lines that run upward and right from a centre leave that out where they are parallelograms of
// which the ends are tested, in a window seen upside down.
inline constexpr const char* kTestedEnds =
    "line.algorithm=parallelogram-ends-tested + line.row-order=top-down";

struct Mutant {
  std::string name;
  std::vector<std::string> scenes;  // names; empty: all of named_scenes()
  std::function<Rendering(const Scene&, const Rendering& exact)> mutate;
  Verdict verdict = Verdict::violation;
  std::string rule;  // id, or kCoverage
  // Of every disagreement about fragments; empty: none. Where primitives have several, all of them,
  // joined by " | ".
  std::string cause;
  // Scenes in which another cause draws the same by chance: nothing drawn is what open edges draw.
  std::map<std::string, std::string> cause_in{};

  // The causes in a scene.
  std::set<std::string> causes_in(const std::string& scene) const;
};

// Wrong fragments: of scenes of every kind, of lines, of joints of lines, of triangles and points.
std::vector<Mutant> general_mutants();
std::vector<Mutant> line_mutants();
std::vector<Mutant> joint_mutants();
std::vector<Mutant> area_mutants();
// Every vertex moved by a fraction of a pixel.
std::vector<Mutant> moved_mutants();
// Rendered by the exact rasterizer under other alternatives.
std::vector<Mutant> alternative_mutants();
// Colours, depths and pixels of fragments that are all there.
std::vector<Mutant> value_mutants();
std::vector<Mutant> pixel_mutants();

}  // namespace edgecase
