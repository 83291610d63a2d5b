// SPDX-License-Identifier: MIT
//
// bench_kernels: rates of the exact rasterizer's kernels on 1024x1024 pixels, and of the plain path
// on the same scenes if that takes less than a minute.
//
// A triangle "of n px" is right-angled with legs n pixels long; a line "of n px" is n pixels long
// along its major axis. Directions, positions and grid (1/256 pixel) are random, from a fixed seed.
// Rates are items (triangles, lines) a second or, where pixels determine the cost, pixels a second.
#include <benchmark/benchmark.h>

#include <cmath>
#include <random>

#include "raster/framebuffer.h"
#include "raster/rasterizer.h"

namespace edgecase {
namespace {

constexpr int kSide = 1024;

class SceneMaker {
 public:
  explicit SceneMaker(int samples = 1) {
    scene_.target.width = scene_.target.height = kSide;
    scene_.target.samples = samples;
    scene_.viewport = {0, 0, kSide, kSide};
  }

  // Layers of two triangles that cover the target.
  Scene layers(int count, bool smooth) {
    for (int i = 0; i < count; ++i) {
      Draw& draw = add(Primitive::triangle_strip, smooth);
      for (const auto& [x, y] : {std::pair{0, 0}, {kSide, 0}, {0, kSide}, {kSide, kSide}})
        add_vertex(draw, x, y);
    }
    return scene_;
  }

  // Layers that show a texture of 256x256 texels, 1.5 texels a pixel: two levels.
  Scene textured_layers(int count) {
    constexpr int kTexels = 256;
    Texture texture;
    texture.generated = true;
    TextureLevel& image = texture.levels.emplace_back();
    image.width = image.height = kTexels;
    for (int i = 0; i < 4 * kTexels * kTexels; ++i)
      image.texels.push_back(static_cast<float>(engine_() % 256));
    scene_.textures = {std::make_shared<Texture>(texture)};
    Scene scene = layers(count, true);
    for (Draw& draw : scene.draws) {
      TextureUse& use = draw.texture.emplace();
      use.sampler.minify = Filter::linear;
      use.sampler.mipmap = MipFilter::linear;
      for (Vertex& vertex : draw.vertices)
        vertex.texture_coordinates = {
            static_cast<float>(vertex.position.x.to_double() * 1.5 / kTexels),
            static_cast<float>(vertex.position.y.to_double() * 1.5 / kTexels)};
    }
    return scene;
  }

  Scene triangles(int count, double leg, bool smooth = false) {
    Draw& draw = add(Primitive::triangles, smooth);
    for (int i = 0; i < count; ++i) {
      const double angle = number(0, 6.283), x = place(leg), y = place(leg);
      add_vertex(draw, x, y);
      add_vertex(draw, x + leg * std::cos(angle), y + leg * std::sin(angle));
      add_vertex(draw, x - leg * std::sin(angle), y + leg * std::cos(angle));
    }
    return scene_;
  }

  Scene lines(int count, double length) {
    Draw& draw = add(Primitive::lines, false);
    for (int i = 0; i < count; ++i) {
      const double slope = number(-1, 1), sign = number(0, 1) < .5 ? -1 : 1;
      const double x = number(0, kSide - length), y = place(length * std::abs(slope));
      const bool forward = sign > 0, x_major = number(0, 1) < .5;
      const double ends[2][2] = {{x, y}, {x + length, y + length * slope}};
      for (int e : {forward ? 0 : 1, forward ? 1 : 0})
        x_major ? add_vertex(draw, ends[e][0], ends[e][1])
                : add_vertex(draw, ends[e][1], ends[e][0]);
    }
    return scene_;
  }

 private:
  Draw& add(Primitive primitive, bool smooth) {
    Draw& draw = scene_.draws.emplace_back();
    draw.primitive = primitive;
    draw.interpolation = smooth ? Interpolation::smooth : Interpolation::flat;
    return draw;
  }
  void add_vertex(Draw& draw, double x, double y) {
    const auto snapped = [](double value) {
      return Fixed::from_raw(std::llround(std::clamp(value, 0.0, double{kSide}) * 256) * 256);
    };
    Vertex& vertex = draw.vertices.emplace_back();
    vertex.position = {snapped(x), snapped(y)};
    for (float& component : vertex.color) component = static_cast<float>(number(0, 1));
  }
  double number(double low, double high) {
    return std::uniform_real_distribution<>(low, high)(engine_);
  }
  // A coordinate at least `from_sides` pixels from the target's sides, if the target has room for
  // that.
  double place(double from_sides) {
    const double margin = std::min(from_sides, kSide / 2.0);
    return number(margin, kSide - margin);
  }

  Scene scene_;
  std::mt19937_64 engine_{1};
};

// Draws a prepared scene and resolves its samples each time.
void draw(benchmark::State& state, const Scene& scene, std::int64_t items) {
  Framebuffer framebuffer(scene.target, {});
  const auto prepared = framebuffer.prepared(scene);
  if (!prepared) return state.SkipWithError("left to the plain path");
  for (auto _ : state) {
    framebuffer.draw(*prepared);
    framebuffer.resolve();
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * items);
}

constexpr std::int64_t kPixels = std::int64_t{kSide} * kSide;

void flat_layers(benchmark::State& state) {
  draw(state, SceneMaker().layers(20, false), 20 * kPixels);
}
void smooth_layers(benchmark::State& state) {
  draw(state, SceneMaker().layers(4, true), 4 * kPixels);
}
void trilinear_layers(benchmark::State& state) {
  draw(state, SceneMaker().textured_layers(2), 2 * kPixels);
}
void triangles(benchmark::State& state) {
  const int leg = static_cast<int>(state.range(0));
  const int count = leg > 100 ? 500 : 100000;
  draw(state, SceneMaker().triangles(count, leg), count);
}
void smooth_triangles(benchmark::State& state) {
  const int leg = static_cast<int>(state.range(0));
  const int count = leg > 100 ? 200 : 20000;
  draw(state, SceneMaker().triangles(count, leg, true), count);
}
void multisampled_triangles(benchmark::State& state) {
  draw(state, SceneMaker(4).triangles(100000, static_cast<double>(state.range(0))), 100000);
}
void lines(benchmark::State& state) {
  const int length = static_cast<int>(state.range(0));
  const int count = length > 100 ? 2000 : 100000;
  draw(state, SceneMaker().lines(count, length), count);
}

// Prepares a scene of triangles.
void prepare_triangles(benchmark::State& state) {
  const Scene scene = SceneMaker().triangles(100000, 10);
  const Framebuffer framebuffer(scene.target, {});
  for (auto _ : state) benchmark::DoNotOptimize(framebuffer.prepared(scene));
  state.SetItemsProcessed(state.iterations() * 100000);
}

void plain_triangles(benchmark::State& state) {
  const Scene scene = SceneMaker().triangles(1000, static_cast<double>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(rasterize(scene, {}));
  state.SetItemsProcessed(state.iterations() * 1000);
}

BENCHMARK(flat_layers);
BENCHMARK(smooth_layers);
BENCHMARK(trilinear_layers);
BENCHMARK(triangles)->Arg(3)->Arg(5)->Arg(10)->Arg(20)->Arg(50)->Arg(500);
BENCHMARK(smooth_triangles)->Arg(10)->Arg(50)->Arg(500);
BENCHMARK(multisampled_triangles)->Arg(5)->Arg(10);
BENCHMARK(lines)->Arg(8)->Arg(700);
BENCHMARK(prepare_triangles);
BENCHMARK(plain_triangles)->Arg(10);

}  // namespace
}  // namespace edgecase

BENCHMARK_MAIN();
