// SPDX-License-Identifier: MIT
//
// Mutants: renderings that are wrong on purpose, each with the verdict that it must get. They test
// the tester: a comparison that lets one through would let a faulty driver through.
//
// A mutant is applied to the exact rendering of each scene that it names. It says how bad it must
// be found, which rule must be among those that differ and, where a catalogued alternative
// draws exactly that, the cause that must be given.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "model/policy.h"
#include "model/rendering.h"
#include "model/scene.h"
#include "model/verdict.h"

namespace edgecase {

// For mutants whose cause is a matter of chance: nothing drawn may be what open edges draw.
inline constexpr const char* kAnyCause = "any";

struct Mutant {
  std::string name;
  std::vector<std::string> scenes;  // names; empty: all of named_scenes()
  std::function<Rendering(const Scene&, const Rendering& exact)> mutate;
  Verdict verdict = Verdict::violation;
  std::string rule;   // id; empty: any
  std::string cause;  // of every disagreement about coverage, or about colour; empty: none
};

// Wrong fragments: of scenes of every kind, of lines, of triangles and points.
std::vector<Mutant> general_mutants();
std::vector<Mutant> line_mutants();
std::vector<Mutant> area_mutants();
// Rendered by the exact rasterizer under other alternatives.
std::vector<Mutant> alternative_mutants();
// Colours, depths and pixels of fragments that are all there.
std::vector<Mutant> value_mutants();
std::vector<Mutant> pixel_mutants();

}  // namespace edgecase
