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
      {"\"standing\":\"flake\"", "\"standing\":7", "string"},
      {"\"again\":{\"verdict\":\"agree\"", "\"again\":{\"verdict\":\"fine\"", "\"fine\""},
      {"\"again\":{\"verdict\"", "\"again\":{\"versed\"", "verdict"},
      {"\"role\":\"edge\"", "\"role\":\"ledge\"", "\"ledge\""},
      {"\"legality\":\"legal\"", "\"legality\":\"yes\"", "not known"},
      {"\"situation\":\"", "\"situation\":7,\"x\":\"", "string"},
      {"\"rendered\":[\"nan\"", "\"rendered\":[\"many\"", "\"many\""},
      {"\"pixels\":\"000102ff10204080\"", "\"pixels\":\"000102ff1020408\"", "pixels"},
      {"\"pixels\":\"000102ff10204080\"", "\"pixels\":\"000102ff1020408x\"", "'x'"},
      {"\"pixels\":\"000102ff10204080\"", "\"pixels\":\"000102ff\"", "pixels"},
      {"\"pixels\":\"09080706050403ff\"", "\"pixels\":\"09080706\"", "pixels"},
      {"\"pixels\":\"09080706050403ff\"", "\"picture\":\"09080706050403ff\"", "pixels"},
      {"\"pixel_counts\":{", "\"counts\":{", "pixel_counts"},
      {"\"width\":2", "\"width\":-2", "pixels"},
      {"\"width\":2", "\"width\":\"2\"", "number"},
      {"\"width\":2", "\"width\":2.0", "2.0 is no whole number"},
      {"\"width\":2", "\"width\":1e300", "1e+300 is no whole number"},
      {"\"width\":2", "\"width\":4294967298", "4294967298 is no whole number in range"},
      {"\"fragments\":", "\"fragments\":-1,\"other\":", "-1 is no whole number in range"},
      {"\"positions\":[[0.5,0.5]", "\"positions\":[[0.5,1e300]", "no place within a pixel"},
      {"\"-1074\":1", "\"often\":1", "\"often\""},
      {"\"results\":{\"osmesa:llvmpipe\"", "\"results\":{\"osmesa:softpipe\"", "osmesa:llvmpipe"},
      {"\"pixel\":[3,1]", "\"pixel\":[3]", "array index 1"},
      {"\"ramp\":[[0,0,", "\"ramp\":[[0,\"0\",", "number"},
      {"\"ramp\":[[0,0,0.1,", "\"ramp\":[[0,0,\"much\",", "\"much\""},
      {",\"inf\",\"nan\"]", ",\"inf\"]", "array index 5"},
      {"\"ramp\":[", "\"ramp\":7,\"x\":[", "list"},
      {"\"count\":2", "\"count\":1", "no number of samples"},
      {"\"count\":2", "\"count\":17", "no number of samples"},
      {"\"count\":2", "\"count\":3", "\"positions\" of samples has 2 items instead of 3"},
      {"\"hits\":[0,", "\"hits\":[", "\"hits\" of samples has 3 items instead of 4"},
      {"\"coverage\":[0,3]", "\"coverage\":[0,3,1]", "\"coverage\" of samples has 3 items"},
      {"\"pixels\":\"00102030", "\"pixels\":\"00102030ff", "\"pixels\" of samples has 17"},
      {"\"positions\":[[0.5,0.5]", "\"positions\":[[0.5]", "array index 1"},
      {"\"disagreements\":[{", "\"disagreements\":[7,{", "number"},
  };
  for (const Damage& damage : damages) {
    // What stands before the cases (clusters, the summary) is not read back.
    const std::string said = refusal(damaged(damage.from, damage.to, "\"cases\":[\n"));
    EXPECT_NE(said.find("no results file of `edgecase run`"), std::string::npos) << damage.to;
    EXPECT_NE(said.find("lines/a"), std::string::npos) << damage.to << ": " << said;
    EXPECT_NE(said.find(damage.said), std::string::npos) << damage.to << ": " << said;
  }
}

TEST(BrokenResults, DamageOutsideCasesIsRefusedToo) {
  for (const auto& [from, to] :
       {std::pair{"\"subpixel_bits\":8", "\"subpixel_bits\":\"8\""},
        std::pair{"\"interrupted\":true", "\"interrupted\":1"},
        std::pair{"\"renderers\":[", "\"renderers\":7,\"x\":["},
        std::pair{"\"cases\":[", "\"cases\":{},\"x\":["},
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
