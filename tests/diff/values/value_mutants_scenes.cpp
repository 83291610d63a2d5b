// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include "tests/diff/values/value_mutants.h"
#include "tests/raster/random_scenes.h"
#include "tests/support/points.h"

namespace edgecase {
namespace {

struct Corner {
  Point position;
  float w = 1;
  double z = 0;
};

// No two vertices alike, in no component.
constexpr Color kColors[] = {{0.9f, 0.1f, 0.3f, 1.0f},   {0.2f, 0.8f, 0.6f, 0.5f},
                             {0.4f, 0.3f, 1.0f, 0.05f},  {0.7f, 0.55f, 0.1f, 0.8f},
                             {0.05f, 0.95f, 0.4f, 0.3f}, {0.6f, 0.2f, 0.8f, 0.65f}};

Draw draw_of(Primitive primitive, const std::vector<Corner>& corners, Interpolation interpolation,
             std::size_t first_color = 0) {
  Draw draw;
  draw.primitive = primitive;
  draw.interpolation = interpolation;
  for (std::size_t v = 0; v < corners.size(); ++v) {
    Vertex vertex;
    vertex.position = corners[v].position;
    vertex.w = corners[v].w;
    vertex.z = Fixed::from_raw(static_cast<std::int64_t>(corners[v].z * Fixed::kOne));
    vertex.color = kColors[(v + first_color) % std::size(kColors)];
    draw.vertices.push_back(vertex);
  }
  return draw;
}

Scene scene_of(std::vector<Draw> draws, DepthFormat depth = DepthFormat::depth24) {
  Scene scene = blank_scene(16, 16);
  scene.details = {true, true};
  scene.target.depth = depth;
  scene.draws = std::move(draws);
  return scene;
}

constexpr Interpolation kSmooth = Interpolation::smooth;
constexpr Interpolation kNoPerspective = Interpolation::noperspective;

// Off the grids of 8 bits and less: rounding to 8 bits moves these by 2^-10, to 4 bits by 25 times
// as much.
constexpr double kOff = 3.0 / 128 + 1.0 / 1024;

std::vector<Corner> steep_triangle() {
  return {{at(1 + kOff, 1.25 + kOff), 1, -0.75},
          {at(14.5 + kOff, 3 + kOff), 4, 0.5},
          {at(4.25 + kOff, 14.75 + kOff), 16, 0.875}};
}

std::vector<Corner> small_triangle() {
  return {{at(3 + kOff, 4.25 + kOff), 1, 0.25},
          {at(9.5 + kOff, 5 + kOff), 2, 0.5},
          {at(5.25 + kOff, 9.75 + kOff), 4, -0.5}};
}

std::vector<Corner> level(std::vector<Corner> corners) {
  for (Corner& corner : corners) corner.w = 1;
  return corners;
}

// As clip coordinates: quotients that lie on no grid.
Scene clip_scene() {
  Scene scene = scene_of({draw_of(Primitive::triangles, steep_triangle(), kSmooth)});
  auto& v = scene.draws[0].vertices;
  const ClipPosition clips[] = {
      {-0.75f, -0.875f, -0.5f, 1}, {2.25f, -1.5f, 1.25f, 3}, {-3, 8.5f, 7.75f, 11}};
  for (std::size_t i = 0; i < 3; ++i) {
    v[i].clip = clips[i];
    v[i].w = clips[i].w;
    v[i].position = nearest_point(window_position(clips[i], scene.viewport));
    v[i].z = {};
  }
  return scene;
}

// Three triangles and a line, one over the other, with depths far apart.
Scene overdraw(DepthFormat format) {
  const auto triangle = [](double left, double z, std::size_t color) {
    return draw_of(Primitive::triangles,
                   {{at(left, 2.25), 1, z},
                    {at(left + 9, 3.25), 2, z + 0.125},
                    {at(left + 1, 13.75), 4, z + 0.25}},
                   kSmooth, color);
  };
  return scene_of({triangle(1.25, 0.5, 0), triangle(3.25, -0.5, 1), triangle(5.25, 0, 2),
                   draw_of(Primitive::lines,
                           {{at(2.5, 5.25), 1, -0.9375}, {at(13.5, 7.75), 2, 0.9375}}, kSmooth, 3)},
                  format);
}

Scene flat_scene(Primitive primitive, ProvokingVertex convention) {
  const std::vector<Corner> corners = {{at(2.25, 2.75)},        {at(11.75, 1.25), 2},
                                       {at(3.25, 13.25), 4},    {at(13.75, 12.25), 1, 0.5},
                                       {at(8.25, 14.75), 2, 1}, {at(14.25, 6.75), 1, -0.5}};
  Draw draw = draw_of(primitive, corners, Interpolation::flat);
  draw.provoking_vertex = convention;
  return scene_of({draw});
}

const std::pair<Primitive, const char*> kFlatKinds[] = {
    {Primitive::lines, "lines"},
    {Primitive::line_strip, "line_strip"},
    {Primitive::line_loop, "line_loop"},
    {Primitive::triangles, "triangles"},
    {Primitive::triangle_strip, "triangle_strip"},
    {Primitive::triangle_fan, "triangle_fan"}};

std::string flat_name(const char* kind, ProvokingVertex convention) {
  return fmt::format("flat {} {}", kind, name_of(convention));
}

// The uppermost row is none of the target's.
Scene of_odd_height(Scene scene) {
  --scene.target.height;
  return scene;
}

std::vector<ValueScene> all_value_scenes() {
  const std::vector<Corner> line = {{at(1.25 + kOff, 2.75 + kOff), 1, -1},
                                    {at(14.75 + kOff, 11.25 + kOff), 8, 1}};
  const std::vector<Corner> upright = {{at(6.25 + kOff, 14.75 + kOff), 4, 0.25},
                                       {at(9.75 + kOff, 1.25 + kOff), 1, -0.5}};
  constexpr Primitive kLines = Primitive::lines;
  constexpr Primitive kTriangles = Primitive::triangles;
  std::vector<ValueScene> scenes = {
      {"smooth triangle", scene_of({draw_of(kTriangles, steep_triangle(), kSmooth)})},
      {"odd triangle", of_odd_height(scene_of({draw_of(kTriangles, steep_triangle(), kSmooth)}))},
      {"small triangle", scene_of({draw_of(kTriangles, small_triangle(), kSmooth)})},
      {"small linear triangle", scene_of({draw_of(kTriangles, level(small_triangle()), kSmooth)})},
      {"noperspective triangle", scene_of({draw_of(kTriangles, steep_triangle(), kNoPerspective)})},
      {"linear triangle", scene_of({draw_of(kTriangles, level(steep_triangle()), kSmooth)})},
      {"clip triangle", clip_scene()},
      {"smooth line", scene_of({draw_of(kLines, line, kSmooth)})},
      {"upright line", scene_of({draw_of(kLines, upright, kSmooth, 2)})},
      {"noperspective line", scene_of({draw_of(kLines, line, kNoPerspective)})},
      {"linear line", scene_of({draw_of(kLines, level(line), kSmooth)})},
      {"points",
       scene_of({draw_of(Primitive::points, {{at(4.25, 4.75), 2, 0.25}, {at(8.75, 9.5), 3, -0.5}},
                         kSmooth)})},
      {"overdraw depth16", overdraw(DepthFormat::depth16)},
      {"overdraw depth24", overdraw(DepthFormat::depth24)},
      {"overdraw depth32f", overdraw(DepthFormat::depth32f)},
  };
  for (const auto& [kind, name] : kFlatKinds)
    for (const ProvokingVertex convention : {ProvokingVertex::first, ProvokingVertex::last})
      scenes.push_back({flat_name(name, convention), flat_scene(kind, convention)});
  return scenes;
}

}  // namespace

const std::vector<ValueScene>& value_scenes() {
  static const std::vector<ValueScene> scenes = all_value_scenes();
  return scenes;
}

const Scene& value_scene(const std::string& name) {
  for (const ValueScene& one : value_scenes())
    if (one.name == name) return one.scene;
  throw std::invalid_argument("no scene is named " + name);
}

const std::vector<std::string>& flat_scenes(ProvokingVertex convention) {
  const auto names = [](ProvokingVertex of) {
    std::vector<std::string> list;
    for (const auto& [kind, name] : kFlatKinds) list.push_back(flat_name(name, of));
    return list;
  };
  static const std::vector<std::string> first = names(ProvokingVertex::first);
  static const std::vector<std::string> last = names(ProvokingVertex::last);
  return convention == ProvokingVertex::first ? first : last;
}

}  // namespace edgecase
