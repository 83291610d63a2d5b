// SPDX-License-Identifier: MIT
#include "raster/rasterizer.h"
#include "tests/diff/fragment_changes.h"

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

// The right answer to the next scene that draws something and has no more primitives.
Rendering echo(const Scene& scene, const Rendering&) {
  const auto& all = named_scenes();
  std::size_t i = 0;
  while (all[i].scene.draws[0].vertices[0].color != scene.draws[0].vertices[0].color) ++i;
  for (;;) {
    i = (i + 1) % all.size();
    if (primitives_of(all[i].scene).size() > primitives_of(scene).size()) continue;
    Rendering answer = rasterize(all[i].scene, {});
    if (!answer.fragments.empty()) return answer;
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
                            const char* rule = "") {
    return Mutant{name, std::move(scenes), std::move(mutate), kViolation, rule, kAnyCause};
  };
  return {
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
}

}  // namespace edgecase
