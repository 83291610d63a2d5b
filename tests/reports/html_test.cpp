// SPDX-License-Identifier: MIT
#include "reports/html.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <string>

#include "reports/base64.h"
#include "reports/pixels.h"
#include "reports/report_data.h"
#include "results/case_results_json.h"
#include "results/clusters.h"
#include "results/worst_first.h"
#include "tests/reports/large_run.h"
#include "tests/reports/sample.h"
#include "tests/reports/shown.h"
#include "tests/support/causes.h"

namespace edgecase {
namespace {

using nlohmann::json;

std::string page_of(const Results& results) {
  return html_files(results, sample::texts(), "report.html", Beyond::left_out).front().text;
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

// The lines of the blocks that a report holds.
std::vector<std::string> lines_of(const std::vector<std::string>& blocks) {
  std::vector<std::string> lines;
  for (const std::string& block : blocks) {
    std::istringstream text(inflated(from_base64(block)));
    for (std::string line; std::getline(text, line);) lines.push_back(line);
  }
  return lines;
}

// What is no UTF-8 is replaced.
std::string as_valid_text(const std::string& text) {
  return json::parse(json(text).dump(-1, ' ', false, json::error_handler_t::replace));
}

std::string id_of(const json& index, const json& row) {
  return index["heads"][row[0].get<std::size_t>()]["stem"].get<std::string>() +
         row[1].get<std::string>();
}

TEST(Html, DataParsesBackAndIsWhatWasGiven) {
  const Results results = sample::results();
  const ReportTexts texts = sample::texts();
  const ReportData data = report_data(results, texts);
  const json index = json::parse(data.index);
  const std::vector<std::string> lines = lines_of(data.blocks);
  EXPECT_EQ(index["key"], data.key);
  ASSERT_EQ(index["cases"].size(), results.cases.size());
  for (std::size_t i = 0; i < results.cases.size(); ++i) {
    const CaseResults one = results.cases[i];
    const json& row = index["cases"][i];
    EXPECT_EQ(id_of(index, row), as_valid_text(one.id));
    for (std::size_t r = 0; r < one.results.size(); ++r) {
      const json& outcome = index["outcomes"][row[3][r].get<std::size_t>()];
      EXPECT_EQ(outcome[0], name_of(one.results[r].verdict));
      EXPECT_EQ(outcome[1], name_of(one.results[r].standing));
    }
    ASSERT_EQ(row.size() > 4, has_details(results.cases.outline(i))) << one.id;
    if (row.size() > 4) {
      EXPECT_EQ(json::parse(lines.at(row[4].get<std::size_t>())), sample::details_of(one));
    }
    const json& head = index["heads"][row[0].get<std::size_t>()];
    EXPECT_EQ(head["width"], one.width);
    EXPECT_EQ(json::parse(lines.at(head["source"].get<std::size_t>())),
              as_valid_text(texts.source_of(one)));
  }
}

TEST(Html, DetailsHoldEveryDisagreement) {
  for (const CaseResults& one : sample::results().cases) {
    const json shown = sample::details_of(one);
    EXPECT_EQ(shown["figure"].size(), one.figure.marks.size());
    ASSERT_EQ(shown["results"].size(), one.results.size());
    for (std::size_t r = 0; r < one.results.size(); ++r) {
      const json& answer = shown["answers"][shown["results"][r]["answer"].get<std::size_t>()];
      ASSERT_EQ(answer["disagreements"].size(), one.results[r].disagreements.size());
      const auto worst = worst_first(one.results[r]);
      for (std::size_t d = 0; d < worst.size(); ++d)
        EXPECT_EQ(answer["disagreements"][d]["x"], worst[d]->x);
    }
  }
}

// The last of more than there is room for is the only violation.
TEST(Html, DetailsBeginWithWhatIsNotAllowed) {
  CaseResults one;
  one.results.resize(1);
  auto& list = one.results[0].disagreements;
  list.assign(kMaxDisagreementsPerAnswer + 2,
              sample::disagreement(0, 0, DisagreementKind::extra, true));
  list[list.size() - 1] = sample::disagreement(7, 9, DisagreementKind::extra, false);
  list[list.size() - 2] = sample::disagreement(6, 9, DisagreementKind::extra, false);
  list[list.size() - 2].legality = Legality::contested;
  const json shown = sample::details_of(one)["answers"][0]["disagreements"];
  EXPECT_EQ(shown[0]["legality"], "illegal");
  EXPECT_EQ(shown[0]["x"], 7);
  EXPECT_EQ(shown[1]["legality"], "contested");
  EXPECT_EQ(shown[2]["legality"], "legal");
}

TEST(Html, CasesHaveTheirPlaceAmongThoseThatDiffer) {
  Results results = sample::large_run(3, 1);
  const Verdict verdicts[] = {Verdict::agree, Verdict::contested, Verdict::violation};
  for (std::size_t i = 0; i < 3; ++i) results.cases.answer(i, 0).verdict = verdicts[i];
  EXPECT_EQ(sample::index_of(results)["order"], json({2, 1}));
}

TEST(Html, FindingsAreToldByRuleAsTheWorstOfEach) {
  CaseResults one;
  one.id = "lines/a:dx=1";
  one.results.resize(1);
  Result& result = one.results[0];
  const auto add = [&](const char* rule, bool legal, const char* cause) {
    Disagreement d = sample::disagreement(0, 0, DisagreementKind::extra, legal);
    d.rule = rule_named(rule);
    d.cause = cause_named(cause);
    result.disagreements.push_back(d);
  };
  add("line.joint", true, "line.diamond-exit=open");
  add("line.snap", true, "line.diamond-exit=open");
  add("line.snap", true, "line.diamond-exit=closed");
  add("line.width", true, "");
  add("line.width", false, "line.diamond-exit=open");
  Results results;
  results.renderers.resize(1);
  results.cases.push_back(one);
  ReportTexts texts;
  texts.is_open_choice = [](const Cause& cause) { return cause == "line.diamond-exit=open"; };
  const json index = sample::index_of(results, texts);
  EXPECT_EQ(index["outcomes"][0][2], json({0, "convention", 1, "permitted", 2, "violation"}));
  EXPECT_EQ(index["names"], json({"line.joint", "line.snap", "line.width"}));
  result.disagreements.back().legality = Legality::contested;
  results.cases.replace(0, one);
  EXPECT_EQ(sample::index_of(results, texts)["outcomes"][0][2],
            json({0, "convention", 1, "permitted", 2, "contested"}));
  results.latitude = Latitude::none;
  EXPECT_EQ(sample::index_of(results, texts)["outcomes"][0][2],
            json({0, "violation", 1, "violation", 2, "violation"}));
}

TEST(Html, CasesInWhichAllAgreesAreALineOfTheList) {
  Results results;
  results.renderers.resize(2);
  CaseResults one;
  one.pixels = Bytes(64, 255);
  one.results.resize(2);
  for (Result& result : one.results) result.verdict = Verdict::agree;
  results.cases.push_back(one);
  EXPECT_TRUE(report_data(results, {}).blocks.empty());
  results.cases.answer(0, 1).standing = Standing::flake;
  EXPECT_EQ(report_data(results, {}).blocks.size(), 1u);
  one.expect_failures = {"drawn otherwise"};
  results.cases.replace(0, one);
  EXPECT_EQ(report_data(results, {}).blocks.size(), 1u);
}

// Noise, so that it cannot be deflated.
Results large_results() {
  Results results;
  results.renderers.resize(1);
  std::uint32_t state = 1;
  for (int i = 0; i < 40; ++i) {
    CaseResults one;
    one.id = "noise/" + std::to_string(100 + i);
    one.width = one.height = 128;
    Bytes pixels(4 * 128 * 128);
    for (std::uint8_t& byte : pixels)
      byte = static_cast<std::uint8_t>((state = state * 1664525 + 1013904223) >> 24);
    one.pixels = pixels;
    one.results.resize(1);
    one.results[0].verdict = i == 39 ? Verdict::violation : Verdict::permitted;
    results.cases.push_back(one);
  }
  return results;
}

TEST(Html, WhatIsTooLargeStandsBesideThePageTheWorstWithinIt) {
  const Results results = large_results();
  const auto files = html_files(results, {}, "all.html", Beyond::in_scripts, 1'000'000);
  ASSERT_GT(files.size(), 2u);
  EXPECT_EQ(files[0].name, "all.html");
  EXPECT_LT(files[0].text.size(), 1'400'000u);
  const json index = json::parse(data_of(files[0].text));
  ASSERT_EQ(index["chunks"].size(), files.size() - 1);
  EXPECT_EQ(index["cases"][39][4], 0) << "the violation is the first line";
  std::size_t blocks = count(files[0].text, "id=\"block-");
  for (std::size_t i = 1; i < files.size(); ++i) {
    EXPECT_EQ(files[i].name, "all." + std::to_string(i) + ".js");
    EXPECT_EQ(index["chunks"][i - 1], json({{"name", files[i].name}, {"first", blocks}}));
    EXPECT_EQ(files[i].text.rfind("edgecaseBlocks(\"" + index["key"].get<std::string>() + "\",", 0),
              0u);
    EXPECT_LT(files[i].text.size(), 2'000'000u);
    blocks += count(files[i].text, "\",\n");
  }
  EXPECT_EQ(blocks, index["blocks"].size());
  EXPECT_EQ(index["here"], count(files[0].text, "id=\"block-"));
  EXPECT_NE(files[0].text.find("'strict-dynamic'"), std::string::npos);
  EXPECT_EQ(page_of(results).find("strict-dynamic"), std::string::npos);
}

TEST(Html, WhatIsTooLargeIsLeftOutUnlessItIsAskedFor) {
  const auto files = html_files(large_results(), {}, "all.html", Beyond::left_out, 1'000'000);
  ASSERT_EQ(files.size(), 1u);
  const json index = json::parse(data_of(files[0].text));
  EXPECT_TRUE(index["chunks"].empty());
  EXPECT_EQ(index["here"], count(files[0].text, "id=\"block-"));
  EXPECT_LT(index["here"], index["blocks"].size()) << "the list names what is left out";
  EXPECT_EQ(files[0].text.find("strict-dynamic"), std::string::npos);
}

TEST(Html, RenderersHoldTheirClusters) {
  const Results results = sample::results();
  const json data = sample::index_of(results);
  std::size_t all = 0;
  for (std::size_t r = 0; r < results.renderers.size(); ++r) {
    const std::vector<Cluster> clusters = clusters_of(results, r);
    const json& shown = data["renderers"][r]["clusters"];
    ASSERT_EQ(shown.size(), clusters.size());
    for (std::size_t i = 0; i < clusters.size(); ++i) {
      EXPECT_EQ(shown[i]["cause"], clusters[i].cause);
      EXPECT_EQ(shown[i]["legality"], name_of(clusters[i].legality));
      EXPECT_EQ(shown[i]["disagreements"], clusters[i].disagreements);
      EXPECT_EQ(shown[i]["smallest"], clusters[i].smallest_case);
    }
    all += clusters.size();
  }
  EXPECT_GT(all, 3U);
}

TEST(Html, ValuesHaveTheirMeanAndTheirShareOfTheRange) {
  int seen = 0;
  for (const CaseResults& one : sample::results().cases) {
    const json shown = sample::details_of(one);
    for (const json& answer : shown["answers"])
      for (const json& values : answer["values"]) {
        ++seen;
        EXPECT_EQ(values["components"], 4 * values["compared"].get<std::uint64_t>());
        EXPECT_EQ(values["mean_ulp"], 0.375);
        EXPECT_EQ(values["relative"], 0x1p-20);
        EXPECT_EQ(values["worst"]["ulp"], 5.5);
      }
  }
  EXPECT_GT(seen, 0);
}

TEST(Html, NoTextLeavesTheDataElement) {
  const std::string page = page_of(sample::results());
  EXPECT_EQ(data_of(page).find('<'), std::string::npos);
  const json data = json::parse(data_of(page));
  EXPECT_EQ(count(page, "<script"), 2 + data["blocks"].size());
  EXPECT_EQ(count(page, "</script"), 2 + data["blocks"].size());
  const auto hostile = [](const json& head) {
    return head["title"].get<std::string>().rfind("</script><script>", 0) == 0;
  };
  EXPECT_TRUE(std::any_of(data["heads"].begin(), data["heads"].end(), hostile));
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
  const Results results = sample::results();
  for (const CaseResults& given : results.cases) {
    if (given.id != "lines/octant-00") continue;
    const json one = sample::details_of(given);
    EXPECT_EQ(one["answers"].size(), 2u);
    EXPECT_EQ(one["results"][2]["answer"], 0);
  }
}

TEST(Html, AnImageOfAnotherSizeIsNeverShownAsEqual) {
  CaseResults one;
  one.pixels = Bytes(16, 255);
  one.results.resize(1);
  for (std::size_t bytes : {std::size_t{0}, std::size_t{12}, std::size_t{20}}) {
    one.results[0].pixels = Bytes(bytes, 255);
    EXPECT_EQ(sample::details_of(one)["answers"][0]["blank"], true);
  }
}

TEST(Html, LeftOutDisagreementsAreCounted) {
  CaseResults one;
  one.results.resize(1);
  one.results[0].disagreements.assign(kMaxDisagreementsPerAnswer + 7,
                                      sample::disagreement(0, 0, DisagreementKind::extra, false));
  const json answer = sample::details_of(one)["answers"][0];
  EXPECT_EQ(answer["disagreements"].size(), kMaxDisagreementsPerAnswer);
  EXPECT_EQ(answer["omitted"], 7);
}

// In the form of the results file, and no farther than disagreements are listed.
TEST(Html, FragmentsStandAtThePixelsThatAreListed) {
  CaseResults one;
  one.results.resize(1);
  Result& result = one.results[0];
  result.exact_fragments.resize(2);
  result.exact_fragments[0].fragment = {3, 0, 4, 5, 0.5, {0, 0.25, 1, 1}};
  result.exact_fragments[1].fragment = {0, 1, 4, 1, 0, {}, false, false};
  result.exact_fragments[1].pass = 2;
  json fragments = sample::details_of(one)["answers"][0]["fragments"];
  EXPECT_EQ(fragments["exact"], json::parse("[[3,0,4,5,0.5,[0,0.25,1,1]],[0,1,4,1,null,null,2]]"));
  EXPECT_EQ(fragments["rendered"], json::array());
  result.disagreements.assign(kMaxDisagreementsPerAnswer + 1,
                              sample::disagreement(3, 0, DisagreementKind::missing, false));
  result.disagreements.back().y = 1;
  fragments = sample::details_of(one)["answers"][0]["fragments"];
  EXPECT_EQ(fragments["exact"].size(), 1u) << "the other's disagreement is left out, too";
  result.exact_fragments.clear();
  EXPECT_FALSE(sample::details_of(one)["answers"][0].contains("fragments"));
}

TEST(Html, ACaseTellsAViewportOfItsOwn) {
  CaseResults one;
  EXPECT_FALSE(sample::details_of(one).contains("viewport"));
  one.viewport = Viewport{-2, 0, 16, 8};
  EXPECT_EQ(sample::details_of(one)["viewport"], json::parse("[-2,0,16,8]"));
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

}  // namespace
}  // namespace edgecase
