// SPDX-License-Identifier: MIT
//
// What is long is kept in less room and comes back as it was; what is short stands as it is; what
// is damaged is refused.
#include "results/folding.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>

#include <nlohmann/json.hpp>
#include <random>
#include <sstream>
#include <stdexcept>
#include <tuple>

#include "results/base64.h"
#include "results/deflate.h"
#include "results/results_json.h"
#include "tests/results/sample_results.h"

namespace edgecase {
namespace {

using Json = nlohmann::ordered_json;
using Places = std::vector<ValueAggregate::Place>;

bool is_same(const Places& a, const Places& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& p, const auto& q) {
    return std::tie(p.x, p.y, p.primitive) == std::tie(q.x, q.y, q.primitive);
  });
}

// Every pixel of a square, once for each of two primitives that share it by columns.
Places places_of_square(int size) {
  Places places;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) places.push_back({x, y, x < size / 2 ? 7 : 2});
  return places;
}

// As the file has them.
nlohmann::json read_back(const Json& json) {
  return nlohmann::json::parse(json.dump());
}

// The value behind another one, which must stay as it is.
Json folded(const Json& json) {
  const std::string before = "[1,";
  std::string text = before + json.dump();
  fold(text, before.size());
  EXPECT_TRUE(text.starts_with(before));
  return Json::parse(text.substr(before.size()));
}

Json places_json(const Places& places) {
  std::string text;
  JsonWriter json(text);
  write_places(json, places);
  return Json::parse(text);
}

TEST(Base64, ReadsBackBytesOfEveryLength) {
  std::mt19937 random(1);
  for (std::size_t size = 0; size < 70; ++size) {
    std::vector<std::uint8_t> bytes(size);
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random());
    EXPECT_EQ(from_base64(to_base64(bytes)), bytes);
  }
  // RFC 4648, section 10.
  EXPECT_EQ(from_base64("Zm9vYg=="), (std::vector<std::uint8_t>{'f', 'o', 'o', 'b'}));
  for (const char* bad : {"Zm9", "Zm9*", "Z===", "Zm=v", "Zm9vYg==Zm9v", "Zm9v\n"})
    EXPECT_THROW(from_base64(bad), std::runtime_error) << bad;
}

TEST(Folding, LeavesAloneWhatIsShort) {
  for (const Json& json : {Json("exact"), Json::array(), Json({{"a", 1}}),
                           Json(std::string(kLongest - 2, 'a')), Json(3)}) {
    EXPECT_EQ(folded(json), json);
    EXPECT_EQ(unfolded(read_back(json)), read_back(json));
  }
}

TEST(Folding, KeepsWhatIsLongInLessRoom) {
  Json list = Json::array();
  for (int i = 0; i < 20000; ++i) list.push_back({{"pixel", {i % 512, i / 512}}, {"é", "\"\n"}});
  for (const Json& json : {list, Json(std::string(kLongest - 1, 'a'))}) {
    const Json fold = folded(json);
    ASSERT_TRUE(fold.is_string());
    EXPECT_LT(fold.dump().size(), json.dump().size() / 8);
    EXPECT_EQ(unfolded(read_back(fold)), read_back(json));
  }
}

TEST(Folding, RefusesADamagedFold) {
  Json squares = Json::array();
  for (int i = 0; i < 20000; ++i) squares.push_back(i * i % 30011);
  const std::string fold = folded(squares).get<std::string>();
  EXPECT_THROW(unfolded(nlohmann::json("zlib:")), std::runtime_error);
  EXPECT_THROW(unfolded(nlohmann::json("zlib:AAAA")), std::runtime_error);
  EXPECT_THROW(unfolded(nlohmann::json(fold.substr(0, fold.size() / 8 * 4))), std::runtime_error);
  std::string garbled = fold;
  garbled[fold.size() / 2] = garbled[fold.size() / 2] == 'A' ? 'B' : 'A';
  EXPECT_THROW(unfolded(nlohmann::json(garbled)), std::exception);
}

TEST(Folding, WritesManyPlacesAsRuns) {
  const Places few = places_of_square(31);
  ASSERT_LE(few.size(), kMostPlaces);
  EXPECT_EQ(places_json(few).size(), few.size());
  const Places many = places_of_square(40);
  const Json runs = places_json(many);
  EXPECT_EQ(runs.size(), 80u);
  EXPECT_EQ(runs[0], Json({20, 0, 2, 20}));
  EXPECT_EQ(runs[79], Json({0, 39, 7, 20}));
  for (const Places& places : {few, many, Places{}})
    EXPECT_TRUE(is_same(to_places(read_back(places_json(places))), places));
}

// Whatever is left out, and whatever order they stand in.
TEST(Folding, ReadsBackAnyPlaces) {
  std::mt19937 random(2);
  for (int round = 0; round < 50; ++round) {
    Places places = places_of_square(50);
    std::erase_if(places, [&](const auto&) { return random() % 3 == 0; });
    if (round % 5 == 1) std::swap(places[3], places[700]);
    if (round % 5 == 2) places.insert(places.begin() + 5, places[5]);
    ASSERT_GT(places.size(), kMostPlaces);
    EXPECT_TRUE(is_same(to_places(read_back(places_json(places))), places)) << round;
  }
}

// A large picture, and one that differs from it in a single byte.
// A few characters must not ask for more memory than there is.
TEST(Folding, RefusesRunsThatNoTargetHas) {
  const auto places = [](const std::string& text) {
    return to_places(nlohmann::json::parse(text)).size();
  };
  EXPECT_EQ(places("[[0, 0, 0, 4096]]"), 4096U);
  for (const char* text : {"[[0, 0, 0, 4097]]", "[[0, 0, 0, 0]]", "[[0, 0, 0, -1]]",
                           "[[2147483647, 0, 0, 2]]", "[[0, 0, 0, 2000000000]]", "[[0.5, 0, 0]]"})
    EXPECT_THROW(places(text), std::runtime_error) << text;
  std::string many = "[[0, 0, 0, 4096]";
  for (int i = 0; i < 4096; ++i) many += ", [0, 0, 0, 4096]";
  EXPECT_THROW(places(many + "]"), std::runtime_error);
}

TEST(Folding, KeepsLargeResultsSmall) {
  Results results = results_with({Verdict::permitted});
  CaseResults& one = results.cases[0];
  one.width = one.height = 512;
  std::vector<std::uint8_t> pixels;
  for (int i = 0; i < 4 * 512 * 512; ++i)
    pixels.push_back(static_cast<std::uint8_t>(i / 2048 % 256));
  one.pixels = pixels;
  pixels[123456] ^= 1;
  Result& result = one.results[0];
  result.pixels = pixels;
  result.values.emplace_back().differing = places_of_square(512);
  std::ostringstream out;
  write_results(results, out);
  EXPECT_LT(out.str().size(), 100000u);
  const auto read = read_results(out.str());
  ASSERT_TRUE(std::holds_alternative<Results>(read)) << std::get<std::string>(read);
  const CaseResults& back = std::get<Results>(read).cases[0];
  EXPECT_EQ(back.pixels, one.pixels);
  EXPECT_EQ(back.results[0].pixels, result.pixels);
  EXPECT_TRUE(is_same(back.results[0].values[0].differing, result.values[0].differing));
}

// However much there is to tell of them.
TEST(Folding, LeavesAloneWhatIsLongInResultsOfSmallCases) {
  Results results = results_with({Verdict::permitted});
  Result& result = results.cases[0].results[0];
  result.values.emplace_back().differing = places_of_square(40);
  result.disagreements[0].explanation = std::string(kLongest, 'a');
  std::ostringstream out;
  write_results(results, out);
  EXPECT_EQ(out.str().find("zlib:"), std::string::npos);
  EXPECT_NE(out.str().find(R"("differing":[[0,0,7],[1,0,7],)"), std::string::npos);
}

// A few bytes may stand for very many.
TEST(Deflate, InflatesNoMoreThanIsAllowed) {
  const std::string text(200'000, 'a');
  const std::vector<std::uint8_t> bytes = deflated(text);
  ASSERT_LT(bytes.size(), 1000u);
  EXPECT_EQ(inflated(bytes), text);
  EXPECT_EQ(inflated(bytes, text.size()), text);
  EXPECT_THROW(inflated(bytes, text.size() - 1), std::runtime_error);
  EXPECT_THROW(inflated(bytes, 0), std::runtime_error);
}

}  // namespace
}  // namespace edgecase
