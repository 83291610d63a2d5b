// SPDX-License-Identifier: MIT
#include "tools/edgecase/protocol/backend_probe.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace edgecase {

namespace {

constexpr int kSize = 8;
constexpr int kRowWidth = 256;
// The measured edge climbs in steps of 2^-kFinestBits pixels, over 2^-kCoarsestBits of them.
constexpr int kFinestBits = 12;
constexpr int kCoarsestBits = 4;
// With more bits the edge's column moves by less than a pixel per jump, and jumps are not visible.
constexpr int kMostBits = 10;

Scene make_scene(int width, int height) {
  Scene scene;
  scene.target.width = width;
  scene.target.height = height;
  scene.viewport = {0, 0, width, height};
  return scene;
}

Vertex vertex(Fixed x, Fixed y, Color color = {1, 1, 1, 1}) {
  Vertex result;
  result.position = {x, y};
  result.color = color;
  return result;
}

Scene probe_scene(Primitive primitive, Surface surface = Surface::fbo) {
  Scene scene = make_scene(kSize, kSize);
  scene.target.surface = surface;
  Draw draw;
  draw.primitive = primitive;
  const Color colors[] = {{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}};
  const int corners[][2] = {{1, 1}, {6, 2}, {2, 6}};
  for (int i = 0; i < vertices_of(kind_of(primitive)); ++i)
    draw.vertices.push_back(
        vertex(Fixed::centre_of(corners[i][0]), Fixed::centre_of(corners[i][1]), colors[i]));
  if (primitive == Primitive::triangles) draw.interpolation = Interpolation::smooth;
  scene.draws.push_back(draw);
  return scene;
}

// The row with the edge's right end `climb` * 2^-kFinestBits above the centre line.
Scene edge_scene(int climb) {
  Scene scene = make_scene(kRowWidth, 1);
  const Fixed centre = Fixed::centre_of(0);
  const Fixed below = Fixed::from_raw(Fixed::kOne >> kCoarsestBits);
  const Fixed above = Fixed::from_raw(climb * (Fixed::kOne >> kFinestBits));
  Draw draw;
  draw.vertices = {vertex(Fixed(), centre - below), vertex(Fixed::from_integer(kRowWidth), Fixed()),
                   vertex(Fixed::from_integer(kRowWidth), centre + above)};
  scene.draws.push_back(draw);
  return scene;
}

// A point, or a line through the whole target, in the middle of a target that is large enough. No
// pixel's centre lies on a boundary.
Scene thick_scene(Primitive primitive, int thickness) {
  const int size = thickness + 4;
  Scene scene = make_scene(size, size);
  const Fixed quarter = Fixed::from_raw(Fixed::kOne / 4);
  const Fixed middle = Fixed::from_integer(size / 2) + quarter;
  Draw draw;
  draw.primitive = primitive;
  draw.point_size = draw.line_width = Fixed::from_integer(thickness);
  if (primitive == Primitive::points) {
    draw.vertices = {vertex(middle, middle)};
  } else {
    draw.vertices = {vertex(quarter, middle), vertex(Fixed::from_integer(size) - quarter, middle)};
  }
  scene.draws.push_back(draw);
  return scene;
}

std::optional<Rendering> render_one(Renderer& renderer, const Scene& scene, std::string* problem) {
  const Task task{"backends", &scene};
  std::optional<Rendering> result;
  renderer.render({&task, 1}, [&](std::size_t, Outcome outcome) {
    if (auto* rendering = std::get_if<Rendering>(&outcome)) {
      result = std::move(*rendering);
    } else if (problem != nullptr) {
      const Failure& failure = std::get<Failure>(outcome);
      *problem = std::string(name_of(failure.kind)) + ": " + failure.reason;
    }
  });
  return result;
}

bool is_smooth(const Rendering& rendering) {
  for (std::size_t i = 0; i + 3 < rendering.pixels.size(); i += 4) {
    int mixed = 0;
    for (std::size_t c = i; c < i + 3; ++c) mixed += rendering.pixels[c] % 255 != 0 ? 1 : 0;
    if (mixed >= 2) return true;
  }
  return false;
}

bool tells_values(const Rendering& rendering) {
  for (const Fragment& fragment : rendering.fragments)
    if (!fragment.has_color || !fragment.has_depth) return false;
  return !rendering.fragments.empty();
}

// The largest size of 1 to kMostThickness, in pixels, up to which every power of two is drawn that
// size in the target's middle column; 0: none.
int measure_thickness(Renderer& renderer, Primitive primitive) {
  int drawn = 0;
  for (int thickness = 1; thickness <= kMostThickness; thickness *= 2) {
    const auto rendering = render_one(renderer, thick_scene(primitive, thickness), nullptr);
    if (!rendering) break;
    const auto in_middle = [&](const Fragment& fragment) {
      return fragment.x == rendering->width / 2;
    };
    if (std::count_if(rendering->fragments.begin(), rendering->fragments.end(), in_middle) !=
        thickness)
      break;
    drawn = thickness;
  }
  return drawn;
}

void measure_subpixel_bits(Renderer& renderer, ProbeResult& result) {
  int jumps = 0;
  std::optional<Rendering> before;
  for (int climb = 0; climb <= 1 << (kFinestBits - kCoarsestBits); ++climb) {
    auto rendering = render_one(renderer, edge_scene(climb), nullptr);
    if (!rendering) return;
    if (before && before->pixels != rendering->pixels) ++jumps;
    before = std::move(rendering);
  }
  if (jumps == 0) return;
  result.subpixel_bits = kCoarsestBits + static_cast<int>(std::lround(std::log2(jumps)));
  result.more_bits = result.subpixel_bits >= kMostBits;
  if (result.more_bits) result.subpixel_bits = kMostBits;
}

}  // namespace

ProbeResult probe(Renderer& renderer) {
  ProbeResult result;
  const auto start = std::chrono::steady_clock::now();
  const auto triangle = render_one(renderer, probe_scene(Primitive::triangles), &result.problem);
  if (!triangle) return result;
  result.first_answer = std::chrono::duration_cast<std::chrono::milliseconds>(
      std::chrono::steady_clock::now() - start);
  result.triangles = triangle->fragments.size();
  result.smooth = is_smooth(*triangle);
  result.fragment_colors = tells_values(*triangle);
  // Renderings whose hit counts contradict their fragments were refused before.
  result.hits_agree = !triangle->hits.empty();
  if (const auto line = render_one(renderer, probe_scene(Primitive::lines), nullptr))
    result.lines = line->fragments.size();
  if (const auto point = render_one(renderer, probe_scene(Primitive::points), nullptr))
    result.points = point->fragments.size();
  const auto window =
      render_one(renderer, probe_scene(Primitive::triangles, Surface::window), nullptr);
  result.window = window && !window->fragments.empty();
  result.line_width = measure_thickness(renderer, Primitive::lines);
  result.point_size = measure_thickness(renderer, Primitive::points);
  measure_subpixel_bits(renderer, result);
  return result;
}

}  // namespace edgecase
