// SPDX-License-Identifier: MIT
#include "rules/output/fragment_tests.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "rules/values/framebuffer.h"

namespace edgecase {
namespace {

constexpr CompareFunction kFunctions[] = {CompareFunction::never,   CompareFunction::less,
                                          CompareFunction::equal,   CompareFunction::lequal,
                                          CompareFunction::greater, CompareFunction::notequal,
                                          CompareFunction::gequal,  CompareFunction::always};
constexpr DepthFormat kFormats[] = {DepthFormat::depth16, DepthFormat::depth24,
                                    DepthFormat::depth32f};

bool passes(CompareFunction function, double depth, double stored,
            DepthTestMethod method = DepthTestMethod::as_set,
            DepthFormat format = DepthFormat::depth16) {
  return passes_depth_test({function, true}, depth, stored, format, method);
}

// Which of less, equal and greater pass, as the specification's table words it: "<=>".
std::string passing(CompareFunction function, DepthTestMethod method, DepthFormat format) {
  const double stored = to_depth(0.5, format);
  std::string result;
  if (passes(function, 0.25, stored, method, format)) result += '<';
  if (passes(function, stored, stored, method, format)) result += '=';
  if (passes(function, 0.75, stored, method, format)) result += '>';
  return result;
}

// never, less, equal, lequal, greater, notequal, gequal, always.
using Table = std::vector<std::string>;

Table table_of(DepthTestMethod method, DepthFormat format = DepthFormat::depth16) {
  Table table;
  for (const CompareFunction function : kFunctions)
    table.push_back(passing(function, method, format));
  return table;
}

const Table kStandard = {"", "<", "=", "<=", ">", "<>", "=>", "<=>"};

TEST(DepthTest, EachFunctionPassesTheOrdersOfItsName) {
  for (const DepthFormat format : kFormats)
    EXPECT_EQ(table_of(DepthTestMethod::as_set, format), kStandard);
}

TEST(DepthTest, AlternativesPassOthers) {
  EXPECT_EQ(table_of(DepthTestMethod::ties_pass),
            (Table{"", "<=", "=", "<=", "=>", "<>", "=>", "<=>"}));
  EXPECT_EQ(table_of(DepthTestMethod::ties_fail),
            (Table{"", "<", "=", "<", ">", "<>", ">", "<=>"}));
  EXPECT_EQ(table_of(DepthTestMethod::ignored), Table(8, "<=>"));
  // Both are values of the format: converted or not, they are the same.
  EXPECT_EQ(table_of(DepthTestMethod::unconverted), kStandard);
}

TEST(DepthTest, WhatIsComparedIsConvertedUnlessUnconverted) {
  for (const DepthFormat format : kFormats) {
    // 0.3 is stored as a smaller value in 16 bits, as larger ones in 24 and in float32.
    const double stored = to_depth(0.3, format);
    ASSERT_NE(stored, 0.3);
    EXPECT_TRUE(passes(CompareFunction::equal, 0.3, stored, DepthTestMethod::as_set, format));
    EXPECT_FALSE(passes(CompareFunction::less, 0.3, stored, DepthTestMethod::as_set, format));
    EXPECT_FALSE(passes(CompareFunction::equal, 0.3, stored, DepthTestMethod::unconverted, format));
    EXPECT_EQ(passes(CompareFunction::less, 0.3, stored, DepthTestMethod::unconverted, format),
              0.3 < stored);
  }
}

// Depths closer than half a step to a stored value tie with it, and ties follow the function.
TEST(DepthTest, TiesFollowTheFunction) {
  constexpr int kLargest = (1 << 16) - 1;
  for (int code = 1; code < kLargest; code += 257)
    for (const double share : {-0.49, -0.2, 0.0, 0.3, 0.49}) {
      const double depth = (code + share) / kLargest;
      const double stored = static_cast<double>(code) / kLargest;
      for (const CompareFunction function : kFunctions) {
        const bool lets_ties_pass =
            function == CompareFunction::equal || function == CompareFunction::lequal ||
            function == CompareFunction::gequal || function == CompareFunction::always;
        EXPECT_EQ(passes(function, depth, stored), lets_ties_pass)
            << name_of(function) << " " << depth;
      }
    }
}

TEST(DepthTest, WithoutABufferEverythingPasses) {
  for (const CompareFunction function : kFunctions)
    for (const DepthTestMethod method : values_of<DepthTestMethod>())
      EXPECT_TRUE(passes(function, 0.5, 0.25, method, DepthFormat::none));
}

// Of depths between the format's values nothing is equal, and either neighbour may be stored.
TEST(DepthTest, UnconvertedDepthsAreEqualToWhatTheFormatHoldsAlone) {
  constexpr double kStep = 1.0 / 65535;
  const auto outcomes = [](CompareFunction function, Interval depth, Interval stored) {
    const TestOutcomes found = unconverted_outcomes(function, depth, stored, DepthFormat::depth16);
    return std::pair{found.may_pass, found.may_fail};
  };
  const Interval stored{5 * kStep, 6 * kStep};
  const double between = 5.5 * kStep;
  EXPECT_EQ(outcomes(CompareFunction::equal, between, stored), (std::pair{false, true}));
  EXPECT_EQ(outcomes(CompareFunction::less, between, stored), (std::pair{true, true}));
  EXPECT_EQ(outcomes(CompareFunction::less, between, 6 * kStep), (std::pair{true, false}));
  EXPECT_EQ(outcomes(CompareFunction::lequal, between, 5 * kStep), (std::pair{false, true}));
  EXPECT_EQ(outcomes(CompareFunction::equal, 5 * kStep, 5 * kStep), (std::pair{true, false}));
  EXPECT_EQ(outcomes(CompareFunction::equal, {5 * kStep, between}, stored),
            (std::pair{true, true}));
  EXPECT_EQ(outcomes(CompareFunction::greater, {7 * kStep, 8 * kStep}, stored),
            (std::pair{true, false}));
}

// Every pair of ranges of a format of 3 bits, against all pairs of their values.
TEST(DepthTest, OutcomesAreThoseOfAllPairsOfValues) {
  constexpr int kLargest = 7;
  const auto value = [](int code) { return static_cast<double>(code) / kLargest; };
  const auto outcomes_of_all = [&](CompareFunction function, int a, int b, int c, int d) {
    TestOutcomes found;
    for (int depth = a; depth <= b; ++depth)
      for (int stored = c; stored <= d; ++stored)
        (passes(function, value(depth), value(stored), DepthTestMethod::unconverted)
             ? found.may_pass
             : found.may_fail) = true;
    return found;
  };
  int undecided = 0;
  for (const CompareFunction function : kFunctions)
    for (int a = 0; a <= kLargest; ++a)
      for (int b = a; b <= kLargest; ++b)
        for (int c = 0; c <= kLargest; ++c)
          for (int d = c; d <= kLargest; ++d) {
            const TestOutcomes expected = outcomes_of_all(function, a, b, c, d);
            const TestOutcomes found =
                permitted_outcomes(function, {value(a), value(b)}, {value(c), value(d)}, false);
            ASSERT_EQ(found.may_pass, expected.may_pass) << name_of(function) << a << b << c << d;
            ASSERT_EQ(found.may_fail, expected.may_fail) << name_of(function) << a << b << c << d;
            undecided += found.may_pass && found.may_fail ? 1 : 0;
          }
  EXPECT_GT(undecided, 0);
}

TEST(DepthTest, OneAndTheSameDepthIsEqualWhateverItIs) {
  for (const CompareFunction function : kFunctions) {
    // Whatever is known of either alone.
    for (const Interval stored : {Interval(0.25, 0.75), Interval(0.5, 1), Interval(0.875, 1)}) {
      const TestOutcomes found = permitted_outcomes(function, {0.25, 0.75}, stored, true);
      EXPECT_EQ(found.may_pass, holds(function, false, true)) << name_of(function);
      EXPECT_EQ(found.may_fail, !holds(function, false, true)) << name_of(function);
    }
  }
}

TEST(DepthTest, AMaskKeepsDepthsUnlessItIsIgnored) {
  for (const bool write : {false, true}) {
    EXPECT_EQ(stores_depth({CompareFunction::less, write}, DepthMaskMethod::as_set), write);
    EXPECT_TRUE(stores_depth({CompareFunction::less, write}, DepthMaskMethod::ignored));
  }
}

}  // namespace
}  // namespace edgecase
