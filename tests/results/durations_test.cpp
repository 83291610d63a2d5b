// SPDX-License-Identifier: MIT
#include "results/durations.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

namespace edgecase {
namespace {

using ::testing::HasSubstr;

std::variant<Durations, std::string> read(const std::string& text) {
  std::istringstream in(text);
  return read_durations(in);
}

TEST(Durations, AreALineForEachCase) {
  const Durations durations = {{"b", {{"one", 0.25}, {"exec:a \"b\"", 3}}},
                               {"a:x=1", {{"one", 0.0000014}}}};
  std::ostringstream out;
  write_durations(durations, out);
  EXPECT_EQ(out.str(),
            "{\"case\":\"a:x=1\",\"seconds\":{\"one\":1e-06}}\n"
            "{\"case\":\"b\",\"seconds\":{\"exec:a \\\"b\\\"\":3.0,\"one\":0.25}}\n");
  const auto back = std::get<Durations>(read(out.str()));
  EXPECT_EQ(seconds_of(back, "b", "one"), 0.25);
  EXPECT_EQ(seconds_of(back, "b", "two"), 0);
  EXPECT_EQ(seconds_of(back, "c", "one"), 0);
  EXPECT_TRUE(std::get<Durations>(read("")).empty());
}

TEST(Durations, AreRefusedWithTheLine) {
  const std::string good = "{\"case\":\"a\",\"seconds\":{\"one\":1}}\n";
  for (const char* bad : {"nonsense", "[]", "{\"case\":\"a\"}", "{\"case\":\"a\",\"seconds\":7}",
                          "{\"case\":\"a\",\"seconds\":{\"one\":-1}}",
                          "{\"case\":\"a\",\"seconds\":{\"one\":\"1\"}}"}) {
    const auto outcome = read(good + bad);
    ASSERT_TRUE(std::holds_alternative<std::string>(outcome)) << bad;
    EXPECT_THAT(std::get<std::string>(outcome), HasSubstr("no durations: line 2: ")) << bad;
    EXPECT_THAT(std::get<std::string>(outcome), HasSubstr("--timings")) << bad;
  }
}

}  // namespace
}  // namespace edgecase
