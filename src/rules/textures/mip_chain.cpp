// SPDX-License-Identifier: MIT
#include "rules/textures/mip_chain.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "exact/elementary.h"

namespace edgecase {
namespace {

// Neighbouring texels of the larger image along an axis, and their whole weights.
struct Taps {
  int first = 0;
  TwoWeights weights{1, 0};
};

// In texels of the larger image the centre of texel i is (i + 1/2) size/halved; less 1/2, that is
// ((2i + 1) size - halved)/(2 halved).
Taps centre_taps(int i, int size, int halved) {
  const int centre = (2 * i + 1) * size - halved;
  const int weight = centre % (2 * halved);
  return {centre / (2 * halved), {2 * halved - weight, weight}};
}

// For texel i of the smaller image.
Taps taps_of(int i, int size, MipmapFilter filter) {
  if (size == 1) return {};
  switch (filter) {
    case MipmapFilter::box:
      return {2 * i, {1, 1}};
    case MipmapFilter::bilinear_centre:
      return centre_taps(i, size, size / 2);
    case MipmapFilter::nearest:
      return {2 * i, {1, 0}};
  }
  return {};
}

// The texels that make one texel of the smaller image: two from each of two rows. A texel without
// weight may lie outside the image, and is replaced by the first.
class Footing {
 public:
  Footing(const TextureLevel& level, Taps columns, Taps rows) : columns_(columns), rows_(rows) {
    for (std::size_t j = 0; j < 2; ++j)
      for (std::size_t i = 0; i < 2; ++i)
        indices_[2 * j + i] = level.index(texel_of(columns, i), texel_of(rows, j));
  }

  float mean(const TextureLevel& level, TextureFormat format, std::size_t component,
             const MipmapMethod& method) const {
    std::array<float, 4> values;
    for (std::size_t i = 0; i < 4; ++i) values[i] = level.texels[indices_[i] + component];
    constexpr std::size_t kAlpha = 3;
    const bool by_rows = method.rounding == MipmapRounding::half_up_by_rows;
    const MipmapRounding rounding = by_rows ? MipmapRounding::nearest_even : method.rounding;
    if (holds_floats(format)) return weighted(values, mean_of_floats, rounding);
    if (format == TextureFormat::srgb8 && method.srgb == MipmapSrgb::linear)
      return weighted(values, component == kAlpha ? mean_of_codes : mean_of_srgb, rounding);
    if (by_rows) return mean_of_rows(values, columns_.weights, rows_.weights);
    return weighted(values, mean_of_codes, rounding);
  }

 private:
  static int texel_of(const Taps& taps, std::size_t which) {
    return taps.first + (which == 1 && taps.weights[1] != 0 ? 1 : 0);
  }

  float weighted(const std::array<float, 4>& values, float (*rule)(WeightedNumbers, MipmapRounding),
                 MipmapRounding rounding) const {
    std::array<WeightedNumber, 4> numbers;
    std::size_t count = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const int weight = columns_.weights[i % 2] * rows_.weights[i / 2];
      if (weight != 0) numbers[count++] = {values[i], weight};
    }
    return rule({numbers.data(), count}, rounding);
  }

  Taps columns_;
  Taps rows_;
  std::array<std::size_t, 4> indices_{};
};

}  // namespace

int levels_of_chain(int width, int height, LevelCount choice) {
  if (choice == LevelCount::larger_side) return level_count(width, height);
  const int smaller = std::min(width, height);
  return level_count(smaller, smaller);
}

TextureLevel reduced(const TextureLevel& level, TextureFormat format, const MipmapMethod& method) {
  TextureLevel result{level_size(level.width, 1), level_size(level.height, 1), {}};
  for (int j = 0; j < result.height; ++j)
    for (int i = 0; i < result.width; ++i) {
      const Footing footing(level, taps_of(i, level.width, method.filter),
                            taps_of(j, level.height, method.filter));
      for (std::size_t k = 0; k < 4; ++k)
        result.texels.push_back(footing.mean(level, format, k, method));
    }
  return result;
}

std::vector<TextureLevel> mip_chain(const TextureLevel& base, TextureFormat format,
                                    LevelCount count, const MipmapMethod& method) {
  std::vector<TextureLevel> chain = {base};
  const auto levels = static_cast<std::size_t>(levels_of_chain(base.width, base.height, count));
  while (chain.size() < levels) chain.push_back(reduced(chain.back(), format, method));
  return chain;
}

Rule level_count_rule() {
  return {RuleId::mipmap_level_count,
          "A mip chain goes down to one texel",
          "8.14.3 (mipmapping)",
          "none (ruling 25)",
          "larger-side",
          alternatives_of<LevelCount>(),
          {}};
}

Rule mipmap_filter_rule() {
  return {
      RuleId::mipmap_filter,
      "A generated level is a filtered reduction of the one before",
      "8.14.4 (manual mipmap generation)",
      "any filter; a box filter is recommended (rulings 25 and 48)",
      "box",
      alternatives_of<MipmapFilter>(),
      {{25,
        "Generated mip chains: the number of levels and their sizes can be wrong, and so can "
        "level 0, which is given and stays. OpenGL leaves the filter open, and with it rounding "
        "and whether sRGB texels are decoded before they are averaged. But levels are filtered "
        "reductions of the image: a component that is the same in all of level 0 stays the same, "
        "and a texel has to do with those of the level above that its area covers and with the "
        "next two on each side. It leaves what lies between the least and the largest of these "
        "by their difference at most, since cubic and Lanczos filters, whose weights may be "
        "negative, lead no further. All of this is meant within one code of 8 bits or 1 part in "
        "10^5."},
       {kRulingOnMipHull,
        "Contested: a texel of a generated level does not lie between the least and the largest of "
        "the texels of the level above that lie at most half a texel of its own beyond its area, "
        "within one code of 8 bits or 1 part in 10^5. 8.14.4 computes levels by filtered "
        "reduction, and no mean of these texels leads there. But wide filters and those with "
        "negative weights do, and 8.14.4 requires no particular filter; OpenGL ES 3.2 says the "
        "same. The Khronos tests (dEQP-GLES3.functional.texture.mipmap.2d.generate.*) fail such a "
        "texel. It is a violation (ruling 25) where it leaves the range of the texels that its "
        "area covers and of the next two on each side by more than their difference."}}};
}

Rule mipmap_rounding_rule() {
  return {RuleId::mipmap_rounding,
          "Texels of a generated level are rounded to the texture's format",
          "8.14.4 (manual mipmap generation)",
          "any rounding (ruling 25)",
          "nearest-even",
          alternatives_of<MipmapRounding>(),
          {}};
}

Rule mipmap_srgb_rule() {
  return {RuleId::mipmap_srgb,
          "sRGB texels are averaged as light",
          "8.14.4 (manual mipmap generation) and 8.24 (sRGB texture color conversion)",
          "whether texels are decoded before they are averaged (ruling 25)",
          "linear",
          alternatives_of<MipmapSrgb>(),
          {}};
}

namespace {

bool all_equal(WeightedNumbers numbers) {
  return std::all_of(numbers.begin(), numbers.end(),
                     [&](WeightedNumber n) { return n.value == numbers[0].value; });
}

// Clamped to the codes, whatever a renderer may report of its levels.
int code_of(float stored) {
  return stored > 0 ? static_cast<int>(std::min(stored, 255.0F)) : 0;
}

std::int64_t total_weight(WeightedNumbers numbers) {
  std::int64_t total = 0;
  for (const WeightedNumber& number : numbers) total += number.weight;
  return total;
}

// A quotient of 0 or more by more than 0.
std::int64_t rounded_quotient(std::int64_t dividend, std::int64_t divisor,
                              MipmapRounding rounding) {
  const std::int64_t below = dividend / divisor;
  const std::int64_t rest = 2 * (dividend % divisor);
  switch (rounding) {
    case MipmapRounding::nearest_even:
      return below + (rest > divisor || (rest == divisor && below % 2 != 0) ? 1 : 0);
    case MipmapRounding::half_up:
    case MipmapRounding::half_up_by_rows:
      return below + (rest >= divisor ? 1 : 0);
    case MipmapRounding::down:
      return below;
  }
  return below;
}

// The share of the second in 256, and the mean of two codes by it, rounded half up.
int share_of_second(TwoWeights weights) {
  return static_cast<int>(rounded_quotient(std::int64_t{256} * weights[1], weights[0] + weights[1],
                                           MipmapRounding::nearest_even));
}

int between(int first, int second, int share) {
  return first + (((second - first) * share + 128) >> 8);
}

// The linear number of half an sRGB code, h/2/255, by rules/textures/texture_image.h. Relative
// error less than 2^-61: the quotient's and the exponent's, 2.4 half units of 2^-63 each, and one
// unit of the C library's powl.
long double linear_of(int half_codes) {
  constexpr int kLastOfLine = 20;
  if (half_codes <= kLastOfLine) return 2.5L * static_cast<long double>(half_codes) / 16473;
  return raised((20 * static_cast<long double>(half_codes) + 561) / 10761, 2.4L);
}

// The linear numbers of N codes, each a whole one further, starting at half of `half_codes`.
template <std::size_t N>
std::array<long double, N> linear_numbers(int half_codes) {
  std::array<long double, N> numbers;
  for (std::size_t k = 0; k < N; ++k) numbers[k] = linear_of(2 * static_cast<int>(k) + half_codes);
  return numbers;
}

// The code of a linear number: the number of borders between codes that it has reached.
std::ptrdiff_t srgb_code_of(long double linear, MipmapRounding rounding) {
  static const auto kWhole = linear_numbers<255>(2);
  static const auto kHalf = linear_numbers<255>(1);
  const auto& borders = rounding == MipmapRounding::down ? kWhole : kHalf;
  return std::upper_bound(borders.begin(), borders.end(), linear) - borders.begin();
}

// The linear number of a code if it is rational, in units of 1/16473: five times a code on the
// curve's straight piece, and 255. -1 for other codes.
std::int64_t rational_linear(int code) {
  constexpr int kLastOfLine = 10;
  if (code == 255) return 16473;
  return code <= kLastOfLine ? 5 * std::int64_t{code} : -1;
}

// The exact sum of up to ten doubles: parts that do not overlap, the smallest first (Shewchuk,
// "Adaptive precision floating-point arithmetic", 1997, theorem 10).
class ExactSum {
 public:
  void add(double value) {
    for (std::size_t i = 0; i < count_; ++i) {
      const double sum = value + parts_[i];
      const double part = sum - value;
      parts_[i] = (value - (sum - part)) + (parts_[i] - part);
      value = sum;
    }
    parts_[count_++] = value;
  }

  // Accurate to a few units in the last place.
  double estimate() const {
    double sum = 0;
    for (std::size_t i = 0; i < count_; ++i) sum += parts_[i];
    return sum;
  }

  // The sign of the largest part, which outweighs the rest.
  int sign() const {
    for (std::size_t i = count_; i > 0; --i)
      if (parts_[i - 1] != 0) return parts_[i - 1] > 0 ? 1 : -1;
    return 0;
  }

 private:
  std::array<double, 10> parts_{};
  std::size_t count_ = 0;
};

// An exact quotient that can be compared with numbers of up to 26 bits: their products with the
// divisor are exact.
struct ExactQuotient {
  ExactSum dividend;
  double divisor;

  // The sign of the quotient less `value`.
  int compare(double value) const {
    ExactSum difference = dividend;
    difference.add(-divisor * value);
    return difference.sign();
  }
};

float next_float(float value, bool up) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  return std::nextafter(value, up ? kInfinity : -kInfinity);
}

float rounded_float(const ExactQuotient& quotient, MipmapRounding rounding) {
  // The float32 number nearest to the estimate is the quotient or one of the two beside it.
  auto below = static_cast<float>(quotient.dividend.estimate() / quotient.divisor);
  if (quotient.compare(static_cast<double>(below)) < 0) below = next_float(below, false);
  if (rounding == MipmapRounding::down) return below;
  const float above = next_float(below, true);
  const int side = quotient.compare((static_cast<double>(below) + static_cast<double>(above)) / 2);
  if (side != 0) return side > 0 ? above : below;
  const bool below_is_even = std::bit_cast<std::uint32_t>(below) % 2 == 0;
  return rounding == MipmapRounding::nearest_even && below_is_even ? below : above;
}

}  // namespace

float mean_of_codes(WeightedNumbers numbers, MipmapRounding rounding) {
  std::int64_t sum = 0;
  for (const WeightedNumber& number : numbers) sum += number.weight * code_of(number.value);
  return static_cast<float>(rounded_quotient(sum, total_weight(numbers), rounding));
}

float mean_of_rows(const std::array<float, 4>& codes, TwoWeights columns, TwoWeights rows) {
  const auto code = [&](std::size_t i) { return code_of(codes[i]); };
  const int share = share_of_second(columns);
  return static_cast<float>(between(between(code(0), code(1), share),
                                    between(code(2), code(3), share), share_of_second(rows)));
}

// A mean on a border between two codes is rational, or all codes are equal: apart from 0 to 10 and
// 255 the linear numbers are fifth roots, and no two of them or of the borders are rational
// multiples of one another, so no sum of them equals another one. Rational means up to code 10 are
// rounded in integers. All others lie beside a border; a search found how close a mean of four
// codes of equal weight comes: 2^-36 of itself. With other weights, a mean closer than 2^-60 would
// be rounded as its long double is.
float mean_of_srgb(WeightedNumbers numbers, MipmapRounding rounding) {
  if (all_equal(numbers)) return static_cast<float>(code_of(numbers[0].value));
  static const auto kLinear = linear_numbers<256>(0);
  const std::int64_t total = total_weight(numbers);
  std::int64_t rational_sum = 0;
  long double sum = 0;
  bool is_rational = true;
  for (const auto& [value, weight] : numbers) {
    const int code = code_of(value);
    is_rational = is_rational && rational_linear(code) >= 0;
    rational_sum += weight * rational_linear(code);
    sum += static_cast<long double>(weight) * kLinear[static_cast<std::size_t>(code)];
  }
  // A mean up to code 10 is on the straight piece, which ends before 10.5.
  if (is_rational && rational_sum <= 5 * 10 * total)
    return static_cast<float>(rounded_quotient(rational_sum, 5 * total, rounding));
  return static_cast<float>(srgb_code_of(sum / static_cast<long double>(total), rounding));
}

float mean_of_floats(WeightedNumbers numbers, MipmapRounding rounding) {
  if (all_equal(numbers)) return numbers[0].value;
  ExactQuotient quotient{{}, static_cast<double>(total_weight(numbers))};
  double plain_sum = 0;
  for (const auto& [value, weight] : numbers) {
    const double product = static_cast<double>(weight) * static_cast<double>(value);
    quotient.dividend.add(product);
    plain_sum += product;
  }
  if (!std::isfinite(plain_sum)) return static_cast<float>(plain_sum);
  return rounded_float(quotient, rounding);
}

}  // namespace edgecase
