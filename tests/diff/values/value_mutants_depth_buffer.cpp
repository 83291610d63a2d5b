// SPDX-License-Identifier: MIT
//
// Wrong gl_FragCoord, and depth buffers that hold something else than the fragments' depths.
#include <cmath>
#include <limits>
#include <utility>

#include "rules/values/framebuffer.h"
#include "tests/diff/values/value_mutants.h"

namespace edgecase {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr auto kViolation = Verdict::violation;
constexpr auto kContested = Verdict::contested;
constexpr auto kPermitted = Verdict::permitted;

const std::vector<std::string> kInteger = {"overdraw depth16", "overdraw depth24",
                                           "smooth triangle"};
const std::vector<std::string> kDepths = {"overdraw depth16", "overdraw depth24",
                                          "overdraw depth32f", "smooth triangle"};
const std::vector<std::string> kOverdraw = {"overdraw depth16", "overdraw depth24",
                                            "overdraw depth32f"};

using Coordinates = std::array<double, 4>;

template <class Change>
FragmentChange coordinates(Change change) {
  return [change](const Scene& scene, Fragment&, FragmentDetail& detail) {
    change(scene, detail.coordinates.value());
  };
}

// A pixel with a fragment, and its last one.
struct Written {
  std::size_t pixel;
  const Fragment* first;
  const Fragment* last;
};

std::vector<Written> written_pixels(const Rendering& rendering) {
  std::vector<Written> result;
  for (const Fragment& f : rendering.fragments) {
    const std::size_t pixel = rendering.pixel_index(f.x, f.y);
    if (result.empty() || result.back().pixel != pixel) result.push_back({pixel, &f, &f});
    result.back().last = &f;
  }
  return result;
}

// Of every pixel that is drawn: `depth_of` the scene and the pixel.
template <class DepthOf>
ValueMutation every_stored(DepthOf depth_of) {
  return [depth_of](const Scene& scene, const Rendering& exact) {
    Rendering result = exact;
    for (const Written& written : written_pixels(exact))
      result.depths[written.pixel] = depth_of(scene, written);
    return result;
  };
}

// The same of the one in the middle.
template <class DepthOf>
ValueMutation one_stored(DepthOf depth_of) {
  return [depth_of](const Scene& scene, const Rendering& exact) {
    Rendering result = exact;
    const auto all = written_pixels(exact);
    const Written& written = all[all.size() / 2];
    result.depths[written.pixel] = depth_of(scene, written);
    return result;
  };
}

double largest_of(const Scene& scene) {
  return std::ldexp(1.0, bits_of(scene.target.depth)) - 1;
}

double truncated(const Scene& scene, const Written& written) {
  return std::floor(written.last->depth * largest_of(scene)) / largest_of(scene);
}
double one_step_further(const Scene& scene, const Written& written) {
  return (std::floor(written.last->depth * largest_of(scene)) - 1) / largest_of(scene);
}
double rounded_up_and_further(const Scene& scene, const Written& written) {
  return (std::ceil(written.last->depth * largest_of(scene)) + 1) / largest_of(scene);
}
double two_steps_further(const Scene& scene, const Written& written) {
  return (std::floor(written.last->depth * largest_of(scene)) - 2) / largest_of(scene);
}
double rounded_up_and_twice_further(const Scene& scene, const Written& written) {
  return (std::ceil(written.last->depth * largest_of(scene)) + 2) / largest_of(scene);
}
double clear_value(const Scene&, const Written&) {
  return 1;
}
double nothing(const Scene&, const Written&) {
  return 0;
}
double not_a_number(const Scene&, const Written&) {
  return kNaN;
}
double of_the_first(const Scene& scene, const Written& written) {
  return to_depth(written.first->depth, scene.target.depth);
}
double of_16_bits(const Scene&, const Written& written) {
  return to_depth(written.last->depth, DepthFormat::depth16);
}
double of_24_bits(const Scene&, const Written& written) {
  return to_depth(written.last->depth, DepthFormat::depth24);
}
// Over 2^bits instead of 2^bits - 1.
double over_a_power_of_two(const Scene& scene, const Written& written) {
  const double steps = largest_of(scene) + 1;
  return std::floor(written.last->depth * steps) / steps;
}
double float_next(const Scene&, const Written& written) {
  return float_above(written.last->depth);
}

Rendering cleared_to_zero(const Scene&, const Rendering& exact) {
  Rendering result = exact;
  result.depths.assign(result.depths.size(), 0);
  for (const Written& written : written_pixels(exact))
    result.depths[written.pixel] = exact.depths[written.pixel];
  return result;
}

Rendering upside_down(const Scene&, const Rendering& exact) {
  Rendering result = exact;
  for (int y = 0; y < exact.height; ++y)
    for (int x = 0; x < exact.width; ++x)
      result.depths[exact.pixel_index(x, y)] =
          exact.depths[exact.pixel_index(x, exact.height - 1 - y)];
  return result;
}

// As a depth test would leave it: the nearest of all fragments of the pixel.
Rendering depth_tested(const Scene& scene, const Rendering& exact) {
  Rendering result = exact;
  result.depths.assign(result.depths.size(), 1);
  for (const Fragment& f : exact.fragments) {
    double& depth = result.depths[exact.pixel_index(f.x, f.y)];
    depth = std::min(depth, to_depth(f.depth, scene.target.depth));
  }
  return result;
}

}  // namespace

std::vector<ValueMutant> coordinate_mutants() {
  const std::vector<std::string> steep = {"smooth triangle", "clip triangle", "smooth line",
                                          "noperspective triangle", "overdraw depth24"};
  // All but the last, of which a line has a w of 1 by its major axis.
  const std::vector<std::string> uneven(steep.begin(), steep.end() - 1);
  const std::vector<std::string> any = {"smooth triangle", "linear line", "points",
                                        "flat triangle_strip first"};
  const auto wrong = [](const char* name, std::vector<std::string> scenes, ValueMutation mutate) {
    return ValueMutant{
        name, std::move(scenes), std::move(mutate), kViolation, {"fragment.coordinates"}};
  };
  const auto all = [](auto change) { return all_fragments(coordinates(change)); };
  const auto one = [](auto change) { return middle_fragment(coordinates(change)); };
  return {
      wrong("gl_FragCoord at the corner", any,
            all([](const Scene&, Coordinates& c) { c[0] -= .5, c[1] -= .5; })),
      wrong("gl_FragCoord of the right neighbour", any,
            all([](const Scene&, Coordinates& c) { c[0] += 1; })),
      wrong("gl_FragCoord of the lower neighbour", any,
            all([](const Scene&, Coordinates& c) { c[1] -= 1; })),
      wrong("one gl_FragCoord.x an ULP off", any,
            one([](const Scene&, Coordinates& c) { c[0] = float_above(c[0]); })),
      wrong("gl_FragCoord upside down", any,
            all([](const Scene& scene, Coordinates& c) { c[1] = scene.target.height - c[1]; })),
      wrong("gl_FragCoord NaN", any, one([](const Scene&, Coordinates& c) { c[1] = kNaN; })),
      wrong("gl_FragCoord.z NaN", any, one([](const Scene&, Coordinates& c) { c[2] = kNaN; })),
      wrong("gl_FragCoord.z of -1 to 1", any,
            all([](const Scene&, Coordinates& c) { c[2] = 2 * c[2] - 1; })),
      wrong("gl_FragCoord.w infinite", any,
            one([](const Scene&, Coordinates& c) { c[3] = HUGE_VAL; })),
      wrong("gl_FragCoord.w is w", steep,
            all([](const Scene&, Coordinates& c) { c[3] = 1 / c[3]; })),
      wrong("gl_FragCoord.w is 1", uneven, all([](const Scene&, Coordinates& c) { c[3] = 1; })),
      wrong("gl_FragCoord.w with perspective", steep,
            all_fragments([](const Scene& scene, Fragment& f, FragmentDetail& detail) {
              Interpolant inverse = exact_attributes(scene, f).inverse_w;
              inverse.perspective = true;
              detail.coordinates.value()[3] =
                  middle(interpolate_exact(inverse, pixel_centre(f.x, f.y)));
            })),
      {"gl_FragCoord.w one ULP off",
       steep,
       all([](const Scene&, Coordinates& c) { c[3] = float_above(c[3]); }),
       kPermitted,
       {},
       {"gl_FragCoord.w"}},
      {"gl_FragCoord.z one ULP off",
       steep,
       one([](const Scene&, Coordinates& c) { c[2] = float_below(c[2]); }),
       kPermitted,
       {},
       {"gl_FragCoord.z"}},
  };
}

std::vector<ValueMutant> depth_buffer_mutants() {
  const auto wrong = [](const char* name, std::vector<std::string> scenes, ValueMutation mutate) {
    return ValueMutant{
        name, std::move(scenes), std::move(mutate), kViolation, {"framebuffer.depth"}};
  };
  const auto disputed = [](const char* name, ValueMutation mutate) {
    return ValueMutant{name, kInteger, std::move(mutate), kContested, {"framebuffer.depth"}};
  };
  return {
      {"stored depths truncated",
       kInteger,
       every_stored(truncated),
       kPermitted,
       {},
       {"depth buffer"}},
      disputed("stored depths one step below both", every_stored(one_step_further)),
      disputed("one stored depth one step above both", one_stored(rounded_up_and_further)),
      wrong("stored depths two steps below both", kInteger, every_stored(two_steps_further)),
      wrong("one stored depth two steps above both", kInteger,
            one_stored(rounded_up_and_twice_further)),
      wrong("one stored depth an ULP off", {"overdraw depth32f"}, one_stored(float_next)),
      wrong("one stored depth is the clear value", kDepths, one_stored(clear_value)),
      wrong("stored depths are the clear value", kDepths, every_stored(clear_value)),
      wrong("stored depths are zero", kDepths, every_stored(nothing)),
      wrong("one stored depth is NaN", kDepths, one_stored(not_a_number)),
      wrong("stored depths of the first fragments", kOverdraw, every_stored(of_the_first)),
      wrong("stored depths of the nearest fragments", kOverdraw, depth_tested),
      {"16 bits in 24",
       {"overdraw depth24", "smooth triangle"},
       every_stored(of_16_bits),
       kViolation,
       {"framebuffer.depth: framebuffer.depth-bits=sixteen"}},
      wrong("16 bits in float32", {"overdraw depth32f"}, every_stored(of_16_bits)),
      wrong("24 bits in float32", {"overdraw depth32f"}, every_stored(of_24_bits)),
      wrong("24 bits in 16", {"overdraw depth16"}, every_stored(of_24_bits)),
      wrong("steps of 2^-bits", kInteger, every_stored(over_a_power_of_two)),
      wrong("cleared to zero", kDepths, cleared_to_zero),
      wrong("stored upside down", kDepths, upside_down),
  };
}

}  // namespace edgecase
