// SPDX-License-Identifier: MIT
#include "raster/rasterizer.h"
#include "tests/diff/coverage/fragment_changes.h"

namespace edgecase {
namespace {

constexpr auto kViolation = Verdict::violation;

std::vector<std::string> drawn_scenes() {
  std::vector<std::string> names;
  for (const NamedScene& one : named_scenes())
    if (!rasterize(one.scene, {}).fragments.empty()) names.push_back(one.name);
  return names;
}

// All but what may be left out altogether: one fragment of a line, points between pixels.
std::vector<std::string> scenes_that_must_draw() {
  std::vector<std::string> names = drawn_scenes();
  std::erase(names, "line of one fragment");
  std::erase(names, "points on borders");
  return names;
}

Rendering constant_image(const Scene&, const Rendering& exact) {
  Rendering result = exact;
  for (std::size_t i = 0; i < result.pixels.size(); ++i)
    result.pixels[i] = i % 4 == 3 ? 255 : i % 4 == 0 ? 200 : 30;
  return result;
}

Rendering constant_image_alone(const Scene& scene, const Rendering& exact) {
  Rendering result = constant_image(scene, exact);
  result.fragments.clear();
  return result;
}

// The right answer to the next scene of another kind of primitive that has no more of them.
Rendering echo(const Scene& scene, const Rendering&) {
  const auto& all = named_scenes();
  const auto kind = [](const Scene& s) { return kind_of(s.draws[0].primitive); };
  std::size_t i = 0;
  while (all[i].scene.draws[0].vertices[0].color != scene.draws[0].vertices[0].color) ++i;
  for (;;) {
    i = (i + 1) % all.size();
    const Scene& other = all[i].scene;
    if (kind(other) == kind(scene)) continue;
    if (primitives_of(other).size() <= primitives_of(scene).size()) return rasterize(other, {});
  }
}

void draw_one_twice(const Scene&, Fragments& f) {
  f.push_back(f[f.size() / 2]);
}

void give_first_to_second(const Scene&, Fragments& f) {
  for (Fragment& one : f) one.primitive = std::max(one.primitive, 1);
}

}  // namespace

std::vector<Mutant> general_mutants() {
  const Mutation nothing = changed([](const Scene&, Fragments& f) { f.clear(); });
  const Mutation stray = changed([](const Scene& s, Fragments& f) { draw(s, f, 0, 15); });
  const auto violation = [](const char* name, std::vector<std::string> scenes, Mutation mutate,
                            const char* rule = kCoverage) {
    return Mutant{name, std::move(scenes), std::move(mutate), kViolation, rule, ""};
  };
  // Open boundaries draw none of these, some of them after a snap.
  const std::map<std::string, std::string> nothing_by_chance = {
      {"line on a row's border", "line.diamond-exit=open"},
      {"lines off the grid", "line.diamond-exit=open + line.snap=4-truncate"},
      {"points on borders", "point.ownership=open"},
      {"points off the grid", "point.ownership=open + point.snap=4-half-even"},
      {"points a 256th off", "point.ownership=open + point.snap=7-half-even"},
  };
  std::vector<Mutant> mutants = {
      violation("constant image, no fragments", {}, constant_image_alone, "framebuffer.unorm8"),
      violation("constant image, right fragments", {}, constant_image, "framebuffer.unorm8"),
      violation("nothing drawn", scenes_that_must_draw(), nothing),
      violation("another scene's answer", {}, echo),
      violation("moved by 2 in x", drawn_scenes(), shifted(2, 0)),
      violation("moved by 2 in y", drawn_scenes(), shifted(0, 2)),
      violation("moved by -2 in x and y", drawn_scenes(), shifted(-2, -2)),
      violation("a fragment twice", drawn_scenes(), changed(draw_one_twice), "fragment.once"),
      violation("a stray far away", {}, stray),
      violation("a primitive drawn under another's number",
                {"two lines", "points", "fan", "shared edge"}, changed(give_first_to_second)),
  };
  // One of two primitives gets nothing.
  const std::map<std::string, std::string> half_of_nothing_by_chance = {
      {"lines off the grid", "line.diamond-exit=open + line.snap=8-truncate | "},
      {"points on borders", "point.ownership=open | "},
  };
  for (Mutant& mutant : mutants) {
    if (mutant.name == "constant image, no fragments" || mutant.name == "nothing drawn")
      mutant.cause_in = nothing_by_chance;
    else if (mutant.name == "another scene's answer")
      mutant.cause_in = half_of_nothing_by_chance;
  }
  return mutants;
}

}  // namespace edgecase
