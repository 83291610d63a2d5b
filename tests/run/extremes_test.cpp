// SPDX-License-Identifier: MIT
//
// A limit to every doubt: exact's drawings of the suite with one thing of each driven to an
// extreme, as no reading of the specification excuses it. Whatever shows the extreme breaks a
// ruling that is not contested.
#include <gtest/gtest.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "diff/compare.h"
#include "diff/judge.h"
#include "raster/rasterizer.h"
#include "run/selection.h"

namespace edgecase {
namespace {

using Spoil = std::function<void(const Scene&, Rendering&)>;

struct Extreme {
  std::string name;
  Spoil spoil;
};

void fill(std::vector<std::uint8_t>& codes, const std::function<int(std::size_t)>& code) {
  for (std::size_t i = 0; i < codes.size(); ++i) codes[i] = static_cast<std::uint8_t>(code(i));
}

int noise(std::size_t i) {
  return static_cast<int>((i * 2654435761u >> 7) & 0xff);
}

// All places where colours are told.
Spoil on_pictures(const std::function<int(std::size_t)>& code) {
  return [=](const Scene&, Rendering& drawn) {
    fill(drawn.pixels, code);
    fill(drawn.sample_pixels, code);
    for (std::size_t i = 0; i < drawn.accumulated.size(); ++i)
      drawn.accumulated[i] = code(i) / 255.0;
  };
}
// The picture alone.
Spoil on_pixels(const std::function<int(std::size_t)>& code) {
  return [=](const Scene&, Rendering& drawn) { fill(drawn.pixels, code); };
}
Spoil on_fragments(const std::function<void(Fragment&, std::size_t)>& change) {
  return [=](const Scene&, Rendering& drawn) {
    for (std::size_t i = 0; i < drawn.fragments.size(); ++i) change(drawn.fragments[i], i);
    for (Rendering& pass : drawn.passes)
      for (std::size_t i = 0; i < pass.fragments.size(); ++i) change(pass.fragments[i], i);
  };
}
Spoil on_details(const std::function<void(FragmentDetail&, std::size_t)>& change) {
  return [=](const Scene&, Rendering& drawn) {
    for (std::size_t i = 0; i < drawn.details.size(); ++i) change(drawn.details[i], i);
  };
}
Spoil on_depths(double value) {
  return [=](const Scene&, Rendering& drawn) {
    for (double& depth : drawn.depths) depth = value;
  };
}
Spoil on_chains(float value) {
  return [=](const Scene&, Rendering& drawn) {
    for (auto& [number, levels] : drawn.mip_chains)
      for (std::size_t level = 1; level < levels.size(); ++level)
        for (float& texel : levels[level].texels) texel = value;
  };
}

std::vector<Extreme> extremes() {
  const auto color = [](double value) {
    return on_fragments([=](Fragment& f, std::size_t) { f.color.fill(value); });
  };
  const auto depth = [](double value) {
    return on_fragments([=](Fragment& f, std::size_t) { f.depth = value; });
  };
  const auto level = [](double value) {
    return on_details([=](FragmentDetail& d, std::size_t) {
      if (d.level_of_detail) d.level_of_detail->fill(value);
    });
  };
  return {
      {"black pictures", on_pictures([](std::size_t) { return 0; })},
      {"white pictures", on_pictures([](std::size_t) { return 255; })},
      {"noise for pictures", on_pictures(noise)},
      {"black pixels", on_pixels([](std::size_t) { return 0; })},
      {"white pixels", on_pixels([](std::size_t) { return 255; })},
      {"colours of 0", color(0)},
      {"colours of 1", color(1)},
      {"colours of 100", color(100)},
      {"noise for colours",
       on_fragments([](Fragment& f, std::size_t i) { f.color.fill(noise(i) / 255.0); })},
      {"depths of 0", depth(0)},
      {"depths of 1", depth(1)},
      {"noise for depths",
       on_fragments([](Fragment& f, std::size_t i) { f.depth = noise(i) / 255.0; })},
      {"a buffer of depths of 0", on_depths(0)},
      {"a buffer of depths of 1/3", on_depths(1.0 / 3)},
      {"a level of -100", level(-100)},
      {"a level of 100", level(100)},
      {"chains of 0", on_chains(0)},
      {"chains of 1", on_chains(1)},
      {"chains of 255", on_chains(255)},
  };
}

// "contested 44", or the verdict and the rulings on the values that are permitted.
std::string excuse_of(const Result& result) {
  std::set<int> rulings;
  for (const Disagreement& d : result.disagreements) rulings.insert(d.ruling);
  for (const ValueAggregate& values : result.values) rulings.insert(values.ruling);
  return fmt::format("{} {}", name_of(result.verdict), fmt::join(rulings, " "));
}

// Of a polygon that clipping made, any mean of its vertices' depths is contested (ruling 44), and
// slivers whose vertices may move as far as they are wide may have any depth.
bool is_excused(const std::string& extreme, const std::string& excuse) {
  return extreme.find("depth") != std::string::npos &&
         (excuse == "contested 44" || excuse == "permitted 9" || excuse == "contested 9 44");
}

TEST(Extremes, NoneIsExcused) {
  constexpr std::size_t kStep = 301;
  Selection selection;
  selection.paths = {std::filesystem::path(EDGECASE_ROOT) / "cases"};
  const Suite suite = load_suite(selection);
  const ResolvedPolicy policy{Policy{}};
  std::map<std::string, std::size_t> convicted;
  for (std::size_t i = 0; i < suite.cases.size(); i += kStep) {
    const Case one = suite.cases[i];
    const Rendering exact = rasterize_for_comparison(one.scene, policy);
    for (const auto& [name, spoil] : extremes()) {
      Rendering spoilt = exact;
      spoil(one.scene, spoilt);
      Result result = compare(one.scene, policy, exact, spoilt, {});
      Result* const only = &result;
      judge({&only, 1}, Latitude::opengl);
      if (result.verdict == Verdict::violation) {
        ++convicted[name];
      } else if (result.verdict != Verdict::agree) {
        const std::string excuse = excuse_of(result);
        EXPECT_TRUE(is_excused(name, excuse)) << one.id << ", " << name << ": " << excuse;
      }
    }
  }
  for (const auto& [name, spoil] : extremes()) {
    EXPECT_GT(convicted[name], 0U) << name << " was never asked";
    RecordProperty(name, static_cast<int>(convicted[name]));
  }
}

}  // namespace
}  // namespace edgecase
