// SPDX-License-Identifier: MIT
//
// Filters within a level, held against a literal one in rationals on random inputs, and lookups of
// intervals against those of points in them.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <vector>

#include "rules/textures/texel_filter.h"
#include "tests/rules/textures/texels.h"
#include "tests/support/share.h"

namespace edgecase {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// Of exact colours: a coordinate of up to 64 texels is rounded by up to 2^-47, and neighbouring
// texels differ by up to 8; and so along both axes.
constexpr double kWidest = 0x1p-43;

class Inputs {
 public:
  explicit Inputs(unsigned seed) : random_(seed) {}

  int whole(int least, int most) { return std::uniform_int_distribution(least, most)(random_); }
  double real(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }

  // Anywhere, and more often where something changes.
  double coordinate(int size) {
    switch (whole(0, 9)) {
      case 0:  // centres and borders, and what is next to them in double or single precision
        return static_cast<double>(static_cast<float>(whole(-6 * size, 6 * size) / (2.0 * size)));
      case 1:
        return std::nextafter(whole(-6 * size, 6 * size) / (2.0 * size), real(-9, 9));
      case 2:
        return whole(-2000, 2000) / 512.0;
      case 3:
        return std::ldexp(real(-1, 1), whole(-1070, 1023));
      case 4:
        return static_cast<double>(static_cast<float>(real(-3, 4)));
      case 5: {
        constexpr double kOdd[] = {kInfinity, -kInfinity, kNaN,   1e300,   -1e300,
                                   0.0,       -0.0,       5e-324, -5e-324, 0x1p53};
        return kOdd[whole(0, 9)];
      }
      default:
        return real(-3, 4);
    }
  }

  DecodedLevel level(TextureFormat format) {
    return decode(random_level(random_, whole(1, 9), whole(1, 9), format), format);
  }

  template <class Value, std::size_t N>
  Value one_of(const Value (&values)[N]) {
    return values[whole(0, static_cast<int>(N) - 1)];
  }

 private:
  std::mt19937 random_;
};

constexpr TextureFormat kFormats[] = {TextureFormat::rgba8, TextureFormat::srgb8,
                                      TextureFormat::rgba32f};
constexpr Filter kFilters[] = {Filter::nearest, Filter::linear};

// The same level serves some lookups.
struct Situation {
  TextureFormat format;
  DecodedLevel level;
  std::array<Wrap, 2> wrap;
  std::array<float, 4> border;
  Filter filter;
};

Situation situation(Inputs& inputs) {
  const TextureFormat format = inputs.one_of(kFormats);
  return {format,
          inputs.level(format),
          {inputs.one_of(kAllWraps), inputs.one_of(kAllWraps)},
          {static_cast<float>(inputs.real(-1, 2)), 0, 1, static_cast<float>(inputs.real(0, 1))},
          inputs.one_of(kFilters)};
}

Rational defined(double coordinate) {
  return std::isfinite(coordinate) ? Rational(coordinate) : Rational(0);
}

TEST(Points, YieldWhatALiteralFilterYields) {
  Inputs inputs(static_cast<unsigned>(share_seed(1)));
  int lookups = 0;
  const int rounds = share_of(5000, 500);
  for (int round = 0; round < rounds; ++round) {
    const Situation at = situation(inputs);
    const Texel border = decode_border(at.border, at.format);
    for (int i = 0; i < 20; ++i, ++lookups) {
      const double s = inputs.coordinate(at.level.width);
      const double t = inputs.coordinate(at.level.height);
      const auto boxes =
          filter_level(at.level, 2, at.format, at.filter, {s, t}, {at.wrap, at.border});
      ASSERT_EQ(boxes.size(), 1U) << s << " " << t;
      const auto columns = literal_taps(defined(s), at.level.width, at.wrap[0], at.filter);
      const auto rows = literal_taps(defined(t), at.level.height, at.wrap[1], at.filter);
      const auto component = static_cast<std::size_t>(inputs.whole(0, 3));
      const auto exact = literal_lookup(at.level, border, columns, rows, component);
      const Interval found = boxes[0][component];
      ASSERT_LE(Rational(found.low), exact.first) << s << " " << t;
      ASSERT_GE(Rational(found.high), exact.second) << s << " " << t;
      ASSERT_LE(found.high - found.low, kWidest) << s << " " << t;
    }
  }
  EXPECT_EQ(lookups, 20 * rounds);
}

Rational on_literal_grid(const Rational& u, TexelGrid grid) {
  const Rational steps = u * 256;
  if (grid == TexelGrid::floor_8) return Rational(floor_of(steps)) / 256;
  Integer nearest = floor_of(steps + Rational(1, 2));
  const bool is_tie = nearest - steps == Rational(1, 2);
  if (grid == TexelGrid::linear_even_8 && is_tie && nearest % 2 != 0) --nearest;
  return Rational(nearest) / 256;
}

// On a grid, of coordinates that are exact in texels.
TEST(PointsOnAGrid, YieldWhatALiteralFilterYields) {
  Inputs inputs(2);
  for (int round = 0; round < 2000; ++round) {
    const Situation at = situation(inputs);
    const Texel border = decode_border(at.border, at.format);
    for (int i = 0; i < 12; ++i) {
      TexelLookup lookup{at.wrap, at.border};
      lookup.grid = values_of<TexelGrid>()[static_cast<std::size_t>(1 + i % 3)];
      const bool is_free = lookup.grid == TexelGrid::linear_even_8 &&
                           (at.filter == Filter::nearest || at.format != TextureFormat::rgba8);
      const auto s = static_cast<float>(inputs.real(-3, 4));
      const auto t = static_cast<float>(inputs.whole(-2000, 2000) / 1024.0);
      const auto taps = [&](float coordinate, int size, Wrap wrap) {
        const Rational u = Rational(static_cast<double>(coordinate)) * size;
        return literal_taps((is_free ? u : on_literal_grid(u, lookup.grid)) / size, size, wrap,
                            at.filter);
      };
      const auto boxes = filter_level(at.level, 2, at.format, at.filter, {s, t}, lookup);
      ASSERT_EQ(boxes.size(), 1U);
      const auto exact = literal_lookup(at.level, border, taps(s, at.level.width, at.wrap[0]),
                                        taps(t, at.level.height, at.wrap[1]), 1);
      ASSERT_LE(Rational(boxes[0][1].low), exact.first);
      ASSERT_GE(Rational(boxes[0][1].high), exact.second);
      ASSERT_LE(boxes[0][1].high - boxes[0][1].low, kWidest);
    }
  }
}

// A point's own box is a little wider than its colour, so that it may reach out of one.
bool one_meets(const Texels& boxes, const Texel& colour) {
  return std::any_of(boxes.begin(), boxes.end(),
                     [&](const Texel& box) { return meets(box, colour); });
}

TEST(Intervals, HoldWhatTheirPointsYield) {
  Inputs inputs(3);
  for (int round = 0; round < 4000; ++round) {
    const Situation at = situation(inputs);
    TexelLookup lookup{at.wrap, at.border};
    lookup.grid = values_of<TexelGrid>()[static_cast<std::size_t>(inputs.whole(0, 3))];
    lookup.choice = inputs.whole(0, 1) == 0 ? WrapChoice::as_set : WrapChoice::mirrored_as_repeat;
    const TexelLookup exact_lookup = lookup;
    if (inputs.whole(0, 1) == 0) lookup.slack = std::ldexp(1, inputs.whole(-12, 3));
    const auto range = [&](int size) {
      const double from = inputs.coordinate(size);
      if (!std::isfinite(from)) return Interval(-2, kInfinity);
      return Interval(from, from + std::ldexp(inputs.real(0, 1), inputs.whole(-50, 2)));
    };
    const Interval s = range(at.level.width);
    const Interval t = range(at.level.height);
    const auto boxes = filter_level(at.level, 2, at.format, at.filter, {s, t}, lookup);
    const auto somewhere = [&](Interval in, int size) {
      const double high = std::min(in.high, in.low + 10);
      const double off = inputs.real(-0.999, 0.999) * lookup.slack / size;
      switch (inputs.whole(0, 3)) {
        case 0:
          return in.low + off;
        case 1:
          return high + off;
        default:
          return std::clamp(inputs.real(in.low, std::nextafter(high, kInfinity)), in.low, high) +
                 off;
      }
    };
    for (int i = 0; i < 25; ++i) {
      const TexturePoint point{somewhere(s, at.level.width), somewhere(t, at.level.height)};
      const auto colour = filter_level(at.level, 2, at.format, at.filter, point, exact_lookup);
      ASSERT_EQ(colour.size(), 1U);
      ASSERT_TRUE(one_meets(boxes, colour[0]))
          << s.low << ".." << s.high << ", " << t.low << ".." << t.high << ": " << point.s.low
          << ", " << point.t.low;
    }
  }
}

// Nearest: the texels from that of the low end to that of the high end, and no others.
TEST(Intervals, YieldNoOtherTexels) {
  Inputs inputs(4);
  for (int round = 0; round < 5000; ++round) {
    const int size = inputs.whole(1, 9);
    const Wrap wrap = inputs.one_of(kAllWraps);
    const Interval s = {inputs.whole(-60, 60) / 16.0, 0};
    const Interval range(s.low, s.low + inputs.whole(0, 64) / 16.0);
    const std::array<Wrap, 2> wraps{wrap, Wrap::repeat};
    const std::array<float, 4> border{-1, 0, 0, 0};
    const auto boxes = filter_level(numbered(size, 1), 1, TextureFormat::rgba32f, Filter::nearest,
                                    {range, 0}, {wraps, border});
    std::set<double> expected;
    for (Integer k = floor_of(Rational(range.low) * size); k <= Rational(range.high) * size; ++k)
      expected.insert(literal_wrap(k, size, wrap));
    std::set<double> found;
    for (const Texel& box : boxes) found.insert(box[0].low);
    ASSERT_EQ(found, expected) << range.low << " " << range.high << " of " << size;
    ASSERT_EQ(boxes.size(), expected.size());
  }
}

// Linear: within one quad, a box is as wide as its corners' colours and no wider.
TEST(Intervals, OfAQuadAreBoundedByItsCorners) {
  Inputs inputs(5);
  const std::array<Wrap, 2> wrap{Wrap::repeat, Wrap::mirrored_repeat};
  const std::array<float, 4> border{};
  for (int round = 0; round < 2000; ++round) {
    const DecodedLevel level = inputs.level(TextureFormat::rgba32f);
    const auto within_quad = [&](int size) {
      const int first = inputs.whole(-9, 9);
      const double a = inputs.real(0.01, 0.99);
      const double b = inputs.real(0.01, 0.99);
      return Interval((first + 0.5 + std::min(a, b)) / size, (first + 0.5 + std::max(a, b)) / size);
    };
    const TexturePoint range{within_quad(level.width), within_quad(level.height)};
    const auto look_up = [&](Interval s, Interval t) {
      return filter_level(level, 2, TextureFormat::rgba32f, Filter::linear, {s, t}, {wrap, border});
    };
    const auto boxes = look_up(range.s, range.t);
    ASSERT_EQ(boxes.size(), 1U);
    Interval corners{kInfinity, -kInfinity};
    for (const double s : {range.s.low, range.s.high})
      for (const double t : {range.t.low, range.t.high})
        corners = hull(corners, look_up(s, t).at(0)[2]);
    ASSERT_NEAR(boxes[0][2].low, corners.low, 1e-13);
    ASSERT_NEAR(boxes[0][2].high, corners.high, 1e-13);
  }
}

}  // namespace
}  // namespace edgecase
