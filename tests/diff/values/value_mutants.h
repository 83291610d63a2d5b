// SPDX-License-Identifier: MIT
//
// Mutants of values: renderings whose fragments are all where they must be, and whose colours,
// depths, coordinates, derivatives or depth buffers are wrong on purpose, or other than exact as
// the specification permits. Each says exactly what must be found, and nothing else may be.
#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "model/rendering.h"
#include "model/scene.h"
#include "model/verdict.h"
#include "raster/attributes.h"
#include "rules/choices.h"

namespace edgecase {

// Scenes of their own for values, each with all details: perspective so strong that what differs
// shows, and scenes in which nothing may differ.
struct ValueScene {
  std::string name;
  Scene scene;
};
const std::vector<ValueScene>& value_scenes();
const Scene& value_scene(const std::string& name);
// Flat scenes: "flat triangle_fan first" and so on, of every kind of primitive that has more than
// one vertex, under both conventions.
const std::vector<std::string>& flat_scenes(ProvokingVertex convention);

using ValueMutation = std::function<Rendering(const Scene&, const Rendering& exact)>;

struct ValueMutant {
  std::string name;
  std::vector<std::string> scenes;
  ValueMutation mutate;
  Verdict verdict = Verdict::violation;
  // "rule", or "rule: cause" where a cause is found, of all disagreements together.
  std::set<std::string> disagreements;
  // Attributes that differ inside what is permitted. Beside a violation they are not looked at: a
  // wrong value may come near the right one somewhere.
  std::set<std::string> aggregates{};
};

std::vector<ValueMutant> attribute_mutants();
std::vector<ValueMutant> coordinate_mutants();
std::vector<ValueMutant> derivative_mutants();
std::vector<ValueMutant> depth_buffer_mutants();

// Of which mutations are made. Pixels and depth buffer always follow the fragments.

// Exact's fragments with what they would carry under other choices; vertices may be changed too.
Rendering shaded_under(const Scene& scene, const Rendering& exact, const RuleChoices& choices);
// Of those choices the colours and depths only, the details remain exact's.
Rendering colored_under(const Scene& scene, const Rendering& exact, const RuleChoices& choices);

// `change` is applied to a fragment and its detail: to all of them, or to the one in the middle.
using FragmentChange = std::function<void(const Scene&, Fragment&, FragmentDetail&)>;
ValueMutation all_fragments(FragmentChange change);
ValueMutation middle_fragment(FragmentChange change);

// The attributes of a fragment's primitive under OpenGL's choices.
PrimitiveAttributes exact_attributes(const Scene& scene, const Fragment& fragment);

// Writes fragments and their details into the picture and the depth buffer.
Rendering stored(const Scene& scene, Rendering rendering);

// The float32 number above, or below.
double float_above(double value);
double float_below(double value);

}  // namespace edgecase
