// SPDX-License-Identifier: MIT
//
// Supersampled renderings: what passes are, and what they add up to, with every pattern and kernel
// that a case file can name.
#include "raster/samples.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <string>

#include "casefile/loader.h"
#include "model/scene.h"
#include "raster/rasterizer.h"
#include "tests/raster/random_scenes.h"

namespace edgecase {
namespace {

using testing::Each;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

constexpr std::int64_t kQuarter = Fixed::kOne / 4;

Point quarters(std::int64_t x, std::int64_t y) {
  return {Fixed::from_raw(x * kQuarter), Fixed::from_raw(y * kQuarter)};
}

Color constant(float value) {
  return {value, value, value, value};
}

// What a case file's "supersample" stands for.
Supersampling passes_named(const std::string& supersample) {
  const LoadedCases loaded = load_cases_text(
      R"({"title": "t", "rules": ["a.b"], "target": {"width": 8, "height": 8, "supersample": )" +
          supersample + R"(}, "draws": [{"primitive": "points", "vertices": [[4, 4]]}]})",
      "a.json", "a");
  for (const Diagnostic& fault : loaded.diagnostics) ADD_FAILURE() << to_string(fault);
  return loaded.cases.empty() ? Supersampling{} : loaded.cases[0].scene.supersampling;
}

// Patterns with kernels; all weights differ from one another somewhere.
std::vector<std::string> all_patterns() {
  std::vector<std::string> result;
  for (const char* pattern :
       {R"("grid": 1)", R"("grid": 3)", R"("jittered": 3, "seed": 5)", R"("n-rooks": 7, "seed": 6)",
        R"("random": 10, "seed": 7)", R"("samples": [[0.25, 0], ["1/3", 0.5]])"})
    for (const char* kernel : {"", R"(, "kernel": "box", "radius": 1)", R"(, "kernel": "tent")",
                               R"(, "kernel": "gaussian", "radius": "5/4")"})
      if (std::string text = pattern; text.find("1/3") == std::string::npos)
        result.push_back("{" + text + kernel + "}");
  result.push_back(R"({"samples": [[0.25, 0], [0.5, 2], [-1, 0.5]], "weights": [3, 1048576, 7]})");
  return result;
}

// A target of 4 x 3 pixels in the middle of a triangle of one colour.
Scene covered_scene(const Color& color) {
  Scene scene = blank_scene(4, 3);
  scene.viewport = {-64, -64, 128, 128};
  Draw draw;
  draw.interpolation = Interpolation::smooth;
  for (const Point position : {quarters(-200, -200), quarters(200, -200), quarters(0, 200)}) {
    Vertex vertex;
    vertex.position = position;
    vertex.color = color;
    draw.vertices.push_back(vertex);
  }
  scene.draws = {draw};
  return scene;
}

TEST(Supersample, WeightsAddUpToOne) {
  int passes = 0;
  for (const std::string& pattern : all_patterns())
    for (const float value : {0.0F, 0.1F, -7.25F, 1e-30F, 1e19F}) {
      SCOPED_TRACE(pattern);
      Scene scene = covered_scene(constant(value));
      scene.draws[0].interpolation = Interpolation::flat;
      scene.supersampling = passes_named(pattern);
      const Rendering rendering = rasterize(scene, {});
      ASSERT_THAT(rendering.accumulated, SizeIs(4 * 4 * 3));
      EXPECT_THAT(rendering.accumulated, Each(static_cast<double>(value)));
      EXPECT_THAT(rendering.pixels, Each(to_unorm8(static_cast<double>(value))));
      passes += static_cast<int>(rendering.passes.size());
    }
  EXPECT_GT(passes, 1000);
}

TEST(Supersample, NothingDrawnIsTheClearColour) {
  for (const std::string& pattern : all_patterns()) {
    Scene scene = blank_scene(2, 2);
    scene.target.clear = constant(0.3F);
    scene.supersampling = passes_named(pattern);
    const Rendering rendering = rasterize(scene, {});
    EXPECT_THAT(rendering.accumulated, Each(static_cast<double>(0.3F)));
    for (const Rendering& pass : rendering.passes) EXPECT_THAT(pass.fragments, IsEmpty());
  }
}

bool same_fragments(const Rendering& a, const Rendering& b) {
  return std::ranges::equal(a.fragments, b.fragments, [](const Fragment& p, const Fragment& q) {
    return p.x == q.x && p.y == q.y && p.primitive == q.primitive && p.coverage == q.coverage &&
           p.depth == q.depth && p.color == q.color && p.detail == q.detail;
  });
}

void expect_same(const Rendering& a, const Rendering& b) {
  EXPECT_EQ(a.width, b.width);
  EXPECT_EQ(a.height, b.height);
  EXPECT_EQ(a.samples, b.samples);
  EXPECT_EQ(a.pixels, b.pixels);
  EXPECT_EQ(a.hits, b.hits);
  EXPECT_EQ(a.depths, b.depths);
  EXPECT_TRUE(same_fragments(a, b));
}

TEST(Supersample, PassesAreWholeRenderingsAndAGridOfOneIsTheScene) {
  RandomScenes random(3);
  for (int round = 0; round < 50; ++round) {
    Scene scene = random.next({8, 4096, 4, true});
    scene.target.depth = DepthFormat::depth16;
    scene.details.coordinates = true;
    const Rendering plain = rasterize(scene, {});
    scene.supersampling = {{quarters(2, 2), 3}, {quarters(1, 7), 1}};
    const Rendering rendering = rasterize(scene, {});
    ASSERT_THAT(rendering.passes, SizeIs(2));
    expect_same(rendering.passes[0], plain);
    expect_same(rendering.passes[1], rasterize(pass_of(scene, 1), {}));
    EXPECT_THAT(rendering.passes[1].details, SizeIs(rendering.passes[1].fragments.size()));
    EXPECT_THAT(rasterize_for_comparison(scene, {}).passes[1].details, IsEmpty());
    EXPECT_THAT(rendering.fragments, IsEmpty());
    EXPECT_THAT(rendering.hits, IsEmpty());
    EXPECT_THAT(rendering.depths, IsEmpty());
    EXPECT_EQ(rendering.width, 8);
    EXPECT_EQ(rendering.height, 8);
    EXPECT_EQ(rendering.samples, 1);
    scene.supersampling = {{quarters(2, 2), 3}};
    EXPECT_EQ(rasterize(scene, {}).pixels, plain.pixels);
  }
}

// Points and triangles grow with the target; the viewport and everything else does, too.
Scene twice_as_large(Scene scene) {
  scene.supersampling.clear();
  scene.target.width *= 2;
  scene.target.height *= 2;
  scene.viewport = {2 * scene.viewport.x, 2 * scene.viewport.y, 2 * scene.viewport.width,
                    2 * scene.viewport.height};
  for (Draw& draw : scene.draws) {
    draw.point_size = draw.point_size + draw.point_size;
    for (Vertex& vertex : draw.vertices)
      vertex.position = {vertex.position.x + vertex.position.x,
                         vertex.position.y + vertex.position.y};
  }
  return scene;
}

// Pixel (2x + i, 2y + j) of a target twice as large has its centre where pass (i, j) of a 2 x 2
// grid shades pixel (x, y). Colours are flat and the depth is one: values between vertices are only
// known to a double's last bits.
TEST(Supersample, AGridOfFourIsATargetTwiceAsLarge) {
  RandomScenes random(11);
  std::size_t fragments = 0;
  for (int round = 0; round < 400; ++round) {
    Scene scene = random.next({8, Fixed::kOne / (round % 2 == 0 ? 4 : 256), 4, false});
    std::erase_if(scene.draws,
                  [](const Draw& draw) { return kind_of(draw.primitive) == PrimitiveKind::line; });
    // Room for what passes move: the viewport, which cuts, stays.
    scene.viewport = {-4, -4, 16, 16};
    for (Draw& draw : scene.draws) {
      draw.point_size = Fixed::from_raw(5 * kQuarter);
      for (Vertex& vertex : draw.vertices) vertex.z = Fixed();
    }
    scene.supersampling = passes_named(R"({"grid": 2})");
    const Rendering rendering = rasterize(scene, {});
    const Rendering large = rasterize(twice_as_large(scene), {});
    ASSERT_THAT(rendering.passes, SizeIs(4));
    for (std::size_t k = 0; k < 4; ++k) {
      Rendering expected;
      for (Fragment fragment : large.fragments) {
        if (static_cast<std::size_t>(2 * (fragment.y % 2) + fragment.x % 2) != k) continue;
        fragment.x /= 2;
        fragment.y /= 2;
        expected.fragments.push_back(fragment);
      }
      sort_fragments(expected);
      EXPECT_TRUE(same_fragments(rendering.passes[k], expected)) << round << " " << k;
      fragments += expected.fragments.size();
    }
  }
  EXPECT_GT(fragments, 20000U);
}

// What a kernel weighs at distance `d` from the centre, in units of 2^-16.
double kernel_at(const std::string& kernel, double radius, double d) {
  if (kernel == "tent") return 1 - std::abs(d) / radius;
  if (kernel == "gaussian") return std::exp(-d * d / (radius * radius / 2));
  return 1;
}

// The last colour of each pixel, or the clear one.
std::vector<Color> shown_by(const Rendering& rendering, const Color& clear) {
  std::vector<Color> result(static_cast<std::size_t>(rendering.width * rendering.height), clear);
  for (const Fragment& fragment : rendering.fragments) {
    Color& color = result[rendering.pixel_index(fragment.x, fragment.y)];
    for (std::size_t c = 0; c < 4; ++c) color[c] = static_cast<float>(fragment.color[c]);
  }
  return result;
}

// Component `c` of pixel (x, y), from the picture twice as large under a kernel.
double filtered(const std::vector<Color>& large, int width, const std::string& kernel,
                double radius, PixelPosition pixel, std::size_t c) {
  double sum = 0;
  double weights = 0;
  for (int j = 0; j < width; ++j)
    for (int i = 0; i < width; ++i) {
      const double dx = (i + 0.5) / 2 - (pixel.x + 0.5);
      const double dy = (j + 0.5) / 2 - (pixel.y + 0.5);
      if (std::abs(dx) > radius || std::abs(dy) > radius) continue;
      const double weight =
          std::nearbyint(65536 * (kernel_at(kernel, radius, dx) * kernel_at(kernel, radius, dy)));
      sum += weight * static_cast<double>(large[static_cast<std::size_t>(j * width + i)][c]);
      weights += weight;
    }
  return sum / weights;
}

// To supersample under a kernel is to draw a larger picture and filter it. Colours are multiples of
// 1/256 and flat, so that every sum is exact.
TEST(Supersample, AKernelIsAnImageFilterOfALargerTarget) {
  RandomScenes random(12);
  int compared = 0;
  for (int round = 0; round < 60; ++round) {
    Scene scene = random.next({8, Fixed::kOne / 4, 4, false});
    std::erase_if(scene.draws,
                  [](const Draw& draw) { return kind_of(draw.primitive) == PrimitiveKind::line; });
    scene.viewport = {-4, -4, 16, 16};
    for (Draw& draw : scene.draws) {
      draw.point_size = Fixed::from_raw(5 * kQuarter);
      for (Vertex& vertex : draw.vertices)
        for (float& component : vertex.color) component = std::round(component * 256) / 256;
    }
    const auto large = shown_by(rasterize(twice_as_large(scene), {}), scene.target.clear);
    for (const char* kernel : {"box", "tent", "gaussian"})
      for (const double radius : {0.5, 1.0, 1.5}) {
        scene.supersampling = passes_named(R"({"grid": 2, "kernel": ")" + std::string(kernel) +
                                           R"(", "radius": )" + std::to_string(radius) + "}");
        const Rendering rendering = rasterize(scene, {});
        for (int y = 2; y < 6; ++y)
          for (int x = 2; x < 6; ++x)
            for (std::size_t c = 0; c < 4; ++c, ++compared)
              ASSERT_EQ(rendering.accumulated[4 * static_cast<std::size_t>(y * 8 + x) + c],
                        filtered(large, 16, kernel, radius, {x, y}, c))
                  << round << " " << kernel << " " << radius;
      }
  }
  EXPECT_EQ(compared, 60 * 9 * 16 * 4);
}

// One pixel, of which each pass is told what it shows.
std::vector<double> mean_of(const std::vector<Color>& colors,
                            const std::vector<std::int64_t>& weights) {
  Scene scene = blank_scene(1, 1);
  std::vector<Rendering> passes;
  for (std::size_t k = 0; k < colors.size(); ++k) {
    scene.supersampling.push_back({quarters(2, 2), weights[k]});
    Rendering pass;
    Fragment fragment;
    for (std::size_t c = 0; c < 4; ++c) fragment.color[c] = static_cast<double>(colors[k][c]);
    pass.fragments = {Fragment{}, fragment};  // the last one shows
    passes.push_back(pass);
  }
  return accumulated_image(scene, passes);
}

TEST(Supersample, MeansAreTheNearestDoubles) {
  // 1/3 is no double; 2^100 + 1 - 2^100 over 3 asks for every digit.
  const float huge = 0x1p100F;
  EXPECT_THAT(mean_of({{1, 0, huge, -0.0F}, {0, 0, 1, -0.0F}, {0, -1, -huge, 0}}, {1, 1, 1}),
              ElementsAre(1.0 / 3, -1.0 / 3, 1.0 / 3, 0));
  EXPECT_THAT(mean_of({{1, 2, 3, 4}, {0, 0, 3, 0}}, {3, 7}), ElementsAre(0.3, 0.6, 3, 1.2));
  // Halfway between doubles: 2^53 + 1 and 2^53 + 3.
  EXPECT_THAT(mean_of({{0x1p54F, 0x1p54F, -0x1p54F, 1}, {2, 6, -2, 1}}, {1, 1}),
              ElementsAre(0x1p53, 0x1p53 + 4, -0x1p53, 1));
  EXPECT_EQ(mean_of({{1, 1, 1, 1}, {0, 0, 0, 0}}, {1048576, 1})[0], 1048576.0 / 1048577);
}

// One number, of which each pass shows one.
double mean_of_doubles(const std::vector<double>& values) {
  Scene scene = blank_scene(1, 1);
  std::vector<Rendering> passes(values.size());
  for (std::size_t k = 0; k < values.size(); ++k) {
    scene.supersampling.push_back({quarters(2, 2), 1});
    passes[k].fragments.emplace_back().color[0] = values[k];
  }
  return accumulated_image(scene, passes)[0];
}

TEST(Supersample, HugeNumbersHaveAMeanToo) {
  EXPECT_EQ(mean_of_doubles({0x1p60, 0x1p61}), 0x1.8p60);
  EXPECT_EQ(mean_of_doubles({0x1p52, 0x1p53}), 0x1.8p52);
}

TEST(Supersample, AMeanIsNeverMinusZero) {
  const double least = std::numeric_limits<double>::denorm_min();
  for (const std::vector<double>& values : std::vector<std::vector<double>>{
           {-0.0, -0.0}, {-0.0, 0}, {-least, 0}, {-least, 0, 0}, {-least, least}}) {
    EXPECT_EQ(mean_of_doubles(values), 0);
    EXPECT_FALSE(std::signbit(mean_of_doubles(values)));
  }
}

TEST(Supersample, WhatIsNotFiniteStaysSo) {
  const float infinity = std::numeric_limits<float>::infinity();
  const auto mean = mean_of({{infinity, -infinity, infinity, 1}, {0, 1, -infinity, 1}}, {1, 1});
  EXPECT_EQ(mean[0], static_cast<double>(infinity));
  EXPECT_EQ(mean[1], -static_cast<double>(infinity));
  EXPECT_TRUE(std::isnan(mean[2]));
  EXPECT_EQ(mean[3], 1);
}

// Clamping or rounding each pass would show in the mean.
TEST(Supersample, ColoursAreNeitherClampedNorRoundedBeforeTheMean) {
  Scene scene = covered_scene(constant(1));
  Draw left = scene.draws[0];
  for (Vertex& vertex : left.vertices) vertex.color = {3, -1, 0.001F, 1};
  left.interpolation = Interpolation::flat;
  scene.draws = {left};
  scene.draws[0].scissor = Viewport{0, 0, 1, 3};
  scene.target.clear = {0, 1, 0, 1};
  scene.supersampling = {{quarters(2, 2), 1}, {quarters(1, 2), 1}};
  const Rendering rendering = rasterize(scene, {});
  EXPECT_THAT(std::vector<double>(rendering.accumulated.begin(), rendering.accumulated.begin() + 4),
              ElementsAre(3, -1, static_cast<double>(0.001F), 1));
  scene.draws[0].vertices = {scene.draws[0].vertices[0], scene.draws[0].vertices[0],
                             scene.draws[0].vertices[0]};
  // A triangle that ends at x = 0.5: the centre of pixel 0 is on its right edge, and 1/4 inside.
  scene.draws[0].vertices[0].position = quarters(-200, -200);
  scene.draws[0].vertices[1].position = quarters(2, -200);
  scene.draws[0].vertices[2].position = quarters(2, 200);
  const Rendering half = rasterize(scene, {});
  EXPECT_THAT(std::vector<double>(half.accumulated.begin(), half.accumulated.begin() + 4),
              ElementsAre(1.5, 0, static_cast<double>(0.001F) / 2, 1));
  EXPECT_THAT(std::vector<int>(half.pixels.begin(), half.pixels.begin() + 4),
              ElementsAre(255, 0, 0, 255));
}

}  // namespace
}  // namespace edgecase
