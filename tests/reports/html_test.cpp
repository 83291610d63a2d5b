// SPDX-License-Identifier: MIT
#include "reports/html.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>
#include <string>

#include "reports/pixels.h"
#include "reports/report_data.h"
#include "results/clusters.h"
#include "tests/reports/sample.h"

namespace edgecase {
namespace {

using nlohmann::json;

std::string page_of(const Results& results) {
  std::ostringstream out;
  write_html(results, sample::texts(), out);
  return out.str();
}

// The text between the data element's tags.
std::string data_of(const std::string& page) {
  const std::string open = "<script type=\"application/json\" id=\"data\">";
  const std::size_t begin = page.find(open) + open.size();
  return page.substr(begin, page.find("</script>", begin) - begin);
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++found;
  return found;
}

TEST(Html, DataParsesBackAndIsWhatWasGiven) {
  const Results results = sample::results();
  const json data = json::parse(data_of(page_of(results)));
  EXPECT_EQ(data, json::parse(report_data(results, sample::texts())));
  ASSERT_EQ(data["cases"].size(), results.cases.size());
  for (std::size_t i = 0; i < results.cases.size(); ++i) {
    const CaseResults& one = results.cases[i];
    const json& shown = data["cases"][i];
    EXPECT_EQ(shown["width"], one.width);
    EXPECT_EQ(shown["figure"].size(), one.figure.marks.size());
    ASSERT_EQ(shown["results"].size(), one.results.size());
    for (std::size_t r = 0; r < one.results.size(); ++r) {
      EXPECT_EQ(shown["results"][r]["verdict"], name_of(one.results[r].verdict));
      EXPECT_EQ(shown["results"][r]["standing"], name_of(one.results[r].standing));
      const json& answer = shown["answers"][shown["results"][r]["answer"].get<std::size_t>()];
      ASSERT_EQ(answer["disagreements"].size(), one.results[r].disagreements.size());
      for (std::size_t d = 0; d < one.results[r].disagreements.size(); ++d)
        EXPECT_EQ(answer["disagreements"][d]["x"], one.results[r].disagreements[d].x);
    }
  }
}

TEST(Html, RenderersHoldTheirClusters) {
  const Results results = sample::results();
  const json data = json::parse(report_data(results, {}));
  std::size_t all = 0;
  for (std::size_t r = 0; r < results.renderers.size(); ++r) {
    const std::vector<Cluster> clusters = clusters_of(results, r);
    const json& shown = data["renderers"][r]["clusters"];
    ASSERT_EQ(shown.size(), clusters.size());
    for (std::size_t i = 0; i < clusters.size(); ++i) {
      EXPECT_EQ(shown[i]["cause"], clusters[i].cause);
      EXPECT_EQ(shown[i]["legal"], clusters[i].legal);
      EXPECT_EQ(shown[i]["disagreements"], clusters[i].disagreements);
      EXPECT_EQ(shown[i]["smallest"], clusters[i].smallest_case);
    }
    all += clusters.size();
  }
  EXPECT_GT(all, 3U);
}

TEST(Html, ValuesHaveTheirMeanAndTheirShareOfTheRange) {
  const json data = json::parse(report_data(sample::results(), {}));
  int seen = 0;
  for (const json& one : data["cases"])
    for (const json& answer : one["answers"])
      for (const json& values : answer["values"]) {
        ++seen;
        EXPECT_EQ(values["components"], 4 * values["compared"].get<std::uint64_t>());
        EXPECT_EQ(values["mean_ulp"], 0.375);
        EXPECT_EQ(values["relative"], 0x1p-20);
        EXPECT_EQ(values["worst"]["ulp"], 5.5);
      }
  EXPECT_GT(seen, 0);
}

TEST(Html, NoTextLeavesTheDataElement) {
  const std::string page = page_of(sample::results());
  EXPECT_EQ(data_of(page).find('<'), std::string::npos);
  EXPECT_EQ(count(page, "<script"), 2u);
  EXPECT_EQ(count(page, "</script"), 2u);
  const json data = json::parse(data_of(page));
  const auto hostile = [](const json& one) {
    return one["title"].get<std::string>().rfind("</script><script>", 0) == 0;
  };
  EXPECT_TRUE(std::any_of(data["cases"].begin(), data["cases"].end(), hostile));
}

TEST(Html, LoadsNothing) {
  const std::string page = page_of(Results{});
  const std::regex reference("(src|href|action|srcset|poster)\\s*=\\s*[\"'][^#\"']");
  EXPECT_FALSE(std::regex_search(page, reference));
  EXPECT_EQ(page.find("@import"), std::string::npos);
  EXPECT_EQ(page.find("url("), std::string::npos);
  EXPECT_EQ(page.find("innerHTML"), std::string::npos);
  EXPECT_EQ(page.find("insertAdjacentHTML"), std::string::npos);
  EXPECT_NE(page.find("default-src 'none'"), std::string::npos);
  EXPECT_EQ(page.find("unsafe-inline"), std::string::npos);
  EXPECT_EQ(page.find("{{"), std::string::npos);
}

TEST(Html, RenderersThatAnswerAlikeShareOneAnswer) {
  const json data = json::parse(report_data(sample::results(), {}));
  for (const json& one : data["cases"]) {
    if (one["id"] != "lines/octant-00") continue;
    EXPECT_EQ(one["answers"].size(), 2u);
    EXPECT_EQ(one["results"][2]["answer"], 0);
  }
}

TEST(Html, AnImageOfAnotherSizeIsNeverShownAsEqual) {
  Results results;
  results.renderers.resize(1);
  results.cases.resize(1);
  results.cases[0].pixels.assign(16, 255);
  results.cases[0].results.resize(1);
  for (std::size_t bytes : {std::size_t{0}, std::size_t{12}, std::size_t{20}}) {
    results.cases[0].results[0].pixels.assign(bytes, 255);
    EXPECT_EQ(json::parse(report_data(results, {}))["cases"][0]["answers"][0]["blank"], true);
  }
}

TEST(Html, LeftOutDisagreementsAreCounted) {
  Results results;
  results.renderers.resize(1);
  results.cases.resize(1);
  results.cases[0].results.resize(1);
  results.cases[0].results[0].disagreements.assign(
      kMaxDisagreementsPerAnswer + 7, sample::disagreement(0, 0, DisagreementKind::extra, false));
  const json answer = json::parse(report_data(results, {}))["cases"][0]["answers"][0];
  EXPECT_EQ(answer["disagreements"].size(), kMaxDisagreementsPerAnswer);
  EXPECT_EQ(answer["omitted"], 7);
}

TEST(Html, SameResultsSameBytes) {
  EXPECT_EQ(page_of(sample::results()), page_of(sample::results()));
}

// Writes the sample where EDGECASE_SAMPLE_REPORT says, for a look with a browser.
TEST(Html, SampleIsSmall) {
  const std::string page = page_of(sample::results());
  EXPECT_LT(page.size(), 600'000u);
  RecordProperty("bytes", std::to_string(page.size()));
  if (const char* path = std::getenv("EDGECASE_SAMPLE_REPORT")) std::ofstream(path) << page;
}

TEST(Pixels, PackingIsReversed) {
  const Bytes image = {1, 2, 3, 4, 1, 2, 3, 4, 9, 9, 9, 9, 0, 0, 0, 0, 5, 5, 5, 5, 5, 5, 5, 5};
  EXPECT_EQ(unpack_pixels(pack_pixels(image)), image);
  EXPECT_TRUE(pack_pixels({}).empty());
  Bytes noise;
  for (std::size_t i = 0; i < 4 * 1000; ++i)
    noise.push_back(static_cast<std::uint8_t>(i * i / 7 % (i % 600 < 300 ? 2 : 251)));
  EXPECT_EQ(unpack_pixels(pack_pixels(noise)), noise);
  EXPECT_LT(pack_pixels(Bytes(4 * 4096, 7)).size(), 10u);
}

TEST(Pixels, TheDifferenceOfEqualImagesIsNearlyNothing) {
  const Bytes image(4 * 64 * 64, 200);
  EXPECT_LT(to_base64(pack_pixels(difference_of(image, image))).size(), 12u);
}

TEST(Pixels, Base64) {
  const auto encoded = [](const std::string& text) {
    return to_base64({text.begin(), text.end()});
  };
  EXPECT_EQ(encoded(""), "");
  EXPECT_EQ(encoded("f"), "Zg==");
  EXPECT_EQ(encoded("fo"), "Zm8=");
  EXPECT_EQ(encoded("foobar"), "Zm9vYmFy");
  EXPECT_EQ(to_base64({255, 254, 253}), "//79");
}

}  // namespace
}  // namespace edgecase
