// SPDX-License-Identifier: MIT
//
// Files that are no results file, or a damaged one, are refused with a sentence that says what is
// wrong and where; never read halfway.
#include <gtest/gtest.h>

#include <sstream>

#include "results/results_json.h"
#include "tests/results/sample_results.h"

namespace edgecase {
namespace {

std::string good() {
  std::ostringstream out;
  write_results(full_results(), out);
  return out.str();
}

// The refusal, or "" when the text was read.
std::string refusal(const std::string& text) {
  const auto outcome = read_results(text);
  const auto* error = std::get_if<std::string>(&outcome);
  return error != nullptr ? *error : "";
}

// The good file with the first occurrence of `from` replaced, of those behind `start`.
std::string damaged(const std::string& from, const std::string& to,
                    const std::string& start = "{") {
  std::string text = good();
  const std::size_t at = text.find(from, text.find(start));
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(BrokenResults, WhatIsNoResultsFileIsRefused) {
  for (const char* text :
       {"", "nonsense", "[]", "null", "{}", "7", "{\"tool\":1}", "\xff\xfe", "{\"tool\":"})
    EXPECT_NE(refusal(text).find("no results file of `edgecase run`"), std::string::npos) << text;
}

TEST(BrokenResults, EveryTruncationIsRefused) {
  const std::string text = good();
  ASSERT_EQ(refusal(text), "");
  // Without the last line break the file is still whole.
  for (std::size_t length = 0; length + 1 < text.size(); length += 1 + length % 7)
    ASSERT_NE(refusal(text.substr(0, length)), "") << length;
}

struct Damage {
  const char* from;
  const char* to;
  const char* said;  // must occur in the refusal
};

TEST(BrokenResults, DamageIsNamedWithItsCase) {
  const Damage damages[] = {
      {"\"verdict\":\"permitted\"", "\"verdict\":\"fine\"", "\"fine\""},
      {"\"verdict\":\"permitted\",", "", "verdict"},
      {"\"kind\":\"value\"", "\"kind\":\"lost\"", "\"lost\""},
      {"\"kind\":\"timed-out\"", "\"kind\":\"tired\"", "\"tired\""},
      {"\"answer_digest\":\"fedc", "\"answer_digest\":\"fedx", "is no digest"},
      {"\"answer_digest\":\"fedc", "\"answer_digest\":\"fedcb", "is no digest"},
      {"\"standing\":\"flake\"", "\"standing\":7", "string"},
      {"\"again\":{\"verdict\":\"agree\"", "\"again\":{\"verdict\":\"fine\"", "\"fine\""},
      {"\"again\":{\"verdict\"", "\"again\":{\"versed\"", "verdict"},
      {"[\"edge\",[", "[\"ledge\",[", "\"ledge\""},
      {"\"legality\":\"legal\"", "\"legality\":\"yes\"", "not known"},
      {"\"situation\":\"", "\"situation\":7,\"x\":\"", "string"},
      {"\"rendered\":[\"nan\"", "\"rendered\":[\"many\"", "\"many\""},
      {"\"pixels\":\"102ff 101f3e81\"", "\"pixels\":\"102ff 101f3e8x\"", "\"x\""},
      {"\"pixels\":\"102ff 101f3e81\"", "\"pixels\":\"102ff\"", "1 words stand where 2 should"},
      {"\"pixels\":\"80a0402 204f7\"", "\"pixels\":\"80a0402\"", "1 words stand where 2 should"},
      {"\"pixels\":\"80a0402 204f7\"", "\"pixels\":[]", "a text is missing"},
      {"\"pixel_counts\":{\"agree\":1", "\"pixel_counts\":{\"agree\":-1", "-1 is no whole number"},
      {"\"head\":0", "\"head\":1", "there is no head 1"},
      {"\"fragments\":", "\"fragments\":-1,\"other\":", "-1 is no whole number in range"},
      {"\"positions\":[[0.5,0.5]", "\"positions\":[[0.5,1e300]", "no place within a pixel"},
      {"\"-1074\":1", "\"often\":1", "\"often\""},
      {"\"results\":{\"osmesa:llvmpipe\"", "\"results\":{\"osmesa:softpipe\"", "osmesa:llvmpipe"},
      {"\"pixel\":[3,1]", "\"pixel\":[3]", "array index 1"},
      {"\"differing\":\"y1 3", "\"differing\":\"3", "no packed text"},
      {"\"ramp\":[[0,0,", "\"ramp\":[[0,\"0\",", "number"},
      {"\"ramp\":[[0,0,0.1,", "\"ramp\":[[0,0,\"much\",", "\"much\""},
      {",\"inf\",\"nan\"]", ",\"inf\"]", "array index 5"},
      {"\"ramp\":[", "\"ramp\":7,\"x\":[", "list"},
      {"\"count\":2", "\"count\":1", "no number of samples"},
      {"\"count\":2", "\"count\":17", "no number of samples"},
      {"\"count\":2", "\"count\":3", "\"positions\" of samples has 2 items instead of 3"},
      {"\"hits\":\"0 1 7", "\"hits\":\"1 7", "3 words stand where 4 should"},
      {"\"coverage\":\"0 3\"", "\"coverage\":\"0 3 1\"", "3 words stand where 2 should"},
      {"\"pixels\":\"102030 40404040", "\"pixels\":\"102030", "3 words stand where 4 should"},
      {"\"positions\":[[0.5,0.5]", "\"positions\":[[0.5]", "array index 1"},
      {"\"disagreements\":[{", "\"disagreements\":[7,{", "number"},
  };
  for (const Damage& damage : damages) {
    const std::string said = refusal(damaged(damage.from, damage.to, "{\"case\":"));
    EXPECT_NE(said.find("no results file of `edgecase run`"), std::string::npos) << damage.to;
    EXPECT_NE(said.find("lines/a"), std::string::npos) << damage.to << ": " << said;
    EXPECT_NE(said.find(damage.said), std::string::npos) << damage.to << ": " << said;
  }
}

TEST(BrokenResults, DamageOfAHeadIsNamedWithItsLine) {
  const Damage damages[] = {
      {"\"width\":2", "\"width\":-2", "no target of -2 by 1 pixels"},
      {"\"width\":2", "\"width\":\"2\"", "number"},
      {"\"width\":2", "\"width\":2.0", "2.0 is no whole number"},
      {"\"width\":2", "\"width\":1e300", "1e+300 is no whole number"},
      {"\"width\":2", "\"width\":4294967298", "4294967298 is no whole number in range"},
      {"\"height\":1", "\"height\":1000000", "no target of 2 by 1000000 pixels"},
      {"\"head\":0", "\"head\":1", "head 1 stands in the place of 0"},
      {"\"tags\":[", "\"tags\":7,\"x\":[", "number"},
      {"\"viewport\":[-3,0,8,16]", "\"viewport\":[-3,0]", "array index 2"},
  };
  for (const Damage& damage : damages) {
    const std::string said = refusal(damaged(damage.from, damage.to, "{\"head\":"));
    EXPECT_NE(said.find("no results file of `edgecase run`: line 2: "), std::string::npos) << said;
    EXPECT_NE(said.find(damage.said), std::string::npos) << damage.to << ": " << said;
  }
}

TEST(BrokenResults, DamageOutsideCasesIsRefusedToo) {
  for (const auto& [from, to] :
       {std::pair{"\"subpixel_bits\":8", "\"subpixel_bits\":\"8\""},
        std::pair{"\"interrupted\":true", "\"interrupted\":1"},
        std::pair{"\"renderers\":[", "\"renderers\":7,\"x\":["},
        std::pair{"\"cases\":2", "\"cases\":3"},
        std::pair{"\"latitude\":\"none\"", "\"latitude\":\"some\""},
        std::pair{"\"whole_suite\":true", "\"whole_suite\":7"},
        std::pair{"\"left_out\":12", "\"left_out\":\"12\""},
        std::pair{"\"index\":3", "\"index\":5"}, std::pair{"\"index\":3", "\"index\":0"},
        std::pair{"\"faults\":[{", "\"faults\":7,\"x\":[{"},
        std::pair{"\"remedy\":\"\"", "\"cure\":\"\""}})
    EXPECT_NE(refusal(damaged(from, to)), "") << to;
}

}  // namespace
}  // namespace edgecase
