// SPDX-License-Identifier: MIT
//
// What is packed comes back as it was, in little room; what is no packed text is refused.
#include "results/packed_text.h"
#include "results/packed_picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "results/deflate.h"
#include "results/findings_json.h"
#include "results/results_json.h"
#include "results/samples_json.h"
#include "results/shallow_json.h"
#include "tests/results/sample_results.h"

namespace edgecase {
namespace {

using Bytes = std::vector<std::uint8_t>;
using Places = std::vector<ValueAggregate::Place>;
using Words = std::vector<std::uint32_t>;

// (x, y) of each, sorted as packing sorts them.
std::vector<std::pair<int, int>> pixels_of(const Places& places) {
  std::vector<std::pair<int, int>> pixels;
  for (const auto& place : places) pixels.emplace_back(place.y, place.x);
  std::ranges::sort(pixels);
  return pixels;
}

Places places_of_square(int size) {
  Places places;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) places.push_back({x, y, x < size / 2 ? 7 : 2});
  return places;
}

// A few bytes may stand for very many.
TEST(Deflate, InflatesNoMoreThanIsAllowed) {
  const std::string text(200'000, 'a');
  const Bytes bytes = deflated(text);
  ASSERT_LT(bytes.size(), 1000u);
  EXPECT_EQ(inflated(bytes), text);
  EXPECT_EQ(inflated(bytes, text.size()), text);
  EXPECT_THROW(inflated(bytes, text.size() - 1), std::runtime_error);
  EXPECT_THROW(inflated(bytes, 0), std::runtime_error);
}

TEST(PackedText, WordsAreDigitsAndRuns) {
  EXPECT_EQ(packed_words({}), "");
  EXPECT_EQ(packed_words({0, 0, 0, 0xabc, 0xffffffff, 0xffffffff, 7}), "0*3 abc ffffffff*2 7");
  std::mt19937 random(3);
  for (int round = 0; round < 200; ++round) {
    Words words(random() % 40);
    for (std::uint32_t& word : words)
      word = random() % 3 == 0 ? static_cast<std::uint32_t>(random()) : 5U;
    EXPECT_EQ(to_words(packed_words(words), words.size()), words);
  }
}

TEST(PackedText, RefusesWhatIsNoListOfSoManyWords) {
  EXPECT_EQ(to_words("1*3 a", 4), (Words{1, 1, 1, 10}));
  for (const char* text :
       {"1*3", "1*4 a", "1*3 a ", " 1*3 a", "1*3  a", "1*3 g", "1*0 1*4", "1*-4", "-1*4", "1*3 a*",
        "1*99999999999999999999", "123456789 1*3", "1*3,a", "1*3 a*4294967297"})
    EXPECT_THROW(to_words(text, 4), std::runtime_error) << text;
}

// Every byte is what its neighbours foretell, and something: of a plane nothing is left.
TEST(PackedText, PicturesAreWhatNeighboursDoNotForetell) {
  Bytes plane;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x)
      for (const int byte : {3 * x + y, 200 - 2 * x, 5 * y, 255})
        plane.push_back(static_cast<std::uint8_t>(byte));
  EXPECT_LT(packed_picture(plane, 64).size(), 1000u);
  std::mt19937 random(4);
  for (int round = 0; round < 100; ++round) {
    const int width = static_cast<int>(random() % 7);
    const int height = static_cast<int>(random() % 7);
    Bytes pixels(static_cast<std::size_t>(4 * width * height));
    for (std::uint8_t& byte : pixels) byte = static_cast<std::uint8_t>(random());
    EXPECT_EQ(to_picture(packed_picture(pixels, width), width, height).bytes(), pixels);
  }
  // The second pixel of a row has one on its left, the first of the next row one below it.
  EXPECT_EQ(packed_picture({1, 2, 3, 4, 1, 2, 3, 5, 2, 2, 3, 4, 3, 2, 3, 5}, 2),
            "1020304 1 1000000*2");
  EXPECT_THROW(to_picture("0*3", 2, 2), std::runtime_error);
  EXPECT_THROW(to_picture("0*4", -2, -2), std::runtime_error);
  EXPECT_THROW(to_picture("0", 1 << 30, 1 << 30), std::runtime_error);
}

// As they are if all words are read first, and differences are taken of those.
TEST(PackedText, WordsAreKeptAsTheyArePacked) {
  std::mt19937 random(6);
  for (int round = 0; round < 300; ++round) {
    Words words(random() % 40);
    Words others(round % 4 == 0 ? words.size() + 1 : words.size());
    for (Words* list : {&words, &others})
      for (std::uint32_t& word : *list)
        word =
            random() % (1 + static_cast<unsigned>(round) % 9) == 0 ? 0x10203U + random() % 2 : 5U;
    const std::string text = packed_words(words);
    EXPECT_EQ(to_packed_words(text, words.size()), PackedWords(words));
    Words differences = words;
    for (std::size_t i = 0; i < words.size() && others.size() == words.size(); ++i)
      differences[i] ^= others[i];
    EXPECT_EQ(to_difference(text, words.size(), PackedWords(others), WordsAre::numbers),
              PackedWords(differences));
    EXPECT_EQ(to_difference(text, words.size(), PackedWords(bytes_of(others)), WordsAre::pixels),
              PackedWords(bytes_of(differences)));
  }
  EXPECT_EQ(to_picture("ff*1 0*16777215", 4096, 4096).kept(), 2u);
}

TEST(PackedText, PlacesAreRowsOfRuns) {
  EXPECT_EQ(packed_places({}), "");
  EXPECT_EQ(packed_places({{3, 1, 0}, {4, 1, 0}, {9, 1, 2}, {0, 5, 0}}), "y1 3+2 4 y5 0");
  EXPECT_EQ(packed_places({{3, 1, 0}, {3, 1, 7}, {4, 1, 0}, {4, 1, 7}, {5, 1, 1}}), "y1 3+2*2 0");
  EXPECT_LT(packed_places(places_of_square(512)).size(), 6000u);
}

// Whatever is left out, and whatever order they stand in.
TEST(PackedText, ReadsBackAnyPlaces) {
  std::mt19937 random(2);
  for (int round = 0; round < 50; ++round) {
    Places places = places_of_square(40);
    std::erase_if(places, [&](const auto&) { return random() % 3 == 0; });
    if (round % 3 == 1) std::shuffle(places.begin(), places.end(), random);
    for (std::size_t i = places.size() / 2; i > 0 && round % 2 == 0; --i)
      places.push_back(places[random() % places.size()]);
    const Places back = to_places(packed_places(places));
    EXPECT_EQ(pixels_of(back), pixels_of(places)) << round;
    EXPECT_EQ(packed_places(back), packed_places(places));
  }
}

// A few characters must not ask for more memory than there is.
TEST(PackedText, RefusesPlacesThatNoTargetHas) {
  EXPECT_EQ(to_places("y0 0+4096").size(), 4096U);
  for (const char* text :
       {"0", "y0 0+4097", "y0 4096", "y4096 0", "y0 0+0", "y0 0*0", "y0 1 y0 1", "y1 0 y0 0",
        "y0 -1", "y0 0+4096*99999999", "y0  1", "y0 1 ", "y0 1.5", "yes", "y0 4000+90 7"})
    EXPECT_THROW(to_places(text), std::runtime_error) << text;
}

TEST(PackedText, ReadsBackRunsInTheirOrder) {
  const std::vector<PixelRun> runs{{3, 0, 4}, {3, 4, 5}, {3, 2, 9}, {1, 0, 1}, {4095, 4000, 4096}};
  const std::string text = packed_runs(runs);
  EXPECT_EQ(text, "y3 0+4 0 y3 2+7 y1 0 y4095 4000+96");
  EXPECT_EQ(to_runs(text, 4096, 4096), runs);
  EXPECT_EQ(packed_runs({}), "");
  for (const char* wrong : {"0", "y0 0+4097", "y0 9", "y8 0", "y0 0+0", "y0 -1", "y0  1", "y0 0*2"})
    EXPECT_THROW(to_runs(wrong, 8, 8), std::runtime_error) << wrong;
}

TEST(FigureJson, LeavesOutWhatIsUsual) {
  const auto written = [](const Figure& figure) {
    std::string text;
    JsonWriter json(text);
    write_figure(json, figure);
    return text;
  };
  Figure figure{{{MarkRole::vertex, false, {{1.5, 2}}, "(1.5, 2)"},
                 {MarkRole::primitive, true, {{1.5, 2}, {3, 2}, {1.5, 4}}, "0"},
                 {MarkRole::primitive, true, {{1.5, 2}, {3, 2}}, "x"},
                 {MarkRole::vertex, false, {{1.0 / 3, -0.0}}, ""}}};
  const std::string text = written(figure);
  EXPECT_EQ(text, R"({"points":[98304,131072,196608,131072,98304,262144,0.3333333333333333,-0.0],)"
                  R"("marks":[["vertex",[0]],["primitive",[0,1,2]],["primitive",[0,1],true,"x"],)"
                  R"(["vertex",[3]]]})");
  const Figure back = to_figure(parse_line(text));
  EXPECT_EQ(written(back), text);
  EXPECT_EQ(back.marks[0].label, "(1.5, 2)");
  EXPECT_EQ(back.marks[1].points, figure.marks[1].points);
  for (const char* bad : {R"({"points":[0],"marks":[]})", R"({"points":[],"marks":[["edge",[0]]]})",
                          R"({"points":[],"marks":[["ledge",[]]]})", R"({"marks":[]})"})
    EXPECT_ANY_THROW(to_figure(parse_line(bad))) << bad;
}

// Floats in their shortest digits, doubles that are none in theirs.
TEST(ReportedFragments, NumbersComeBackToTheBit) {
  std::mt19937_64 random(5);
  std::vector<Result::ReportedFragment> fragments(400);
  for (auto& told : fragments)
    for (double& value : told.fragment.color) {
      const auto bits = random();
      const double any = std::bit_cast<double>(bits);
      const float narrow = std::bit_cast<float>(static_cast<std::uint32_t>(bits));
      value = random() % 2 == 0 ? any : static_cast<double>(narrow);
      if (std::isnan(value)) value = 0.1;  // which "0.1" would be mistaken for
    }
  std::string text;
  JsonWriter json(text);
  write_fragments(json, fragments);
  const auto back = to_fragments(parse_line(text));
  ASSERT_EQ(back.size(), fragments.size());
  for (std::size_t i = 0; i < back.size(); ++i)
    for (std::size_t c = 0; c < 4; ++c)
      EXPECT_EQ(std::bit_cast<std::uint64_t>(back[i].fragment.color[c]),
                std::bit_cast<std::uint64_t>(fragments[i].fragment.color[c]));
}

TEST(PackedText, RefusesMoreThanThereMayBe) {
  EXPECT_EQ(to_places("y0 0+3*2", 6).size(), 6u);
  EXPECT_THROW(to_places("y0 0+3*2", 5), std::runtime_error);
  EXPECT_THROW(to_places("y0 0+4096*4097"), std::runtime_error);
  const ReadJson fragments = parse_line("[[[0,3],0,0,1,0.5,null]]");
  EXPECT_EQ(to_fragments(fragments, 3).size(), 3u);
  EXPECT_THROW(to_fragments(fragments, 2), std::runtime_error);
}

TEST(ReportedFragments, NeighboursThatAreAlikeAreOne) {
  std::vector<Result::ReportedFragment> fragments;
  for (const int x : {3, 4, 5, 7}) fragments.push_back({{x, 2, 0, 1, 0.5, {0.1f, 0, 0, 1}}, -1});
  fragments.push_back({{8, 2, 1, 1, 0.5, {0.1f, 0, 0, 1}}, -1});
  std::string text;
  JsonWriter json(text);
  write_fragments(json, fragments);
  EXPECT_EQ(text,
            "[[[3,3],2,0,1,0.5,[0.1,0.0,0.0,1.0]],[7,2,0,1,0.5,[0.1,0.0,0.0,1.0]],"
            "[8,2,1,1,0.5,[0.1,0.0,0.0,1.0]]]");
  EXPECT_EQ(to_fragments(parse_line(text)).size(), fragments.size());
  for (const char* bad : {"[[[0,0],0,0,1,0,null]]", "[[[0,5000],0,0,1,0,null]]", "[[0,0]]", "{}",
                          "[[[2147483640,100],0,0,1,0,null]]", "[[0,0,0,1,\"many\",null]]"})
    EXPECT_ANY_THROW(to_fragments(parse_line(bad))) << bad;
}

TEST(PackedText, KeepsLargeResultsSmall) {
  Results results = results_with({Verdict::permitted});
  CaseResults one = results.cases[0];
  one.width = one.height = 512;
  Bytes pixels;
  for (int i = 0; i < 4 * 512 * 512; ++i)
    pixels.push_back(static_cast<std::uint8_t>(i / 2048 % 256));
  one.pixels = pixels;
  pixels[123456] ^= 1;
  Result& result = one.results[0];
  result.pixels = pixels;
  result.values.emplace_back().differing = places_of_square(512);
  results.cases.replace(0, one);
  std::ostringstream out;
  write_results(results, out);
  EXPECT_LT(out.str().size(), 20000u);
  const auto read = read_results(out.str());
  ASSERT_TRUE(std::holds_alternative<Results>(read)) << std::get<std::string>(read);
  const CaseResults back = std::get<Results>(read).cases[0];
  EXPECT_EQ(back.pixels, one.pixels);
  EXPECT_EQ(back.results[0].pixels, result.pixels);
  EXPECT_EQ(pixels_of(back.results[0].values[0].differing), pixels_of(result.values[0].differing));
}

}  // namespace
}  // namespace edgecase
