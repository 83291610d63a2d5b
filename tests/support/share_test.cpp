// SPDX-License-Identifier: MIT
//
// The shares of a test are all that it asks, once.
#include "tests/support/share.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <set>
#include <string>

namespace edgecase {
namespace {

// Runs `body` in a process of its own with this EDGECASE_SHARE; its exit code.
template <class Body>
void expect_of_share(const std::string& text, Body body) {
  EXPECT_EXIT(
      {
        setenv("EDGECASE_SHARE", text.c_str(), 1);
        std::exit(body() ? 0 : 1);
      },
      testing::ExitedWithCode(0), "")
      << text;
}

class ShareDeathTest : public testing::Test {
 protected:
  void SetUp() override { GTEST_FLAG_SET(death_test_style, "fast"); }
};

TEST_F(ShareDeathTest, WithoutOneIsEverything) {
  expect_of_share("1/1", [] {
    return share_of(7) == 7 && is_in_share(0) && is_in_share(41) && share_seed(5) == 5;
  });
}

TEST_F(ShareDeathTest, EachItemIsInExactlyOne) {
  // A bit for each share: a share's process exits with success if it holds the items of its bit.
  for (int number = 1; number <= 3; ++number)
    expect_of_share(std::to_string(number) + "/3", [number] {
      int mine = 0;
      for (std::uint64_t item = 0; item < 3000; ++item) mine += is_in_share(item);
      return share().number == static_cast<std::uint64_t>(number - 1) && mine > 900 && mine < 1100;
    });
}

TEST_F(ShareDeathTest, ShowsHalfOfItsPartAtLeast) {
  expect_of_share("1/1", [] { return least_of(1000) == 1000; });
  expect_of_share("2/10", [] { return least_of(1000) == 50 && least_of(3) == 0; });
}

TEST_F(ShareDeathTest, IsDealtInTurn) {
  expect_of_share("2/3", [] {
    Dealer dealer;
    bool agrees = true;
    for (std::uint64_t item = 0; item < 100; ++item)
      agrees = agrees && dealer.deal() == is_in_share(item);
    return agrees && dealer.items() == 100;
  });
}

TEST_F(ShareDeathTest, HasOneOfAFew) {
  expect_of_share("2/3", [] {
    return !is_in_share_of_few(0, 5) && is_in_share_of_few(1, 5) && is_in_share_of_few(4, 5);
  });
  expect_of_share("4/9", [] { return is_in_share_of_few(1, 2) && !is_in_share_of_few(0, 2); });
}

TEST_F(ShareDeathTest, IsOfAsManyScenesOfKernelsAsAreAskedFor) {
  expect_of_share("1/4", [] { return kernel_scenes(1000) == 250; });
  expect_of_share("1/4", [] {
    setenv("EDGECASE_KERNEL_SCENES", "3", 1);
    return kernel_scenes(1000) == 750;
  });
}

TEST_F(ShareDeathTest, HasAScene) {
  expect_of_share("2/100",
                  [] { return share_of(7) == 1 && share_of(1000) == 10 && share_of(0) == 0; });
  expect_of_share("2/100", [] { return share_of(1000, 64) == 64 && share_of(7, 64) == 7; });
  expect_of_share("2/3", [] { return share_of(7) == 3 && share_seed(5) != 5; });
}

TEST_F(ShareDeathTest, RefusesWhatIsNone) {
  for (const char* text : {"0/4", "5/4", "1", "1/", "a/b", "1/4x", "-1/4"})
    EXPECT_EXIT(
        {
          setenv("EDGECASE_SHARE", text, 1);
          share();
        },
        testing::ExitedWithCode(2), "it has to be I/N")
        << text;
}

}  // namespace
}  // namespace edgecase
