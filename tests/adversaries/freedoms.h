// SPDX-License-Identifier: MIT
//
// What a renderer may choose that OpenGL 4.6 (core, May 5, 2022) leaves open, and by a hair more.
//
// An adversary is a renderer that is legal and as odd as the text lets it be: `edgecase run` may
// not find one violation in all that it draws. Beside each freedom stands a crime, the next thing
// that the text forbids: that must be found. Nothing here asks src/rules or src/diff what is
// permitted.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace edgecase::adversary {

// 2.3.4.1: "individual results of floating-point operations are accurate to about 1 part in 10^5".
enum class Arithmetic {
  exact,     // double
  binary32,  // float32
  low,       // each result is too small by that part
  high,      // too large
  either,    // one or the other, as a hash says
};
// In which order weights, values and sums are computed.
enum class Formula { sums, differences, planes };
// 14, SUBPIXEL_BITS: to which multiple of 2^-bits a vertex is moved, less than one step away.
enum class Snap { nearest, down, up, either };
// 2.3.5.2: "one of the two unsigned binary integer values ... closest". The same number is always
// converted to the same value.
enum class Conversion { nearest, down, up, either };
// 14.5.1: the diamond-exit rule, and what the four rules of its relaxation let differ.
enum class LineWay {
  diamond_exit,
  moved,      // every fragment one unit to the right and up
  sideways,   // one unit down in odd columns (left in odd rows, if y-major)
  one_more,   // a line that is alone draws the pixel after its last one
  one_fewer,  // it lacks its first one
  gap,        // it lacks one in the middle
};
// 8.14.1: from the largest partial derivative to either upper bound.
enum class ScaleFactor { lengths, largest_partial, sum_of_partials, root_two_of_sums };

// The next thing that is forbidden, or "".
using Crime = std::string_view;

struct Freedoms {
  int bits = 16;  // SUBPIXEL_BITS that are told
  Snap snap = Snap::nearest;
  // A sample on an edge is moved by (x e, y e^2), or (x e^2, y e) where y comes first.
  int tie_x = 1, tie_y = -1;
  bool tie_y_first = false;
  bool tie_by_edge = false;           // each edge of a triangle has a tie rule of its own
  bool tie_by_point = false;          // each point owns its boundary or does not
  int guard_band = 1;                 // clip volumes beyond whose sides triangles are cut
  int fan_pivot = 0;                  // of a clipped polygon: 0 the first vertex, else the last
  bool cut_at_viewport = false;       // 14.4.1, 14.5.2.2 (OpenGL-API issue 57): points and lines
  bool draws_points_outside = false;  // 13.7: points whose centre lies beyond the volume's sides
  LineWay line = LineWay::diamond_exit;
  bool halves_down = false;        // widths that end in 1/2
  bool replicates_values = false;  // 14.5.2.2: the preferred method
  Arithmetic arithmetic = Arithmetic::exact;
  Formula formula = Formula::sums;
  bool values_from_snapped = false;
  bool computes_windows = false;  // 13.8.1 is computed for vertices that are given in the window
  Conversion conversion = Conversion::nearest;
  int quad_x = 0, quad_y = 0;      // where quads begin, modulo 2
  bool coarse_plain = false;       // dFdx is dFdxCoarse
  bool analytic = false;           // derivatives by differences of 1/64 pixel
  bool offset_by_partial = false;  // 14.6.5: m by the larger partial derivative
  double offset_unit = 1;          // r, in 2^-n, at least 1
  bool tells_clamped_depths = true;
  // Of samples.
  bool own_pattern = false;         // where a case leaves positions open
  bool coverage_elsewhere = false;  // 14.3.1: sample points that cannot be asked for
  bool shades_each_sample = false;
  bool attributes_anywhere = false;  // within the pixel; centroid: the last sample covered
  bool own_depths = false;      // 17.3.10, where MULTISAMPLE is disabled: of each sample its own
  int alpha_rounding = 0;       // of alpha n: -1 down, 0 nearest, 1 up
  bool dithered_alpha = false;  // 17.3.1: which samples are kept differs by pixel
  bool resolves_down = false;
  // Of textures.
  ScaleFactor scale = ScaleFactor::lengths;
  double level_error = 0;         // of lambda, in 2^-6
  double texel_error = 0;         // of coordinates, in 2^-7 texel
  int weight_bits = 0;            // of levels' weights; 0: all
  bool codes_of_8_bits = false;   // each mean is rounded to 8 bits
  bool decodes_after = false;     // 8.24: sRGB after filtering
  bool clamps_each_bias = false;  // 8.14.1: at 2, before they are added
  bool ties_of_levels_up = false;
  bool takes_sharper_level = false;  // anisotropy: the level of the shorter vector
  bool nearest_mipmaps = false;      // 8.14.4: any filter
  bool blends_in_codes = false;      // 17.3.6.1: "a precision ... no lower than" 8 bits
  bool tells_less = false;           // no levels of detail, mip chains, sample pixels, hits
  Crime crime = "";
};

struct Adversary {
  std::string_view name;
  Freedoms freedoms;
};

// The one of that name; none: null.
const Freedoms* find(std::string_view name);
// Names, a line each.
void print_names();

// Any 64 bits of these, always the same.
constexpr std::uint64_t hash(std::uint64_t a, std::uint64_t b = 0) {
  std::uint64_t h = (a ^ (b * 0x9e3779b97f4a7c15u)) + 0x9e3779b97f4a7c15u;
  h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9u;
  h = (h ^ (h >> 27)) * 0x94d049bb133111ebu;
  return h ^ (h >> 31);
}
std::uint64_t hash_of(double number);

// A number of the adversary's arithmetic: each operation on two of them errs.
struct Real {
  double value = 0;
  Real() = default;
  Real(double number) : value(number) {}  // NOLINT: numbers are given exactly
};
void set_arithmetic(Arithmetic arithmetic);
// What `either` draws from here on.
void seed_errors(std::uint64_t seed);
double rounded(double exact);
// Nothing errs by adding 0 or by 1 as a factor.
inline Real operator+(Real a, Real b) {
  return a.value == 0 || b.value == 0 ? a.value + b.value : rounded(a.value + b.value);
}
inline Real operator-(Real a, Real b) {
  return b.value == 0 ? a : Real(rounded(a.value - b.value));
}
inline Real operator*(Real a, Real b) {
  return a.value == 1 || b.value == 1 ? a.value * b.value : rounded(a.value * b.value);
}
inline Real operator/(Real a, Real b) {
  return b.value == 1 ? a : Real(rounded(a.value / b.value));
}
inline Real operator-(Real a) {
  return -a.value;
}

// 0 to 1, as one of the two nearest multiples of 1/most.
double converted(const Freedoms& freedoms, double number, double most);

}  // namespace edgecase::adversary
