// SPDX-License-Identifier: MIT
#include "tools/edgecase/bench/scenes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "casefile/loader.h"
#include "generate/random_scenes.h"

namespace edgecase {
namespace {

constexpr std::uint64_t kSeed = 11;
constexpr int kGrid = 256;  // steps of a pixel
constexpr int kLayers = 20;
constexpr double kTurn = 6.283185307179586;

class SceneMaker {
 public:
  SceneMaker(int side, std::uint64_t stream, int samples = 1)
      : side_(side), random_(kSeed, stream, 0) {
    scene_.target.width = scene_.target.height = side;
    scene_.target.samples = samples;
    scene_.viewport = {0, 0, side, side};
  }

  // Fills the lower rows of the target; by default all of it.
  Scene fill(Interpolation interpolation, double share = 1) {
    Draw& draw = add(Primitive::triangle_strip, interpolation);
    const double end = side_, top = share * side_;
    for (const auto& [x, y] : {std::pair{0.0, 0.0}, {end, 0.0}, {0.0, top}, {end, top}})
      add_vertex(draw, x, y);
    return scene_;
  }

  // The same with a texture: about three pixels per texel at the left, a mean of two levels at the
  // right.
  Scene textured(std::shared_ptr<const Texture> texture) {
    fill(Interpolation::smooth);
    Draw& draw = scene_.draws.back();
    draw.texture = TextureUse();
    draw.texture->sampler.minify = Filter::linear;
    draw.texture->sampler.mipmap = MipFilter::linear;
    const auto scale = static_cast<float>(side_) / 256.0F;
    const std::array<float, 2> corners[] = {
        {0, 0}, {5.3F * scale, 0}, {0, 3.7F * scale}, {5.3F * scale, 3.7F * scale}};
    for (std::size_t i = 0; i < draw.vertices.size(); ++i)
      draw.vertices[i].texture_coordinates = corners[i];
    scene_.textures.push_back(std::move(texture));
    return scene_;
  }

  Scene triangles(int count, double leg) {
    Draw& draw = add(Primitive::triangles, Interpolation::flat);
    for (int i = 0; i < count; ++i) {
      const double angle = number(0, kTurn);
      const double x = number(leg, side_ - leg);
      const double y = number(leg, side_ - leg);
      const double along = leg * std::cos(angle);
      const double across = leg * std::sin(angle);
      add_vertex(draw, x, y);
      add_vertex(draw, x + along, y + across);
      add_vertex(draw, x - across, y + along);
    }
    return scene_;
  }

  Scene lines(int count, double length) {
    Draw& draw = add(Primitive::lines, Interpolation::flat);
    for (int i = 0; i < count; ++i) {
      const double slope = number(-1, 1);
      const double rise = length * slope;
      const double along = number(0, side_ - length);
      const double across = number(std::max(0.0, -rise), side_ - std::max(0.0, rise));
      const bool is_x_major = random_.one_in(2);
      const bool is_reversed = random_.one_in(2);
      for (const bool end : {is_reversed, !is_reversed}) {
        const double major = along + (end ? length : 0);
        const double minor = across + (end ? rise : 0);
        is_x_major ? add_vertex(draw, major, minor) : add_vertex(draw, minor, major);
      }
    }
    return scene_;
  }

 private:
  double number(double low, double high) {
    return low + (high - low) * static_cast<double>(random_.below(1 << 24)) / (1 << 24);
  }

  Draw& add(Primitive primitive, Interpolation interpolation) {
    Draw& draw = scene_.draws.emplace_back();
    draw.primitive = primitive;
    draw.interpolation = interpolation;
    return draw;
  }

  void add_vertex(Draw& draw, double x, double y) {
    const auto snapped = [&](double at) {
      const double steps =
          std::clamp(std::round(at * kGrid), 0.0, static_cast<double>(side_) * kGrid);
      return Fixed::from_raw(static_cast<std::int64_t>(steps) * (Fixed::kOne / kGrid));
    };
    Vertex vertex;
    vertex.position = {snapped(x), snapped(y)};
    const auto component = [&] { return static_cast<float>(random_.below(256)) / 255.0F; };
    vertex.color = {component(), component(), component(), 1};
    draw.vertices.push_back(vertex);
  }

  int side_;
  RandomSource random_;
  Scene scene_;
};

// A texture of noise with all levels.
std::shared_ptr<const Texture> noise() {
  constexpr int kSize = 256;
  RandomSource random(kSeed, 99, 0);
  Texture texture;
  for (int level = 0; level < level_count(kSize, kSize); ++level) {
    TextureLevel& made = texture.levels.emplace_back();
    made.width = made.height = level_size(kSize, level);
    for (std::size_t i = 0; i < made.index(0, made.height); ++i)
      made.texels.push_back(static_cast<float>(random.below(256)));
  }
  return std::make_shared<const Texture>(std::move(texture));
}

BenchScene layers_of_fill(int side) {
  BenchScene scene{"flat fill, 20 layers", {}, "pixels", 1.0 * kLayers * side * side};
  for (std::uint64_t i = 0; i < kLayers; ++i)
    scene.layers.push_back(SceneMaker(side, i).fill(Interpolation::flat));
  return scene;
}

// A number of items that makes a frame long enough to time, and short enough to draw several.
int count_for(int side, double share) {
  return std::max(16, static_cast<int>(share * side * side));
}

constexpr const char* kCaseFile = R"({{
  "title": "A triangle and lines that move",
  "rules": ["triangle.fill-rule", "line.diamond-exit"],
  "target": {{"width": 64, "height": 64}},
  "draws": [
    {{"primitive": "triangles", "vertices": [[4, 4], [44, 10], [12, 50]]}},
    {{"primitive": "line_strip", "vertices": [["50+1/2", 3], [58, 40], [20, 60]]}}
  ],
  "sweep": {{
    "dx": {{"add_to": ["/draws/0/vertices/0/x", "/draws/1/vertices/1/x"],
            "range": {{"from": 0, "to": "{}/64", "step": "1/64"}}}},
    "dy": {{"add_to": ["/draws/0/vertices/1/y", "/draws/1/vertices/2/y"],
            "range": {{"from": 0, "to": "63/64", "step": "1/64"}}}}
  }}
}})";

}  // namespace

std::vector<BenchScene> bench_scenes(int side) {
  const double length = 700.0 / 1024 * side;
  const double leg = 500.0 / 1024 * side;
  const int small = count_for(side, 0.02);
  const int large = 64;
  std::vector<BenchScene> scenes;
  scenes.push_back(layers_of_fill(side));
  const auto add = [&](const std::string& name, Scene scene, const char* unit, double items) {
    scenes.push_back({name, {std::move(scene)}, unit, items});
  };
  const double area = 1.0 * side * side;
  add("triangles of 10 px", SceneMaker(side, 21).triangles(small, 10), "triangles", small);
  add(fmt::format("triangles of {:.0f} px", leg), SceneMaker(side, 22).triangles(large, leg),
      "triangles", large);
  add("lines of 8 px", SceneMaker(side, 23).lines(small, 8), "lines", small);
  add(fmt::format("lines of {:.0f} px", length), SceneMaker(side, 24).lines(1000, length), "lines",
      1000);
  add("trilinear texture", SceneMaker(side, 25).textured(noise()), "pixels", area);
  add("triangles of 10 px, 4 samples", SceneMaker(side, 26, 4).triangles(small, 10), "triangles",
      small);
  add("smooth colour fill", SceneMaker(side, 27).fill(Interpolation::smooth), "pixels", area);
  // The share of 1024 x 1024 pixels whose fragments fit into a storage buffer of 128 MiB.
  constexpr double kCaptured = 7.0 / 8;
  Scene detailed = SceneMaker(side, 27).fill(Interpolation::smooth, kCaptured);
  detailed.details.derivatives = true;
  add("smooth fill with derivatives, captured", std::move(detailed), "pixels", kCaptured * area);
  return scenes;
}

Scene whole_scene(const BenchScene& scene) {
  Scene whole = scene.layers.front();
  for (std::size_t i = 1; i < scene.layers.size(); ++i)
    whole.draws.push_back(scene.layers[i].draws.front());
  return whole;
}

std::vector<Case> bench_cases(std::size_t count) {
  constexpr std::size_t kSteps = 64;
  constexpr std::size_t kMost = 64;  // columns of a file
  std::vector<Case> cases;
  for (int file = 0; cases.size() < count; ++file) {
    const std::size_t columns = std::clamp<std::size_t>((count - cases.size()) / kSteps, 1, kMost);
    LoadedCases loaded = load_cases_text(fmt::format(kCaseFile, columns - 1), "bench.json",
                                         fmt::format("bench/{:03}", file));
    // The text is our own, so it always loads.
    if (loaded.cases.empty()) break;
    std::move(loaded.cases.begin(), loaded.cases.end(), std::back_inserter(cases));
  }
  return cases;
}

}  // namespace edgecase
