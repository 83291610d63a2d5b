// SPDX-License-Identifier: MIT
#include "reports/verdict_looks.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <string>

#include "tests/reports/sample.h"
#include "tests/reports/shown.h"

namespace edgecase {
namespace {

using testing::HasSubstr;

// embed_viewer.py reads the table as text, and the script gets it with the page's data.
TEST(VerdictLooks, AreThoseOfThePageAndItsScript) {
  const Results results = sample::results();
  const std::string page =
      html_files(results, sample::texts(), "report.html", Beyond::left_out).front().text;
  const auto verdicts = sample::index_of(results)["verdicts"];
  EXPECT_EQ(verdicts.size(), values_of<Verdict>().size());
  int rank = static_cast<int>(kVerdictLooks.size());
  for (const auto& [verdict, meaning, icon, sign, ink, ground, heat, terminal] : kVerdictLooks) {
    const std::string name = name_of(verdict);
    EXPECT_EQ(verdicts[name],
              nlohmann::json({{"rank", --rank}, {"path", icon}, {"means", meaning}}));
    const auto expect_color = [&](const std::string& variable, const PageColor& color) {
      const std::size_t light = page.find(variable + ": " + color.light + ";");
      ASSERT_NE(light, std::string::npos) << variable;
      EXPECT_NE(page.find(variable + ": " + color.dark + ";", light + 1), std::string::npos);
    };
    expect_color("--" + name, ink);
    expect_color("--" + name + "-bg", ground);
    if (verdict != Verdict::not_run) expect_color("--heat-" + name, heat);
    EXPECT_THAT(page, HasSubstr(".cell.v-" + name + "::before { content: \"\\" + sign + "\""));
    for (const char* start : {".b-", ".v-", ".f-"})
      EXPECT_THAT(page, HasSubstr(start + name + " {"));
  }
}

// As the counts of pixels have it.
TEST(VerdictLooks, OfADifferenceDependOnTheLatitude) {
  Results results = sample::results();
  EXPECT_EQ(sample::index_of(results)["judged"],
            nlohmann::json({{"legal", {"permitted", "convention"}},
                            {"contested", {"contested", "contested"}},
                            {"illegal", {"violation", "violation"}}}));
  results.latitude = Latitude::none;
  EXPECT_EQ(sample::index_of(results)["judged"]["legal"][1], "violation");
}

}  // namespace
}  // namespace edgecase
