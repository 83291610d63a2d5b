// SPDX-License-Identifier: MIT
#include "base/shared.h"

#include <gtest/gtest.h>

#include <vector>

namespace edgecase {
namespace {

TEST(Shared, ACopyIsTheSameInMemory) {
  const SharedText text = "a text";
  const SharedText copy = text;
  EXPECT_TRUE(is_same_object(text, copy));
  EXPECT_EQ(&*text, &*copy);
  EXPECT_EQ(*copy, "a text");
}

TEST(Shared, EqualityIsOfValuesWhereverTheyAre) {
  const Shared<std::vector<int>> one = std::vector<int>{1, 2};
  const Shared<std::vector<int>> equal = std::vector<int>{1, 2};
  const Shared<std::vector<int>> other = std::vector<int>{1, 3};
  EXPECT_FALSE(is_same_object(one, equal));
  EXPECT_EQ(one, equal);
  EXPECT_NE(one, other);
}

TEST(Shared, NothingIsAnEmptyValue) {
  const SharedText nothing;
  EXPECT_TRUE(nothing->empty());
  EXPECT_EQ(nothing, SharedText(""));
}

TEST(Shared, OnlyWhatIsEqualBecomesOneInMemory) {
  const SharedText text = "a text";
  SharedText equal = "a text";
  equal.share_with(text);
  EXPECT_TRUE(is_same_object(equal, text));
  SharedText other = "a taxt";
  other.share_with(text);
  EXPECT_EQ(*other, "a taxt");
  EXPECT_FALSE(is_same_object(other, text));
}

}  // namespace
}  // namespace edgecase
