// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "raster/rasterizer.h"
#include "tests/diff/coverage/fragment_changes.h"

namespace edgecase {
namespace {

// Applies `change` to every fragment; pixels follow.
template <class Change>
auto every_fragment(Change change) {
  return [change](const Scene& scene, const Rendering& exact) {
    std::vector<Fragment> fragments = exact.fragments;
    for (Fragment& f : fragments) change(f);
    return compose(scene, std::move(fragments));
  };
}

// Applies `change` to the fragment in the middle only.
template <class Change>
auto one_fragment(Change change) {
  return [change](const Scene& scene, const Rendering& exact) {
    std::vector<Fragment> fragments = exact.fragments;
    change(fragments[fragments.size() / 2]);
    return compose(scene, std::move(fragments));
  };
}

double next_float(double value) {
  return static_cast<double>(std::nextafterf(static_cast<float>(value), 2));
}

// The pixel at the middle fragment's place, and that fragment.
template <class Change>
auto one_pixel(Change change) {
  return [change](const Scene&, const Rendering& exact) {
    Rendering result = exact;
    const Fragment& f = exact.fragments[exact.fragments.size() / 2];
    change(result.pixels.data() + 4 * result.pixel_index(f.x, f.y), f);
    return result;
  };
}

// The neighbour of 255 times the colour that is not the nearest, or one step beyond it.
std::uint8_t other_neighbour(double component, int beyond) {
  const double scaled = component * 255;
  const double nearest = std::nearbyint(scaled);
  const int direction = scaled > nearest ? 1 : -1;
  return static_cast<std::uint8_t>(nearest + direction * (1 + beyond));
}

// Fragments where exact has them, with the values that another scene has there.
Rendering shaded_as(const Scene& scene, const Rendering& exact, const Scene& other) {
  std::vector<Fragment> fragments = exact.fragments;
  for (Fragment& f : fragments) f = fragment_at(other, f.primitive, f.x, f.y);
  return compose(scene, std::move(fragments));
}

Rendering sampled_at_corners(const Scene& scene, const Rendering& exact) {
  return shaded_as(scene, exact, moved(scene, .5, .5));
}

Rendering swapped_colours(const Scene& scene, const Rendering& exact) {
  Scene other = scene;
  for (Draw& draw : other.draws) std::swap(draw.vertices[0].color, draw.vertices[1].color);
  return shaded_as(scene, exact, other);
}

Rendering other_interpolation(const Scene& scene, const Rendering& exact) {
  Scene other = scene;
  for (Draw& draw : other.draws)
    draw.interpolation =
        draw.interpolation == Interpolation::flat ? Interpolation::smooth : Interpolation::flat;
  return shaded_as(scene, exact, other);
}

Rendering wrong_provoking_vertex(const Scene& scene, const Rendering& exact) {
  std::vector<Fragment> fragments = exact.fragments;
  const auto primitives = primitives_of(scene);
  for (Fragment& f : fragments) {
    const Color& first = primitives[static_cast<std::size_t>(f.primitive)].vertices[0]->color;
    std::copy(first.begin(), first.end(), f.color.begin());
  }
  return compose(scene, std::move(fragments));
}

// Each pixel shows the first primitive drawn there.
Rendering earlier_on_top(const Scene& scene, const Rendering& exact) {
  Rendering result = exact;
  for (auto f = exact.fragments.rbegin(); f != exact.fragments.rend(); ++f) {
    const Rendering alone = compose(scene, {*f});
    const std::size_t at = 4 * exact.pixel_index(f->x, f->y);
    std::copy_n(alone.pixels.begin() + static_cast<std::ptrdiff_t>(at), 4,
                result.pixels.begin() + static_cast<std::ptrdiff_t>(at));
  }
  return result;
}

const std::vector<std::string> kSmooth = {"triangle smooth", "line smooth"};
const std::vector<std::string> kFlat = {"triangle", "line x-major", "points", "fan", "sliver"};

constexpr auto kViolation = Verdict::violation;
constexpr auto kPermitted = Verdict::permitted;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

}  // namespace

std::vector<Mutant> value_mutants() {
  const auto ulp = [](Fragment& f) {
    for (double& c : f.color) c = next_float(c);
  };
  return {
      {"colour of the other provoking vertex",
       {"triangle", "line x-major", "shared edge", "fan", "overdraw"},
       wrong_provoking_vertex,
       kViolation,
       "attribute.flat",
       "attribute.provoking-vertex=first"},
      {"smooth colour 1 ULP off", kSmooth, every_fragment(ulp), kPermitted, "attribute.smooth", ""},
      {"one smooth colour 1 ULP off", kSmooth, one_fragment(ulp), kPermitted, "attribute.smooth",
       ""},
      {"flat colour 1 ULP off", kFlat, one_fragment(ulp), kViolation, "attribute.flat", ""},
      {"smooth colour 1e-3 off", kSmooth, one_fragment([](Fragment& f) { f.color[0] += 1e-3; }),
       kViolation, "attribute.smooth", ""},
      {"a smooth constant 1e-3 off", kSmooth, one_fragment([](Fragment& f) { f.color[3] -= 1e-3; }),
       kViolation, "attribute.smooth", ""},
      {"smooth colour without interpolation", kSmooth, every_fragment([](Fragment& f) {
         f.color = {0.3, 0.3, 0.3, 1};
       }),
       kViolation, "attribute.smooth", ""},
      {"smooth colour of the pixel's corner",
       {"triangle smooth"},
       sampled_at_corners,
       kViolation,
       "attribute.smooth",
       ""},
      {"smooth colours of swapped vertices", kSmooth, swapped_colours, kViolation,
       "attribute.smooth", ""},
      {"flat colour where smooth is asked for", kSmooth, other_interpolation, kViolation,
       "attribute.smooth", ""},
      {"smooth colour where flat is asked for",
       {"triangle", "fan", "line short"},
       other_interpolation,
       kViolation,
       "attribute.flat",
       ""},
      {"smooth colour NaN", kSmooth, one_fragment([](Fragment& f) { f.color[1] = kNaN; }),
       kViolation, "attribute.smooth", ""},
      {"flat colour NaN", kFlat, one_fragment([](Fragment& f) { f.color[1] = kNaN; }), kViolation,
       "attribute.flat", ""},
      {"smooth colour infinite", kSmooth, one_fragment([](Fragment& f) { f.color[1] = HUGE_VAL; }),
       kViolation, "attribute.smooth", ""},
      {"depth 1 ULP off",
       {"triangle", "triangle smooth", "line x-major"},
       every_fragment([](Fragment& f) { f.depth = next_float(f.depth); }),
       kPermitted,
       "fragment.depth",
       ""},
      {"depth 1e-2 off",
       {"triangle", "triangle smooth", "line x-major", "points"},
       one_fragment([](Fragment& f) { f.depth += 1e-2; }),
       kViolation,
       "fragment.depth",
       ""},
      {"depth NaN",
       {"triangle", "line 45 degrees", "sliver"},
       one_fragment([](Fragment& f) { f.depth = kNaN; }),
       kViolation,
       "fragment.depth",
       ""},
  };
}

std::vector<Mutant> pixel_mutants() {
  const auto beside = [](int beyond) {
    return one_pixel([=](std::uint8_t* pixel, const Fragment& f) {
      pixel[0] = other_neighbour(f.color[0], beyond);
    });
  };
  const auto ten = one_pixel([](std::uint8_t* pixel, const Fragment&) {
    pixel[1] = static_cast<std::uint8_t>(pixel[1] > 127 ? pixel[1] - 10 : pixel[1] + 10);
  });
  const auto step = one_pixel([](std::uint8_t* pixel, const Fragment&) {
    pixel[3] = static_cast<std::uint8_t>(pixel[3] - 1);
  });
  const auto untouched = [](const Scene&, const Rendering& exact) {
    Rendering result = exact;
    result.pixels[2] = 1;
    return result;
  };
  const auto cleared =
      one_pixel([](std::uint8_t* pixel, const Fragment&) { pixel[0] = pixel[1] = pixel[2] = 0; });
  const std::vector<std::string> touched = {"triangle", "line x-major", "points",
                                            "triangle smooth"};
  return {
      {"pixel at the other neighbour of its colour", kSmooth, beside(0), kPermitted,
       "framebuffer.unorm8", ""},
      {"pixel one beyond both neighbours", kSmooth, beside(1), kViolation, "framebuffer.unorm8",
       ""},
      {"pixel one off a whole step", touched, step, kViolation, "framebuffer.unorm8", ""},
      {"pixel ten off", touched, ten, kViolation, "framebuffer.unorm8", ""},
      {"clear colour one off", {}, untouched, kViolation, "framebuffer.unorm8", ""},
      {"fragment told but not stored", touched, cleared, kViolation, "framebuffer.unorm8", ""},
      {"earlier primitive on top",
       {"overdraw"},
       earlier_on_top,
       kViolation,
       "framebuffer.order",
       ""},
  };
}

}  // namespace edgecase
