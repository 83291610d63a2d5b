// SPDX-License-Identifier: MIT
#include "tests/diff/named_scenes.h"

#include <stdexcept>
#include <utility>

#include "raster/attributes.h"
#include "raster/rasterizer.h"
#include "tests/raster/random_scenes.h"
#include "tests/support/points.h"

namespace edgecase {
namespace {

class Builder {
 public:
  explicit Builder(int salt) : salt_(salt) {}

  Builder& add(Primitive primitive, std::vector<Point> positions,
               Interpolation interpolation = Interpolation::flat) {
    Draw draw = make_draw(primitive, positions, salt_ + static_cast<int>(scene_.draws.size()));
    draw.interpolation = interpolation;
    scene_.draws.push_back(std::move(draw));
    return *this;
  }
  operator Scene() const { return scene_; }

 private:
  Scene scene_ = blank_scene(16, 16);
  int salt_;
};

constexpr Primitive kPoints = Primitive::points;
constexpr Primitive kLines = Primitive::lines;
constexpr Primitive kTriangles = Primitive::triangles;
constexpr Interpolation kSmooth = Interpolation::smooth;

std::vector<NamedScene> line_scenes() {
  return {
      {"line x-major", Builder(1).add(kLines, {at(3.5, 4.5), at(12.5, 8.5)})},
      {"line y-major", Builder(2).add(kLines, {at(5.5, 3.5), at(9.5, 12.5)})},
      {"line 45 degrees", Builder(3).add(kLines, {at(3.5, 3.5), at(11.5, 11.5)})},
      {"line short", Builder(4).add(kLines, {at(6.5, 7.25), at(9.5, 7.75)})},
      {"line of one fragment", Builder(5).add(kLines, {at(6.5, 9.5), at(7.5, 9.5)})},
      {"line within a diamond", Builder(6).add(kLines, {at(6.375, 9.5), at(6.625, 9.5)})},
      {"line on a row's border", Builder(7).add(kLines, {at(3.5, 7), at(11.5, 7)})},
      {"two lines",
       Builder(8).add(kLines, {at(3.5, 3.5), at(12.5, 6.5), at(12.25, 10.5), at(4.5, 12.25)})},
      // Truncation to 4 bits moves the first from row 5 to row 4, truncation to 8 bits the second
      // from row 8 to row 7; no finer grid does.
      {"lines off the grid",
       Builder(9).add(kLines, {at(3.5, 5 + 3.0 / 64), at(12.5, 5 + 3.0 / 64),
                               at(3.5, 8 + 3.0 / 1024), at(12.5, 8 + 3.0 / 1024)})},
      {"line smooth", Builder(10).add(kLines, {at(2.5, 12.5), at(13.5, 4.5)}, kSmooth)},
  };
}

std::vector<Point> beside_centres(double distance) {
  const double left = 4.5 + distance;
  const double top = 12.5 - distance;
  return {at(left, 3.25), at(12.25, top), at(left, top)};
}

// Lines that go on where others end. The joints lie at pixel centres, but for the middles, which
// lie within one diamond.
std::vector<NamedScene> joint_scenes() {
  constexpr Primitive kStrip = Primitive::line_strip;
  return {
      {"strip x-major", Builder(50).add(kStrip, {at(3.5, 4.5), at(8.5, 6.5), at(12.5, 7.5)})},
      {"strip y-major", Builder(51).add(kStrip, {at(5.5, 3.5), at(7.5, 8.5), at(8.5, 12.5)})},
      {"strip leftward", Builder(52).add(kStrip, {at(12.5, 5.5), at(7.5, 7.5), at(3.5, 8.5)})},
      {"strip downward", Builder(53).add(kStrip, {at(10.5, 12.5), at(8.5, 7.5), at(7.5, 3.5)})},
      {"joined lines x-major",
       Builder(54).add(kLines, {at(3.5, 9.5), at(8.5, 8.5), at(8.5, 8.5), at(13.5, 6.5)})},
      {"joined lines y-major",
       Builder(55).add(kLines, {at(9.5, 3.5), at(8.5, 8.5), at(8.5, 8.5), at(6.5, 13.5)})},
      {"joined draws", Builder(56)
                           .add(kLines, {at(3.5, 10.5), at(7.5, 10.5)})
                           .add(kStrip, {at(7.5, 10.5), at(12.5, 11.5)})},
      {"strip with an empty middle",
       Builder(57).add(kStrip, {at(3.5, 4.5), at(7.375, 5.5), at(7.625, 5.5), at(12.5, 7.5)})},
      {"lines with an empty middle",
       Builder(58).add(kLines, {at(5.5, 12.5), at(6.5, 8.625), at(6.5, 8.625), at(6.5, 8.375),
                                at(6.5, 8.375), at(8.5, 3.5)})},
      {"strip that turns back",
       Builder(59).add(kStrip, {at(3.5, 4.5), at(9.25, 5.25), at(3.5, 8.5)})},
      {"strip that turns upward",
       Builder(60).add(kStrip, {at(3.5, 4.5), at(9.5, 5.5), at(11.5, 12.5)})},
      {"lines from one point",
       Builder(61).add(kLines, {at(4.5, 8.5), at(12.5, 11.5), at(4.5, 8.5), at(12.5, 5.5)})},
  };
}

std::vector<NamedScene> triangle_scenes() {
  const std::vector<Point> fan = {at(8, 8), at(3.25, 8.5), at(8.5, 3.25),  //
                                  at(8, 8), at(8.5, 3.25), at(13, 7.5),    //
                                  at(8, 8), at(13, 7.5),   at(7.5, 13),    //
                                  at(8, 8), at(7.5, 13),   at(3.25, 8.5)};
  return {
      {"triangle", Builder(20).add(kTriangles, {at(3.25, 3.25), at(12.75, 5.25), at(5.25, 12.75)})},
      // The common edge runs through pixel centres.
      {"shared edge", Builder(21).add(kTriangles, {at(3, 3), at(13, 3), at(13, 13),  //
                                                   at(3, 3), at(13, 13), at(3, 13)})},
      {"fan", Builder(22).add(kTriangles, fan)},
      {"sliver", Builder(23).add(kTriangles, {at(3.25, 4.25), at(12.75, 5.5), at(12.75, 5.75)})},
      // All edges run through pixel centres; together they tell all eight tie orders apart.
      {"triangles with ties",
       Builder(24).add(kTriangles, {at(3.5, 3.5), at(7.5, 3.5), at(3.5, 7.5), at(8.5, 8.5),
                                    at(12.5, 8.5), at(12.5, 12.5)})},
      // Top edges a little below pixel centres: rounding to 8 bits moves the first onto them,
      // rounding to 4 bits the second too; no finer grid does.
      {"triangles off the grid",
       Builder(25).add(kTriangles,
                       {at(3.25, 7.5 - 3.0 / 2048), at(3.25, 3.25), at(7.25, 7.5 - 3.0 / 2048),
                        at(8.25, 12.5 - 3.0 / 128), at(8.25, 8.25), at(12.25, 12.5 - 3.0 / 128)})},
      // A vertical left and a horizontal top edge beside pixel centres.
      {"triangle a 256th off", Builder(28).add(kTriangles, beside_centres(1.0 / 256))},
      {"triangle a 512th off", Builder(29).add(kTriangles, beside_centres(1.0 / 512))},
      {"triangle smooth",
       Builder(26).add(kTriangles, {at(2.25, 2.5), at(13.75, 4.25), at(4.5, 13.5)}, kSmooth)},
      {"overdraw", Builder(27)
                       .add(kTriangles, {at(3.25, 3.25), at(12.75, 3.25), at(3.25, 12.75)})
                       .add(kTriangles, {at(12.75, 12.75), at(12.75, 3.75), at(3.75, 12.75)})
                       .add(kLines, {at(4.5, 6.5), at(11.5, 6.5)})},
  };
}

std::vector<NamedScene> all_scenes() {
  std::vector<NamedScene> scenes = line_scenes();
  for (NamedScene& scene : joint_scenes()) scenes.push_back(std::move(scene));
  for (NamedScene& scene : triangle_scenes()) scenes.push_back(std::move(scene));
  scenes.push_back({"points", Builder(40).add(kPoints, {at(4.25, 4.75), at(8.5, 9.5),
                                                        at(11.75, 6.25), at(5.5, 11.25)})});
  scenes.push_back({"points on borders", Builder(41).add(kPoints, {at(5, 4.5), at(9, 9)})});
  // Rounding to 8 bits moves the first onto the border of two pixels, rounding to 4 bits the second
  // too; no finer grid does.
  scenes.push_back({"points off the grid",
                    Builder(43).add(kPoints, {at(6 - 3.0 / 2048, 4.5), at(10 - 3.0 / 128, 8.5)})});
  scenes.push_back({"points a 256th off",
                    Builder(44).add(kPoints, {at(7 - 1.0 / 256, 5.5), at(9.5, 11 - 1.0 / 256)})});
  // Primitives alternate, and colours of all components lie on whole steps: 0 and 1.
  Scene mixed = Builder(42)
                    .add(kPoints, {at(4.5, 12.5)})
                    .add(kLines, {at(3.5, 3.5), at(12.5, 3.5)})
                    .add(kTriangles, {at(6.25, 5.5), at(12.75, 5.5), at(12.75, 12.75)});
  int next = 1;
  for (Draw& draw : mixed.draws)
    for (Vertex& vertex : draw.vertices) {
      vertex.color = {static_cast<float>(next & 1), static_cast<float>(next >> 1 & 1),
                      static_cast<float>(next >> 2 & 1), 1};
      ++next;
    }
  scenes.push_back({"mixed", mixed});
  return scenes;
}

}  // namespace

const std::vector<NamedScene>& named_scenes() {
  static const std::vector<NamedScene> scenes = all_scenes();
  return scenes;
}

const Scene& scene_named(const std::string& name) {
  for (const NamedScene& one : named_scenes())
    if (one.name == name) return one.scene;
  throw std::invalid_argument("no scene is named " + name);
}

Rendering compose(const Scene& scene, std::vector<Fragment> fragments) {
  Scene nothing = scene;
  nothing.draws.clear();
  Rendering rendering = rasterize(nothing, {});
  rendering.fragments = std::move(fragments);
  sort_fragments(rendering);
  for (const Fragment& f : rendering.fragments) {
    const std::size_t index = rendering.pixel_index(f.x, f.y);
    ++rendering.hits[index];
    for (std::size_t c = 0; c < 4; ++c) rendering.pixels[4 * index + c] = to_unorm8(f.color[c]);
  }
  return rendering;
}

Fragment fragment_at(const Scene& scene, int primitive, int x, int y) {
  const ScenePrimitive one = primitives_of(scene).at(static_cast<std::size_t>(primitive));
  return shade(one, attributes_of(one, {}, scene.target), {x, y});
}

}  // namespace edgecase
