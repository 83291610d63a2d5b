// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "tests/diff/values/value_mutants.h"

namespace edgecase {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr auto kViolation = Verdict::violation;
constexpr auto kPermitted = Verdict::permitted;

const std::vector<std::string> kSmooth = {"smooth triangle", "smooth line", "upright line",
                                          "clip triangle"};
const std::vector<std::string> kNoPerspective = {"noperspective triangle", "noperspective line"};
const std::vector<std::string> kTriangles = {"smooth triangle", "noperspective triangle",
                                             "linear triangle"};
const std::vector<std::string> kLines = {"smooth line", "upright line", "noperspective line",
                                         "linear line"};
const std::vector<std::string> kInterpolated = {
    "smooth triangle", "noperspective triangle", "linear triangle",    "clip triangle",
    "smooth line",     "upright line",           "noperspective line", "linear line"};

std::vector<std::string> both(std::vector<std::string> a, const std::vector<std::string>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

template <class Change>
ValueMutation under(Change change) {
  return [change](const Scene& scene, const Rendering& exact) {
    RuleChoices choices;
    change(choices);
    return colored_under(scene, exact, choices);
  };
}

ValueMutation with_perspective(PerspectiveChoice perspective) {
  return under([=](RuleChoices& c) { c.values.perspective = perspective; });
}

ValueMutation with_provoking(ProvokingChoice provoking) {
  return under([=](RuleChoices& c) { c.values.provoking = provoking; });
}

ValueMutation with_snapped_positions(int bits, Snap::Rounding rounding) {
  return under([=](RuleChoices& c) {
    c.values.positions = AttributePositions::snapped;
    c.triangles.snap = c.lines.snap = {bits, rounding};
  });
}

// Another scene's colours and depths at the same pixels.
template <class Change>
ValueMutation of_scene(Change change) {
  return [change](const Scene& scene, const Rendering& exact) {
    Scene other = scene;
    for (Draw& draw : other.draws) change(draw);
    return stored(scene, colored_under(other, exact, {}));
  };
}

ValueMutation interpolated_as(Interpolation interpolation) {
  return of_scene([=](Draw& draw) { draw.interpolation = interpolation; });
}

// Each fragment has the colour of the pixel beside it, depth stays.
ValueMutation with_neighbours_color(int dx, int dy) {
  return all_fragments([=](const Scene& scene, Fragment& f, FragmentDetail&) {
    const auto primitive = primitives_of(scene).at(static_cast<std::size_t>(f.primitive));
    f.color = shade(primitive, exact_attributes(scene, f), {f.x + dx, f.y + dy}).color;
  });
}

ValueMutation with_depth_at(double dx, double dy, bool perspective) {
  return all_fragments([=](const Scene& scene, Fragment& f, FragmentDetail&) {
    Interpolant depth = exact_attributes(scene, f).depth;
    depth.perspective = perspective;
    Point sample = pixel_centre(f.x, f.y);
    sample.x = sample.x + Fixed::from_raw(static_cast<std::int64_t>(dx * Fixed::kOne));
    sample.y = sample.y + Fixed::from_raw(static_cast<std::int64_t>(dy * Fixed::kOne));
    f.depth = middle(interpolate_exact(depth, sample));
  });
}

FragmentChange color_change(std::size_t c, double (*change)(double)) {
  return [=](const Scene&, Fragment& f, FragmentDetail&) { f.color[c] = change(f.color[c]); };
}
FragmentChange depth_change(double (*change)(double)) {
  return [=](const Scene&, Fragment& f, FragmentDetail&) { f.depth = change(f.depth); };
}

double nan(double) {
  return kNaN;
}
double infinite(double) {
  return HUGE_VAL;
}
double negative_infinite(double) {
  return -HUGE_VAL;
}
double above_by_a_thousandth(double value) {
  return value + 1e-3;
}
double below_by_a_thousandth(double value) {
  return value - 1e-3;
}

void all_components_up(const Scene&, Fragment& f, FragmentDetail&) {
  for (double& c : f.color) c = float_above(c);
}
void all_components_down(const Scene&, Fragment& f, FragmentDetail&) {
  for (double& c : f.color) c = float_below(c);
}

void constant_color(const Scene&, Fragment& f, FragmentDetail&) {
  f.color = {0.5, 0.5, 0.5, 0.5};
}

void color_of_vertex_1(const Scene& scene, Fragment& f, FragmentDetail&) {
  const auto primitive = primitives_of(scene).at(static_cast<std::size_t>(f.primitive));
  const Color& color = primitive.vertices[1]->color;
  std::copy(color.begin(), color.end(), f.color.begin());
}

void depth_of_vertex_0(const Scene& scene, Fragment& f, FragmentDetail&) {
  f.depth = middle(exact_attributes(scene, f).depth.values[0]);
}

double clip_depth(double depth) {
  return 2 * depth - 1;
}
double reversed_depth(double depth) {
  return 1 - depth;
}

const std::string kSmoothRule = "attribute.smooth";
const std::string kFlatRule = "attribute.flat";
const std::string kDepthRule = "fragment.depth";

std::vector<ValueMutant> interpolation_mutants() {
  const auto half_even = Snap::Rounding::half_even;
  const auto wrong = [](const char* name, std::vector<std::string> scenes, ValueMutation mutate) {
    return ValueMutant{name, std::move(scenes), std::move(mutate), kViolation, {kSmoothRule}};
  };
  return {
      {"noperspective for smooth",
       kSmooth,
       with_perspective(PerspectiveChoice::never),
       kViolation,
       {kSmoothRule + ": attribute.perspective=never"}},
      {"smooth for noperspective",
       kNoPerspective,
       with_perspective(PerspectiveChoice::always),
       kViolation,
       {kSmoothRule + ": attribute.perspective=always"}},
      {"the parameter of the major axis",
       kLines,
       under([](RuleChoices& c) { c.values.line_parameter = LineParameter::major_axis; }),
       Verdict::contested,
       {kSmoothRule + ": attribute.smooth=major-axis",
        kDepthRule + ": attribute.smooth=major-axis"}},
      {"positions snapped to 8 bits of 8",
       kTriangles,
       with_snapped_positions(8, half_even),
       kPermitted,
       {},
       {"color", "depth"}},
      {"positions truncated to 8 bits of 8",
       kInterpolated,
       with_snapped_positions(8, Snap::Rounding::truncate),
       kPermitted,
       {},
       {"color", "depth"}},
      {"positions snapped to 4 bits of 8",
       both(kTriangles, {"smooth line"}),
       with_snapped_positions(4, half_even),
       kViolation,
       {kSmoothRule, kDepthRule}},
      wrong("flat for smooth", kInterpolated, interpolated_as(Interpolation::flat)),
      wrong("constant colour", kInterpolated, all_fragments(constant_color)),
      wrong("the right neighbour's colour", kInterpolated, with_neighbours_color(1, 0)),
      wrong("the left neighbour's colour", kInterpolated, with_neighbours_color(-1, 0)),
      wrong("the upper neighbour's colour", kTriangles, with_neighbours_color(0, 1)),
      wrong("the lower neighbour's colour", kTriangles, with_neighbours_color(0, -1)),
  };
}

std::vector<ValueMutant> flat_mutants() {
  std::vector<std::string> triangles;
  for (const std::string& name :
       both(flat_scenes(ProvokingVertex::first), flat_scenes(ProvokingVertex::last)))
    if (name.find("triangle") != std::string::npos) triangles.push_back(name);
  const std::vector<std::string> some = {"flat lines first", "flat triangles last",
                                         "flat triangle_fan first"};
  return {
      {"the last vertex provokes for the first",
       flat_scenes(ProvokingVertex::first),
       with_provoking(ProvokingChoice::last),
       kViolation,
       {kFlatRule + ": attribute.provoking-vertex=last"}},
      {"the first vertex provokes for the last",
       flat_scenes(ProvokingVertex::last),
       with_provoking(ProvokingChoice::first),
       kViolation,
       {kFlatRule + ": attribute.provoking-vertex=first"}},
      {"smooth for flat",
       triangles,
       interpolated_as(Interpolation::smooth),
       kViolation,
       {kFlatRule}},
      {"flat colour one ULP off",
       some,
       middle_fragment(color_change(1, float_above)),
       kViolation,
       {kFlatRule}},
      {"flat colour NaN", some, middle_fragment(color_change(0, nan)), kViolation, {kFlatRule}},
      {"flat colour infinite",
       some,
       middle_fragment(color_change(3, infinite)),
       kViolation,
       {kFlatRule}},
      {"colour of the vertex in the middle",
       {"flat triangles first", "flat triangles last"},
       all_fragments(color_of_vertex_1),
       kViolation,
       {kFlatRule}},
  };
}

std::vector<ValueMutant> number_mutants() {
  std::vector<ValueMutant> mutants = {
      {"colours one ULP up",
       kInterpolated,
       all_fragments(all_components_up),
       kPermitted,
       {},
       {"color"}},
      {"colours one ULP down",
       kInterpolated,
       all_fragments(all_components_down),
       kPermitted,
       {},
       {"color"}},
      {"one colour one ULP up",
       kInterpolated,
       middle_fragment(all_components_up),
       kPermitted,
       {},
       {"color"}},
      {"one colour one ULP down",
       kInterpolated,
       middle_fragment(all_components_down),
       kPermitted,
       {},
       {"color"}},
      {"depths one ULP up",
       kInterpolated,
       all_fragments(depth_change(float_above)),
       kPermitted,
       {},
       {"depth"}},
      {"one depth one ULP down",
       kInterpolated,
       middle_fragment(depth_change(float_below)),
       kPermitted,
       {},
       {"depth"}},
  };
  const std::pair<const char*, double (*)(double)> changes[] = {
      {"NaN", nan},
      {"infinite", infinite},
      {"negative infinite", negative_infinite},
      {"a thousandth up", above_by_a_thousandth},
      {"a thousandth down", below_by_a_thousandth}};
  // Where an attribute runs fast, vertices that move by 2^-8 account for a thousandth.
  const std::vector<std::string> gentle = {"linear triangle", "noperspective triangle", "points"};
  const std::vector<std::string> any = {"linear triangle", "smooth line", "noperspective line",
                                        "points", "overdraw depth24"};
  for (const auto& [name, change] : changes) {
    const bool finite = std::isfinite(change(0));
    const std::vector<std::string>& some = finite ? gentle : any;
    for (std::size_t c = 0; c < 4; ++c)
      mutants.push_back({std::string("colour ") + name + " in component " + std::to_string(c),
                         some,
                         middle_fragment(color_change(c, change)),
                         kViolation,
                         {kSmoothRule}});
    mutants.push_back({std::string("depth ") + name,
                       some,
                       middle_fragment(depth_change(change)),
                       kViolation,
                       {kDepthRule}});
  }
  return mutants;
}

std::vector<ValueMutant> depth_mutants() {
  const auto wrong = [](const char* name, std::vector<std::string> scenes, ValueMutation mutate) {
    return ValueMutant{name, std::move(scenes), std::move(mutate), kViolation, {kDepthRule}};
  };
  return {
      wrong("depth with perspective", both(kSmooth, kNoPerspective), with_depth_at(0, 0, true)),
      wrong("depth of the right neighbour", kTriangles, with_depth_at(1, 0, false)),
      wrong("depth of the pixel's corner", kTriangles, with_depth_at(-.5, -.5, false)),
      wrong("depth of vertex 0", kInterpolated, all_fragments(depth_of_vertex_0)),
      wrong("depth of -1 to 1", kInterpolated, all_fragments(depth_change(clip_depth))),
      wrong("depth reversed", kInterpolated, all_fragments(depth_change(reversed_depth))),
  };
}

}  // namespace

std::vector<ValueMutant> attribute_mutants() {
  std::vector<ValueMutant> mutants;
  for (const auto& more :
       {interpolation_mutants(), flat_mutants(), number_mutants(), depth_mutants()})
    mutants.insert(mutants.end(), more.begin(), more.end());
  return mutants;
}

}  // namespace edgecase
