// SPDX-License-Identifier: MIT
#include "raster/texture_level.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include "rules/textures/directed.h"
#include "rules/values/rational_interpolation.h"

namespace edgecase {

namespace {

// From here on neighbouring doubles may lie in different texels.
constexpr int kFar = 1 << 20;
constexpr double kNarrow = 0x1p-40;

bool touches(Interval value, int size, TexelBorders borders) {
  const Interval scaled = value * (static_cast<double>(size) * borders.parts);
  return borders.parts > 0 && std::ceil(scaled.low) <= scaled.high;
}

// An interval wider than rounding accounts for is open as well.
bool is_open(Interval value, TexelBorders borders, std::span<const int> sizes) {
  if (!(value.high - value.low < kNarrow)) return true;
  return std::ranges::any_of(sizes, [&](int size) { return touches(value, size, borders); });
}

// Whether a number belongs below the border that it is next to or on; nothing if it is an even
// multiple and thus no border. The level has `size` texels.
std::optional<bool> is_below_border(const Rational& value, int size, TexelBorders borders) {
  const Rational scaled = value * size * borders.parts;
  if (!borders.ties_to_even || !is_whole(scaled)) return (scaled - floor_of(scaled)) * 2 >= 1;
  if (is_whole(scaled / 2)) return std::nullopt;
  return is_whole((scaled - 1) / 4);
}
std::optional<bool> is_below_border(const MachineQuotient& value, int size, TexelBorders borders) {
  const Int128 scaled = value.above * size * borders.parts;
  Int128 whole = scaled / value.below, rest = scaled % value.below;
  if (rest < 0) {
    rest += value.below;
    --whole;
  }
  if (!borders.ties_to_even || rest != 0) return rest * 2 >= value.below;
  if (whole % 2 == 0) return std::nullopt;
  return (whole - 1) % 4 == 0;
}

bool is_far(const Rational& value) {
  return abs(value) >= kFar;
}
bool is_far(const MachineQuotient& value) {
  return (value.above < 0 ? -value.above : value.above) >= value.below * kFar;
}

const Rational& rational_of(const Rational& value) {
  return value;
}
Rational rational_of(const MachineQuotient& value) {
  return quotient_of(integer_of(value.above), integer_of(value.below));
}

// Without a grid, nearest switches between texels, while linear changes continuously.
TexelBorders borders_of(Filter filter) {
  switch (filter) {
    case Filter::nearest:
      return {1, false};
    case Filter::linear:
      return {0, false};
  }
  return {0, false};
}

}  // namespace

TexelBorders texel_borders(Filter filter, TexelGrid grid, TextureFormat format) {
  switch (grid) {
    case TexelGrid::none:
      return borders_of(filter);
    case TexelGrid::floor_8:
      return {256, false};
    case TexelGrid::nearest_8:
      return {512, false};
    case TexelGrid::linear_even_8:
      return filter == Filter::linear && format == TextureFormat::rgba8 ? TexelBorders{512, true}
                                                                        : borders_of(filter);
  }
  return borders_of(filter);
}

// Repetition has period 1 or, mirrored, 2; clamping is constant from one texel beyond the edge.
Rational TextureAxis::brought_near(const Rational& value) const {
  if (is_periodic(wrap_)) return value - 2 * floor_of(value / 2);
  return value < 0 ? Rational(-1) : Rational(2);
}

// A double is returned unchanged. Any other number lies between two doubles, possibly with a border
// between them; the double on its side of the border is returned.
template <class Number>
Interval TextureAxis::decided(const Number& value, TexelBorders borders,
                              std::span<const int> sizes) const {
  const Interval narrow = interval_of(value);
  if (narrow.low == narrow.high) return narrow;
  if (is_far(value)) return decided(brought_near(rational_of(value)), borders, sizes);
  for (const int size : sizes) {
    if (!touches(narrow, size, borders)) continue;
    const std::optional<bool> is_below = is_below_border(value, size, borders);
    if (is_below) return *is_below ? narrow.low : narrow.high;
  }
  return narrow;
}

Interval TextureAxis::place(Point sample, Interval value, TexelBorders borders,
                            std::span<const int> sizes, const Rational& further) {
  const Interval narrow = exact_sum(value, interval_of(further));
  if (!is_open(narrow, borders, sizes) || !rational()) return narrow;
  const std::optional<Rational> exact = rational()->at(sample);
  return exact ? decided(*exact + further, borders, sizes) : narrow;
}

Interval TextureAxis::place(Point sample, Interval value, TexelBorders borders,
                            std::span<const int> sizes) {
  const Interval narrow = exact_sum(value, 0);
  if (!is_open(narrow, borders, sizes) || !rational()) return narrow;
  if (const auto quotient = rational()->quotient_at(sample))
    return decided(*quotient, borders, sizes);
  const std::optional<Rational> exact = rational()->at(sample);
  return exact ? decided(*exact, borders, sizes) : narrow;
}

std::optional<Rational> TextureAxis::derivative(const QuadPixel& at, Axis axis,
                                                DerivativeMethod method) {
  return rational() ? rational()->derivative(at, axis, method) : std::nullopt;
}

namespace {

using Vector = std::array<Rational, 2>;

Rational squared_length(const Vector& v) {
  return v[0] * v[0] + v[1] * v[1];
}

Rational square(const Rational& value) {
  return value * value;
}

// The longer vector, by its squared length.
const Rational& longer(const Rational& a, const Rational& b) {
  return a < b ? b : a;
}

// The number of borders from one level to the next: at halves for the nearest level and the
// crossover, and at finer steps for weights rounded to 8 bits or fewer.
double borders_per_level(LevelWeight weight) {
  const bool is_continuous = weight == LevelWeight::exact || weight == LevelWeight::narrow ||
                             weight == LevelWeight::one_at_ties;
  return is_continuous ? 2 : 512;
}

// The first border in the interval; nothing if there is none or the interval is not finite.
std::optional<double> border_in(Interval value, LevelWeight weight) {
  if (!std::isfinite(value.low) || !std::isfinite(value.high)) return std::nullopt;
  const double per_level = borders_per_level(weight);
  const double border = std::ceil(value.low * per_level) / per_level;
  if (border > value.high) return std::nullopt;
  return border;
}

// The square of the scale factor whose logarithm is `base`; nothing if it is irrational.
std::optional<Rational> squared_power(const Rational& base, Log2Method method) {
  const Rational doubled = base * 2;
  switch (method) {
    case Log2Method::linear_mantissa: {
      const Integer exponent = floor_of(base);
      return square(power_of_two(static_cast<int>(exponent)) * (1 + base - exponent));
    }
    case Log2Method::linear_mantissa_of_square: {
      const Integer exponent = floor_of(doubled);
      return power_of_two(static_cast<int>(exponent)) * (1 + doubled - exponent);
    }
    case Log2Method::exact:
    case Log2Method::linear_mantissa_of_fourth_power:
    case Log2Method::mantissa_8:
      break;
  }
  if (!is_whole(doubled)) return std::nullopt;
  return power_of_two(static_cast<int>(numerator(doubled)));
}

}  // namespace

RationalFootprint in_texels(const RationalFootprint& given, int width, int height) {
  RationalFootprint result = given;
  for (Vector* v : {&result.dx, &result.dy}) {
    (*v)[0] *= width;
    (*v)[1] *= height;
  }
  return result;
}

Footprint intervals_of(const RationalFootprint& f) {
  return {{interval_of(f.dx[0]), interval_of(f.dx[1])},
          {interval_of(f.dy[0]), interval_of(f.dy[1])},
          f.dimensions};
}

Rational squared_scale_factor(const RationalFootprint& f, ScaleFactor method) {
  const Rational u_x = abs(f.dx[0]), v_x = abs(f.dx[1]);
  const Rational u_y = abs(f.dy[0]), v_y = abs(f.dy[1]);
  const Rational m_u = std::max(u_x, u_y), m_v = std::max(v_x, v_y);
  switch (method) {
    case ScaleFactor::lengths:
      return longer(squared_length(f.dx), squared_length(f.dy));
    case ScaleFactor::largest_partial:
      return square(std::max(m_u, m_v));
    case ScaleFactor::sum_of_partials:
      return square(m_u + m_v);
    case ScaleFactor::length_of_sum:
      return squared_length({f.dx[0] + f.dy[0], f.dx[1] + f.dy[1]});
    case ScaleFactor::length_of_both:
      return squared_length(f.dx) + squared_length(f.dy);
    case ScaleFactor::sum:
      return square(u_x + v_x + u_y + v_y);
    case ScaleFactor::x_only:
      return squared_length(f.dx);
    case ScaleFactor::y_only:
      return squared_length(f.dy);
  }
  return 0;
}

bool has_no_extent(const std::array<Interpolant, 2>& coordinates, const QuadPixel& at,
                   int dimensions, const TextureChoice& choice) {
  RationalFootprint footprint{{}, {}, dimensions};
  for (std::size_t c = 0; c < static_cast<std::size_t>(dimensions); ++c) {
    const auto x = derivative_rational(coordinates[c], at, Axis::x, choice.derivatives);
    const auto y = derivative_rational(coordinates[c], at, Axis::y, choice.derivatives);
    if (!x || !y) return false;
    footprint.dx[c] = *x;
    footprint.dy[c] = *y;
  }
  return squared_scale_factor(footprint, choice.scale_factor) == 0;
}

bool is_anisotropic(const Sampler& sampler, const TextureChoice& choice) {
  return sampler.max_anisotropy > 1 && choice.anisotropy != Anisotropy::none;
}

ProbeRow exact_probes(const RationalFootprint& f, const Sampler& sampler,
                      const TextureChoice& choice) {
  const auto row_of = [&](float most) {
    return probes(intervals_of(f), most, choice.anisotropy, choice.scale_factor);
  };
  const ProbeRow row = row_of(sampler.max_anisotropy);
  if (choice.anisotropy != Anisotropy::extension || row.probes.size() < 2) return row;
  // With rounded lengths the quotient may exceed the whole number that it should be and add a
  // needless probe. At most one probe has to go.
  const auto fewer = static_cast<int>(row.probes.size()) - 1;
  const Rational x = squared_length(f.dx), y = squared_length(f.dy);
  if (std::max(x, y) != std::min(x, y) * fewer * fewer) return row;
  ProbeRow result = row_of(static_cast<float>(fewer));
  result.scale_factor = row.scale_factor * static_cast<double>(fewer + 1) / fewer;
  return result;
}

std::vector<std::array<Rational, 2>> ways_to(const ProbeRow& row, const RationalFootprint& f,
                                             Anisotropy choice) {
  // Offsets are multiples of 1/5, or of half of 1/(N + 1).
  const int parts =
      choice == Anisotropy::gaussian_5 ? 5 : 2 * static_cast<int>(row.probes.size()) + 2;
  const Vector& along = row.along_x ? f.dx : f.dy;
  std::vector<Vector> ways;
  for (const Probe& probe : row.probes) {
    const Rational offset(static_cast<int>(std::lround(probe.offset * parts)), parts);
    ways.push_back({along[0] * offset, along[1] * offset});
  }
  return ways;
}

Rational squared_scale_factor(const RationalFootprint& f, const ProbeRow& row,
                              const Sampler& sampler, const TextureChoice& choice) {
  if (!is_anisotropic(sampler, choice)) return squared_scale_factor(f, choice.scale_factor);
  const Rational x = squared_length(f.dx), y = squared_length(f.dy);
  const Rational most = std::max(x, y), least = std::min(x, y);
  if (choice.anisotropy == Anisotropy::gaussian_5) return std::max(least, Rational(most / 25));
  const auto count = static_cast<int>(row.probes.size());
  return most / (count * count);
}

bool is_level_open(Interval lambda_prime, LevelWeight weight) {
  return border_in(lambda_prime, weight).has_value();
}

Interval decided_level(Interval prime, const Rational& squared, Interval bias, Log2Method log2,
                       LevelWeight weight) {
  // A step of a table may end exactly on a border.
  if (prime.low == prime.high) return prime;
  const std::optional<double> border = border_in(prime, weight);
  if (!border) return prime;
  // If the bias is not a double, its distance from every border is not one either.
  const std::optional<Rational> there =
      bias.low == bias.high ? squared_power(rational_of(*border) - rational_of(bias.low), log2)
                            : std::nullopt;
  if (there && squared == *there) return *border;
  const bool is_below = there ? squared < *there : prime.low / 2 + prime.high / 2 < *border;
  return is_below ? Interval(std::min(prime.low, next_below(*border)), next_below(*border))
                  : Interval(next_above(*border), std::max(prime.high, next_above(*border)));
}

}  // namespace edgecase
