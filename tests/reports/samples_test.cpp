// SPDX-License-Identifier: MIT
//
// What reports tell of the samples of multisampled cases.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <numeric>
#include <sstream>

#include "reports/base64.h"
#include "reports/junit.h"
#include "reports/pixels.h"
#include "reports/sample_data.h"
#include "reports/summary.h"
#include "reports/text.h"
#include "tests/reports/sample.h"
#include "tests/reports/shown.h"

namespace edgecase {
namespace {

using nlohmann::json;

Results only(const CaseResults& one) {
  Results results;
  results.renderers.resize(one.results.size());
  for (std::size_t r = 0; r < one.results.size(); ++r)
    results.renderers[r].name = "r" + std::to_string(r);
  results.cases.push_back(one);
  return results;
}

json shown_case() {
  return sample::details_of(sample::multisampled_case());
}

json answer_of(const json& one, std::size_t renderer) {
  return one["answers"][one["results"][renderer]["answer"].get<std::size_t>()];
}

// A small image with another number everywhere.
SampleImage counted_image() {
  SampleImage image;
  image.samples = 2;
  Bytes pixels(2 * 3 * 4);
  std::iota(pixels.begin(), pixels.end(), std::uint8_t{0});
  image.pixels = pixels;
  std::vector<std::uint32_t> hits(2 * 3);
  std::iota(hits.begin(), hits.end(), 0x01020300U);
  image.hits = hits;
  image.coverage = std::vector<std::uint32_t>{1, 2, 3};
  return image;
}

std::string packed(const Bytes& bytes) {
  return to_base64(pack_pixels(bytes));
}

TEST(SampleData, SamplesOfAPixelStandTogether) {
  const json data = sample_data(counted_image());
  EXPECT_EQ(data["count"], 2);
  EXPECT_EQ(data["pixels"], packed({0,  1,  2,  3,  12, 13, 14, 15, 4,  5,  6,  7,
                                    16, 17, 18, 19, 8,  9,  10, 11, 20, 21, 22, 23}));
  EXPECT_EQ(data["hits"],
            packed({0, 3, 2, 1, 3, 3, 2, 1, 1, 3, 2, 1, 4, 3, 2, 1, 2, 3, 2, 1, 5, 3, 2, 1}));
  EXPECT_EQ(data["coverage"], packed({1, 0, 0, 0, 2, 0, 0, 0, 3, 0, 0, 0}));
  EXPECT_FALSE(data.contains("positions"));
}

TEST(SampleData, ADifferenceIsThatOfEachItem) {
  const SampleImage from = counted_image();
  SampleImage image = from;
  Bytes pixels = from.pixels->bytes();
  pixels[13] ^= 0x40;  // sample 1 of the first pixel
  image.pixels = pixels;
  image.coverage = std::vector<std::uint32_t>{1, 2, 3 ^ 2};
  const json data = sample_difference(image, from);
  Bytes expected(24, 0);
  expected[5] = 0x40;
  EXPECT_EQ(data["pixels"], packed(expected));
  EXPECT_EQ(data["hits"], packed(Bytes(24, 0)));
  EXPECT_EQ(data["coverage"], packed({0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 0, 0}));
}

TEST(SampleData, WhatOneSideDoesNotTellIsLeftOut) {
  SampleImage image = counted_image();
  image.hits = {};
  EXPECT_FALSE(sample_difference(image, counted_image()).contains("hits"));
  EXPECT_FALSE(sample_difference(counted_image(), image).contains("hits"));
  EXPECT_TRUE(sample_difference(counted_image(), image).contains("pixels"));
}

TEST(ReportSamples, CasesTellTheirSamplesAndPositions) {
  const json one = shown_case();
  EXPECT_EQ(one["samples"]["count"], 4);
  EXPECT_EQ(one["samples"]["positions"],
            json({0.375, 0.125, 0.875, 0.375, 0.125, 0.625, 0.625, 0.875}));
  EXPECT_EQ(one["samples"], json(sample_data(sample::multisampled_case().samples)));
  for (const CaseResults& given : sample::results().cases) {
    const json other = sample::details_of(given);
    EXPECT_EQ(other.contains("samples"), given.id == "samples/diagonal");
    for (const json& answer : other["answers"])
      EXPECT_EQ(answer.contains("samples"), given.id == "samples/diagonal");
  }
}

TEST(ReportSamples, AnAnswerIsToldByItsDifferenceFromTheExactThatItWasHeldAgainst) {
  const CaseResults given = sample::multisampled_case();
  const json one = shown_case();
  EXPECT_FALSE(answer_of(one, 0).contains("exact"));
  EXPECT_EQ(answer_of(one, 1)["samples"],
            json(sample_difference(given.results[1].samples, given.samples)));
  const json elsewhere = answer_of(one, 2);
  EXPECT_FALSE(elsewhere.contains("difference")) << "it agrees with its own exact";
  EXPECT_EQ(elsewhere["exact"]["difference"],
            packed(difference_of(given.pixels->bytes(), given.results[2].exact_pixels->bytes())));
  EXPECT_EQ(elsewhere["exact"]["samples"],
            json(sample_difference(given.results[2].exact_samples, given.samples)));
  EXPECT_EQ(elsewhere["samples"]["pixels"], packed(Bytes(4 * given.samples.pixels->size(), 0)));
  EXPECT_NE(elsewhere["samples"]["positions"], one["samples"]["positions"]);
  EXPECT_FALSE(answer_of(one, 3)["samples"].contains("positions"));
  EXPECT_FALSE(answer_of(one, 3)["samples"].contains("hits"));
}

TEST(ReportSamples, ADisagreementNamesItsSampleSampleZeroToo) {
  const json listed = answer_of(shown_case(), 1)["disagreements"];
  EXPECT_FALSE(listed[0].contains("sample")) << "it is about the resolved pixel";
  EXPECT_EQ(listed[1]["sample"], 0);
}

TEST(ReportSamples, WithoutMultisamplingNoSampleIsNamed) {
  const Disagreement d = sample::disagreement(3, 4, DisagreementKind::missing, false);
  EXPECT_EQ(place_of(d, 1), "pixel (3, 4)");
  EXPECT_EQ(place_of(d, 4), "pixel (3, 4), sample 0");
  CaseResults one = sample::multisampled_case();
  one.samples = {};
  const json data = sample::details_of(one);
  const json answer = answer_of(data, 1);
  ASSERT_FALSE(answer["disagreements"].empty());
  for (const json& listed : answer["disagreements"]) EXPECT_FALSE(listed.contains("sample"));
}

TEST(ReportSamples, TextAndJunitNameTheSample) {
  const Results results = only(sample::multisampled_case());
  const Result missing = results.cases[0].results[1];
  EXPECT_THAT(describe(missing.disagreements[1], 4),
              testing::StartsWith("pixel (3, 3), sample 0, primitive 0, missing, "));
  EXPECT_THAT(describe(missing.disagreements[0], 4),
              testing::StartsWith("pixel (3, 3), value, sample.resolve"));
  std::ostringstream junit;
  write_junit(results, {}, junit);
  EXPECT_THAT(junit.str(), testing::HasSubstr("pixel (3, 3), sample 0, primitive 0, missing"));
  EXPECT_THAT(junit.str(), testing::HasSubstr("pixel (3, 3), value, sample.resolve"));
}

TEST(ReportSamples, TheSummaryNamesTheSample) {
  CaseResults one = sample::multisampled_case();
  std::vector<Disagreement>& listed = one.results[1].disagreements;
  listed.erase(listed.begin());
  const Results results = only(one);
  std::ostringstream summary;
  write_summary(results, false, summary);
  EXPECT_THAT(summary.str(), testing::HasSubstr("pixel (3, 3), sample 0: exact draws sample 0"));
}

}  // namespace
}  // namespace edgecase
