// SPDX-License-Identifier: MIT
//
// Triangles and points: nothing about them is loose but ties and what snapping may move.
#include "tests/diff/coverage/fragment_changes.h"

namespace edgecase {
namespace {

const std::vector<std::string> kAreas = {"triangle", "shared edge",     "fan",
                                         "overdraw", "triangle smooth", "mixed"};
const std::vector<std::string> kQuad = {"shared edge"};
const std::vector<std::string> kBorders = {"points on borders"};

constexpr const char* kFill = "triangle.fill-rule";
constexpr const char* kPoint = "point.ownership";

Mutant violation(const char* name, std::vector<std::string> scenes, Mutation mutate,
                 const char* rule) {
  return {name, std::move(scenes), std::move(mutate), Verdict::violation, rule, ""};
}

// Is it a sample on the diagonal that the two triangles of "shared edge" have in common?
bool on_diagonal(const Fragment& f) {
  return f.x == f.y && f.x > 4 && f.x < 11;
}

void leave_diagonal_out(const Scene&, Fragments& fragments) {
  std::erase_if(fragments, on_diagonal);
}

void draw_diagonal_twice(const Scene& scene, Fragments& fragments) {
  std::erase_if(fragments, on_diagonal);
  for (int i = 5; i < 11; ++i)
    for (int primitive : {0, 1}) fragments.push_back(fragment_at(scene, primitive, i, i));
}

void give_every_other_away(const Scene& scene, Fragments& fragments) {
  for (Fragment& f : fragments)
    if (on_diagonal(f) && f.x % 2 == 0) f = fragment_at(scene, 1 - f.primitive, f.x, f.y);
}

void erase_one_inside(const Scene&, Fragments& f) {
  f.erase(f.begin() + static_cast<std::ptrdiff_t>(f.size() / 3));
}

void draw_beside(const Scene& scene, Fragments& f) {
  draw(scene, f, f[0].x - 1, f[0].y - 1);
}

}  // namespace

std::vector<Mutant> area_mutants() {
  const Mutation last_missing = changed([](const Scene&, Fragments& f) { f.pop_back(); });
  const Mutation none = changed([](const Scene&, Fragments& f) { f.clear(); });
  return {
      violation("moved by 1 in x", kAreas, shifted(1, 0), kFill),
      violation("moved by 1 in y", kAreas, shifted(0, 1), kFill),
      violation("moved by 1 in x and y", kAreas, shifted(1, 1), kFill),
      violation("an inner sample missing", {"triangle", "fan", "triangle smooth"},
                changed(erase_one_inside), kFill),
      violation("a stray beside it", {"triangle", "sliver"}, changed(draw_beside), kFill),
      violation("a shared edge left out", kQuad, changed(leave_diagonal_out),
                "triangle.shared-edge"),
      violation("a shared edge owned twice", kQuad, changed(draw_diagonal_twice),
                "triangle.shared-edge"),
      {"every other sample of a shared edge to the other side", kQuad,
       changed(give_every_other_away), Verdict::permitted, kFill, ""},
      violation("points moved by 1 in x", {"points", "points on borders"}, shifted(1, 0), kPoint),
      violation("points moved by 1 in y", {"points"}, shifted(0, 1), kPoint),
      violation("a point missing", {"points"}, last_missing, kPoint),
      {"points on borders missing", kBorders, none, Verdict::convention, kPoint,
       "point.ownership=open"},
  };
}

}  // namespace edgecase
