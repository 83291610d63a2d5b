// SPDX-License-Identifier: MIT
#include "base/threads.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <mutex>
#include <numeric>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>

namespace edgecase {
namespace {

TEST(Threads, EachDoesItsWorkOnce) {
  std::vector<int> done(5);
  run_threads(done.size(), [&](std::size_t i) { ++done[i]; });
  EXPECT_EQ(done, std::vector<int>(5, 1));
}

TEST(Threads, FirstFaultIsThrownWhenAllHaveEnded) {
  std::atomic<int> ended = 0;
  const auto work = [&](std::size_t i) {
    if (i == 3) throw std::runtime_error("three");
    if (i == 1) throw std::runtime_error("one");
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    ++ended;
  };
  try {
    run_threads(5, work);
    FAIL() << "nothing was thrown";
  } catch (const std::runtime_error& fault) {
    EXPECT_STREQ(fault.what(), "one");
  }
  EXPECT_EQ(ended, 3);
}

TEST(Threads, ValuesAreTakenInOrderWhoeverIsSlow) {
  std::vector<std::string> taken;
  const auto make = [](std::size_t i) {
    if (i % 3 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return std::to_string(i);
  };
  make_in_order(100, make, [&](std::size_t i, std::string value) {
    EXPECT_EQ(value, std::to_string(i));
    taken.push_back(std::move(value));
  });
  EXPECT_EQ(taken.size(), 100U);
}

TEST(Threads, FewValuesWaitToBeTaken) {
  std::atomic<std::size_t> made = 0;
  std::size_t most = 0;
  make_in_order(
      1000, [&](std::size_t i) { return ++made, i; },
      [&](std::size_t i, std::size_t) { most = std::max(most, made - i); });
  EXPECT_LE(most, 16 * (std::thread::hardware_concurrency() + 1));
}

TEST(Threads, FewLargeValuesWaitToBeTaken) {
  constexpr std::size_t kLarge = std::size_t{1} << 20;
  std::atomic<std::size_t> made = 0;
  std::size_t most = 0;
  make_in_order(
      200, [&](std::size_t i) { return ++made, i; },
      [&](std::size_t i, std::size_t) { most = std::max(most, made - i); },
      [](std::size_t) { return kLarge; });
  EXPECT_EQ(made, 200U);
  EXPECT_LE(most, 2 * std::thread::hardware_concurrency() + 1);
}

TEST(Threads, FaultOfMakingIsThrownWhereItsValueWouldBeTaken) {
  std::size_t taken = 0;
  const auto make = [](std::size_t i) { return i < 20 ? i : throw std::runtime_error("twenty"); };
  EXPECT_THROW(make_in_order(100, make, [&](std::size_t, std::size_t) { ++taken; }),
               std::runtime_error);
  EXPECT_EQ(taken, 16U) << "the eight that were made together are lost";
}

TEST(Threads, FewThreadsMakeAllValues) {
  std::mutex mutex;
  std::set<std::thread::id> makers;
  make_in_order(
      1000,
      [&](std::size_t i) {
        const std::lock_guard lock(mutex);
        makers.insert(std::this_thread::get_id());
        return i;
      },
      [](std::size_t, std::size_t) {});
  EXPECT_LE(makers.size(), std::thread::hardware_concurrency());
}

TEST(Threads, FaultOfTakingEndsMaking) {
  std::atomic<std::size_t> made = 0;
  const auto make = [&](std::size_t i) { return ++made, i; };
  EXPECT_THROW(make_in_order(1000, make,
                             [](std::size_t i, std::size_t) {
                               if (i == 20) throw std::runtime_error("twenty");
                             }),
               std::runtime_error);
  EXPECT_LE(made, 20 + 16 * (std::thread::hardware_concurrency() + 1));
}

}  // namespace
}  // namespace edgecase
