// SPDX-License-Identifier: MIT
#include "profile/samples/samples.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "generate/random_scenes.h"
#include "generate/random_shapes.h"

namespace edgecase {
namespace {

constexpr std::int64_t kOne = Fixed::kOne;
constexpr std::int64_t kStep = kOne / 16;
constexpr int kSteps = 16 * kPlainSize;  // of the target

// Generators of one seed with different purposes are independent.
enum Stream : std::uint64_t { kPlanes = 0x5b00, kLinePlanes, kAlphas, kResolves };

Point random_place(RandomSource& random) {
  const std::int64_t x = random.between(1, kSteps - 1);
  return {Fixed::from_raw(x * kStep), Fixed::from_raw(random.between(1, kSteps - 1) * kStep)};
}

// Large enough to usually have fully covered pixels.
std::vector<Point> random_triangle(RandomSource& random) {
  for (;;) {
    const std::vector<Point> p{random_place(random), random_place(random), random_place(random)};
    if (std::abs(turn(p[1] - p[0], p[2] - p[0])) > 32 * kOne * kOne) return p;
  }
}

std::vector<Point> random_line(RandomSource& random) {
  for (;;) {
    const std::vector<Point> p{random_place(random), random_place(random)};
    const RawVector d = p[1] - p[0];
    if (std::abs(d.x) + std::abs(d.y) > 4 * kOne) return p;
  }
}

void set_planes(Vertex& vertex) {
  const Fixed x = vertex.position.x;
  const Fixed y = vertex.position.y;
  vertex.color = {static_cast<float>(x.to_double() / kPlainSize),
                  static_cast<float>(y.to_double() / kPlainSize), 0.5F, 1};
  // Window depth d corresponds to z = 2 d - 1.
  vertex.z = Fixed::from_raw((x.raw() + 2 * y.raw()) / 32 - kOne);
}

Scene multisampled(int size, int samples) {
  Scene scene = empty_scene(Surface::fbo, size);
  scene.target.samples = samples;
  return scene;
}

float random_code(RandomSource& random) {
  return static_cast<float>(random.below(256)) / 255.0F;
}

}  // namespace

Scene plane_scene(std::uint64_t seed, PrimitiveKind kind, int samples, const Multisampling& use,
                  DepthFormat depth, std::uint64_t index) {
  const bool is_line = kind == PrimitiveKind::line;
  RandomSource random(seed, is_line ? kLinePlanes : kPlanes, index);
  Scene scene = multisampled(kPlainSize, samples);
  scene.target.depth = depth;
  Draw draw = colored_draw(is_line ? Primitive::lines : Primitive::triangles,
                           is_line ? random_line(random) : random_triangle(random));
  draw.interpolation = Interpolation::smooth;
  draw.multisampling = use;
  for (Vertex& vertex : draw.vertices) set_planes(vertex);
  scene.draws.push_back(std::move(draw));
  return scene;
}

std::vector<InvocationsAsked> ways_to_ask_for_invocations() {
  std::vector<InvocationsAsked> ways;
  for (const AttributeLocation location :
       {AttributeLocation::center, AttributeLocation::centroid}) {
    Multisampling use;
    use.location = location;
    ways.push_back({"once", use});
    for (const float share : {0.0F, 0.25F, 0.5F, 0.75F, 1.0F}) {
      use.min_sample_shading = share;
      ways.push_back({fmt::format("share {:g}", share), use});
    }
  }
  Multisampling use;
  use.location = AttributeLocation::sample;
  ways.push_back({"sample", use});
  return ways;
}

std::vector<float> probing_alphas(int samples) {
  std::vector<float> alphas;
  for (int i = 0; i <= 256; ++i) alphas.push_back(static_cast<float>(i) / 256);
  const auto add_around = [&](int above, int below) {
    const float near = static_cast<float>(above) / static_cast<float>(below);
    // Numbers below the least normal one may be flushed to zero.
    for (const float alpha : {std::nextafter(near, 0.0F), near, std::nextafter(near, 1.0F)})
      alphas.push_back(alpha > 0 ? std::max(alpha, std::numeric_limits<float>::min()) : alpha);
  };
  for (int s = 0; s <= samples; ++s) {
    add_around(s, samples);
    add_around(s, samples + 1);
    if (s < samples) add_around(2 * s + 1, 2 * samples);
  }
  std::sort(alphas.begin(), alphas.end());
  alphas.erase(std::unique(alphas.begin(), alphas.end()), alphas.end());
  return alphas;
}

PixelPosition alpha_pixel(std::size_t index) {
  const int i = static_cast<int>(index);
  return {2 * (i % 16), 2 * (i / 16)};
}

Scene alpha_scene(int samples, std::span<const float> alphas) {
  Scene scene = multisampled(32, samples);
  std::vector<Point> points;
  for (std::size_t i = 0; i < alphas.size(); ++i) {
    const PixelPosition pixel = alpha_pixel(i);
    points.push_back(pixel_centre(pixel.x, pixel.y));
  }
  Draw draw = colored_draw(Primitive::points, points);
  // More than a pixel, so that no sample lies on a side.
  draw.point_size = Fixed::from_raw(3 * kOne / 2);
  draw.multisampling.alpha_to_coverage = true;
  for (std::size_t i = 0; i < alphas.size(); ++i) draw.vertices[i].color[3] = alphas[i];
  scene.draws.push_back(std::move(draw));
  return scene;
}

Scene alpha_plane_scene(std::uint64_t seed, int samples, bool is_per_sample, std::uint64_t index) {
  RandomSource random(seed, kAlphas, 2 * index + (is_per_sample ? 1 : 0));
  Scene scene = multisampled(kPlainSize, samples);
  Draw draw = colored_draw(Primitive::triangles, random_triangle(random));
  draw.multisampling.alpha_to_coverage = true;
  const float alpha = static_cast<float>(random.below(65)) / 64;
  const std::int64_t sign = random.sign();
  for (Vertex& vertex : draw.vertices) {
    vertex.color[3] = alpha;
    if (!is_per_sample) continue;
    // From 0 to 1 within four pixels, in a band through the middle of the target.
    const double across = vertex.position.x.to_double() + vertex.position.y.to_double() / 4 - 10;
    vertex.color[3] = static_cast<float>(static_cast<double>(sign) * across / 4 + 0.5);
  }
  if (is_per_sample) {
    draw.interpolation = Interpolation::smooth;
    draw.multisampling.location = AttributeLocation::sample;
  }
  scene.draws.push_back(std::move(draw));
  return scene;
}

Scene resolve_scene(std::uint64_t seed, int samples, std::uint64_t index) {
  RandomSource random(seed, kResolves, index);
  Scene scene = multisampled(kPlainSize, samples);
  std::vector<Point> centres;
  for (int y = 0; y < kPlainSize; ++y)
    for (int x = 0; x < kPlainSize; ++x) centres.push_back(pixel_centre(x, y));
  for (int sample = 0; sample < samples; ++sample) {
    Draw draw = colored_draw(Primitive::points, centres);
    draw.multisampling.mask = std::uint32_t{1} << sample;
    for (Vertex& vertex : draw.vertices)
      for (float& component : vertex.color) component = random_code(random);
    scene.draws.push_back(std::move(draw));
  }
  return scene;
}

namespace {

// A vector of each direction, in whole pixels, with a whole length except for diagonals.
constexpr std::array<RawVector, kLineDirections> kVectors{{{5, 0},
                                                           {4, 3},
                                                           {4, 4},
                                                           {3, 4},
                                                           {0, 5},
                                                           {-3, 4},
                                                           {-4, 4},
                                                           {-4, 3},
                                                           {-5, 0},
                                                           {-4, -3},
                                                           {-4, -4},
                                                           {-3, -4},
                                                           {0, -5},
                                                           {3, -4},
                                                           {4, -4},
                                                           {4, -3}}};

bool is_diagonal(RawVector v) {
  return std::abs(v.x) == std::abs(v.y);
}

// The line with the sample on its boundary: at an end, `part` sixteenths of the length from the
// middle, or on a side, that far along it.
std::vector<Point> line_with(Point sample, LineSide side, RawVector whole, std::int64_t part) {
  const RawVector v = kOne * whole;
  if (side == LineSide::start || side == LineSide::end) {
    const Point end = sample - RawVector{-v.y * part / 16, v.x * part / 16};
    return side == LineSide::start ? std::vector<Point>{end, end + v}
                                   : std::vector<Point>{end - v, end};
  }
  // Half the width is a tenth of the length, which is 5. The sample's foot on the line, in
  // twentieths, is not dyadic, but for slanted lines the point a twentieth of the length before or
  // behind it is.
  const std::int64_t toward = side == LineSide::left ? -2 : 2;
  RawVector foot{-toward * whole.y, toward * whole.x};
  if (foot.x % 5 != 0 || foot.y % 5 != 0) {
    const bool is_before = (foot.x + whole.x) % 5 == 0 && (foot.y + whole.y) % 5 == 0;
    foot = is_before ? RawVector{foot.x + whole.x, foot.y + whole.y}
                     : RawVector{foot.x - whole.x, foot.y - whole.y};
  }
  const Point start = sample + RawVector{foot.x * kOne / 20 - v.x * part / 16,
                                         foot.y * kOne / 20 - v.y * part / 16};
  return {start, start + v};
}

// Sixteenths of the length: at an end less than half the width, on a side away from its ends.
std::span<const std::int64_t> parts_of(LineSide side) {
  static constexpr std::array<std::int64_t, 3> kAside{-1, 0, 1};
  static constexpr std::array<std::int64_t, 3> kAlong{4, 8, 11};
  return side == LineSide::start || side == LineSide::end ? kAside : kAlong;
}

}  // namespace

std::vector<LineSideProbe> line_side_probes(const SamplePositions& samples) {
  constexpr PixelPosition kPixel{8, 8};
  std::vector<LineSideProbe> probes;
  for (std::size_t sample = 0; sample < samples.size(); ++sample)
    for (const LineSide side : {LineSide::start, LineSide::end, LineSide::left, LineSide::right})
      for (const RawVector& vector : kVectors) {
        const bool is_end = side == LineSide::start || side == LineSide::end;
        if (!is_end && is_diagonal(vector)) continue;
        for (const std::int64_t part : parts_of(side)) {
          const std::vector<Point> line =
              line_with(place_in(kPixel, samples[sample]), side, vector, part);
          Scene scene = scene_of(Surface::fbo, kPlainSize, Primitive::lines, line);
          scene.target.samples = static_cast<int>(samples.size());
          const LineDirection direction = direction_of({line[0], line[1]});
          probes.push_back({std::move(scene), kPixel, sample, side, direction});
        }
      }
  return probes;
}

}  // namespace edgecase
