// SPDX-License-Identifier: MIT
//
// Fragments as bytes: neighbours go as a run where the same is told of them, and only there; runs
// that no worker writes are refused.
#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "tests/wire/scenes.h"
#include "wire/message.h"

namespace edgecase {
namespace {

using ::testing::HasSubstr;

using Fragments = std::vector<Fragment>;
using Change = std::function<void(Fragments&)>;

constexpr std::uint64_t kDigest = 0x0123456789abcdef;
constexpr const char* kLineDigest = "0123456789abcdef";
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// Of an 8x2 target: equal fragments at all pixels of a row, of which `change` makes others.
Rendering row_of(const Change& change) {
  Rendering rendering;
  rendering.width = 8;
  rendering.height = 2;
  rendering.pixels.resize(64, 3);
  Fragment fragment;
  fragment.depth = 0.5;
  fragment.color = {0.25, 0, 1, -2};
  rendering.fragments.assign(8, fragment);
  for (int x = 0; x < 8; ++x) rendering.fragments[static_cast<std::size_t>(x)].x = x;
  change(rendering.fragments);
  return rendering;
}

Scene row_scene() {
  Scene scene = small_scene();
  scene.target.width = 8;
  scene.target.height = 2;
  return scene;
}

Rendering read_back(const Scene& scene, const Rendering& rendering) {
  auto parsed = parse_answer_message(answer_message(kDigest, rendering, false, nullptr), kDigest,
                                     scene, false);
  if (const auto* error = std::get_if<WireError>(&parsed)) ADD_FAILURE() << error->message;
  return std::get<Rendering>(std::get<Answer>(parsed).outcome);
}

void expect_to_be_read_as_from_a_line(const Scene& scene, const Rendering& rendering) {
  const auto line = parse_answer(answer_line(kLineDigest, rendering, nullptr), kLineDigest, scene);
  ASSERT_TRUE(std::holds_alternative<Answer>(line)) << std::get<WireError>(line).message;
  const auto& from_line = std::get<Rendering>(std::get<Answer>(line).outcome);
  EXPECT_EQ(answer_line("", read_back(scene, rendering), nullptr),
            answer_line("", from_line, nullptr));
}

TEST(SentFragments, TellNeighboursApartThatDifferInAnything) {
  const Change changes[] = {
      [](Fragments&) {},
      [](Fragments& f) { f[3].depth = 0.25; },
      [](Fragments& f) { f[3].depth = 0.1; },
      [](Fragments& f) { f[3].color[3] = 2; },
      [](Fragments& f) { f[3].color[1] = -0.0; },
      [](Fragments& f) { f[3].color[0] = f[4].color[0] = kNaN; },
      [](Fragments& f) { f[3].color[0] = -kNaN; },
      [](Fragments& f) { f[3].color[2] = std::numeric_limits<double>::infinity(); },
      [](Fragments& f) { f[3].has_color = f[4].has_color = false; },
      [](Fragments& f) { f[7].has_depth = false; },
      [](Fragments& f) { f[0].has_depth = f[0].has_color = false; },
      [](Fragments& f) { f[3].primitive = 1; },
      [](Fragments& f) { f[4].y = f[5].y = f[6].y = f[7].y = 1; },
      [](Fragments& f) { f.erase(f.begin() + 3); },
      [](Fragments& f) { f.insert(f.begin() + 3, f[3]); },
      [](Fragments& f) { std::reverse(f.begin(), f.end()); },
      [](Fragments& f) { f.clear(); },
  };
  for (const Change& change : changes)
    expect_to_be_read_as_from_a_line(row_scene(), row_of(change));
}

TEST(SentFragments, TellTheSamplesOfEachNeighbour) {
  Scene scene = row_scene();
  scene.target.samples = 4;
  Rendering rendering = row_of([](Fragments& f) { f[3].coverage = f[4].coverage = 15; });
  rendering.samples = 4;
  std::vector<std::uint32_t> coverage;
  for (const Fragment& fragment : read_back(scene, rendering).fragments)
    coverage.push_back(fragment.coverage);
  EXPECT_EQ(coverage, (std::vector<std::uint32_t>{1, 1, 1, 15, 15, 1, 1, 1}));
}

TEST(SentFragments, TellTheDetailOfEachNeighbour) {
  Scene scene = row_scene();
  scene.details.coordinates = true;
  Rendering rendering = row_of([](Fragments& f) {
    for (int x = 2; x < 6; ++x) f[static_cast<std::size_t>(x)].detail = 5 - x;
  });
  rendering.details.resize(4);
  for (std::size_t i = 0; i < 4; ++i) {
    if (i == 1) continue;  // it tells nothing
    rendering.details[i].coordinates = {static_cast<double>(i), -0.0, 0, 1};
  }
  expect_to_be_read_as_from_a_line(scene, rendering);
}

TEST(SentFragments, AreShortWhereNeighboursAreAlike) {
  constexpr std::size_t kRun = 44;
  const auto length = [](const Change& change) {
    return answer_message(kDigest, row_of(change), false, nullptr).size();
  };
  const std::size_t empty = length([](Fragments& f) { f.clear(); });
  EXPECT_EQ(length([](Fragments&) {}), empty + kRun);
  EXPECT_EQ(length([](Fragments& f) { f[3].color[0] = 0; }), empty + 3 * kRun);
  EXPECT_EQ(length([](Fragments& f) { f[3].color[0] = f[4].color[0] = kNaN; }), empty + 3 * kRun);
  EXPECT_EQ(length([](Fragments& f) { f.erase(f.begin() + 3); }), empty + 2 * kRun);
}

// A message in which every run of which so much is told, and that has one fragment, has `length`.
std::string with_lengths(std::string message, std::uint32_t told, std::uint32_t length) {
  const std::array<std::uint32_t, 2> before{told, 1};
  std::string pattern(sizeof(before), 0);
  std::memcpy(pattern.data(), before.data(), sizeof(before));
  std::size_t changed = 0;
  for (std::size_t at = message.find(pattern); at != std::string::npos;
       at = message.find(pattern, at + sizeof(before)), ++changed)
    std::memcpy(&message[at + sizeof(told)], &length, sizeof(length));
  EXPECT_GT(changed, 0U);
  return message;
}

std::string refusal_of_bytes(const Scene& scene, const std::string& message) {
  return fault_in(parse_answer_message(message, kDigest, scene, false));
}

constexpr std::uint32_t kDepthAndColor = 3;
constexpr std::uint32_t kAndDetail = 7;

TEST(SentFragments, WithRunsThatLeaveTheirRowAreRefused) {
  const Rendering rendering = row_of([](Fragments& f) { f.assign(1, f[3]); });
  const std::string good = answer_message(kDigest, rendering, false, nullptr);
  EXPECT_EQ(refusal_of_bytes(row_scene(), with_lengths(good, kDepthAndColor, 5)), "");
  for (const std::uint32_t length : {6U, 8U, 0x7fffffffU, 0x80000000U, 0xffffffffU})
    EXPECT_THAT(refusal_of_bytes(row_scene(), with_lengths(good, kDepthAndColor, length)),
                HasSubstr("outside the target"));
  EXPECT_THAT(refusal_of_bytes(row_scene(), with_lengths(good, kDepthAndColor, 0)),
              HasSubstr("a run has 0 fragments"));
}

TEST(SentFragments, WithARunOfDetailsAreRefused) {
  Scene scene = row_scene();
  scene.details.coordinates = true;
  Rendering rendering = row_of([](Fragments& f) {
    f.resize(1);
    f[0].detail = 0;
  });
  rendering.details.resize(1);
  rendering.details[0].coordinates.emplace();
  const std::string good = answer_message(kDigest, rendering, false, nullptr);
  EXPECT_EQ(refusal_of_bytes(scene, good), "");
  EXPECT_THAT(refusal_of_bytes(scene, with_lengths(good, kAndDetail, 2)),
              HasSubstr("a run has 2 fragments"));
}

// Two hundred kilobytes ask for a gibibyte, and for one row more.
TEST(SentFragments, WithMoreFragmentsThanThereMayBeAreRefused) {
  Scene scene = row_scene();
  scene.target.width = 4096;
  Rendering rendering = row_of([](Fragments& f) { f.assign(4097, f[0]); });
  rendering.width = 4096;
  rendering.pixels.resize(std::size_t{8} * 4096);
  const std::string good = answer_message(kDigest, rendering, false, nullptr);
  EXPECT_EQ(refusal_of_bytes(scene, good), "");
  EXPECT_THAT(refusal_of_bytes(scene, with_lengths(good, kDepthAndColor, 4096)),
              HasSubstr("more than 16777216 fragments"));
}

}  // namespace
}  // namespace edgecase
