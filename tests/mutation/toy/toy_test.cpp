// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cstdlib>

#include "toy.h"

namespace toy {
namespace {

TEST(Toy, ClampsSums) {
  EXPECT_EQ(clamped_sum(1, 2), 3);
  EXPECT_EQ(clamped_sum(60, 40), 100);
  EXPECT_EQ(clamped_sum(60, 70), 100);
}

TEST(Toy, CountsDown) {
  EXPECT_EQ(count_down(0), 0);
  EXPECT_EQ(count_down(3), 6);
}

TEST(Toy, UsesEveryOperator) {
  EXPECT_EQ(every_operator(2, false), -52);
  EXPECT_EQ(every_operator(7, false), -20);
  EXPECT_EQ(every_operator(8, true), -38);
  EXPECT_EQ(every_operator(9, true), -20);
}

TEST(Toy, Doubles) {
  int three = 3;
  EXPECT_EQ(doubled(three), 6);
  EXPECT_EQ(Limits().low, -1);
  EXPECT_EQ(greeting("you"), "hello you");
  EXPECT_EQ(multiples(5), (std::array<int, 3>{0, 5, 10}));
  EXPECT_EQ(Limits(), Limits());
}

// The tool must stop where a test fails without any mutant.
TEST(Toy, FailsOnRequest) {
  EXPECT_EQ(std::getenv("TOY_FAILS"), nullptr);
}

}  // namespace
}  // namespace toy
