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
#include "rules/all_rules.h"
#include "tests/support/core_suite.h"

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

// All fragments of each pass, or those of the scene.
Spoil on_lists(const std::function<void(const Scene&, std::vector<Fragment>&)>& change) {
  return [=](const Scene& scene, Rendering& drawn) {
    change(scene, drawn.fragments);
    for (Rendering& pass : drawn.passes) change(scene, pass.fragments);
    sort_fragments(drawn);
    for (Rendering& pass : drawn.passes) sort_fragments(pass);
  };
}

// Each primitive that draws something draws every pixel, with the values of its first fragment.
void cover_all(const Scene& scene, std::vector<Fragment>& fragments) {
  std::set<int> done;
  std::vector<Fragment> all;
  for (const Fragment& f : fragments) {
    if (!done.insert(f.primitive).second) continue;
    for (int y = 0; y < scene.target.height; ++y)
      for (int x = 0; x < scene.target.width; ++x) {
        all.push_back(f);
        all.back().x = x;
        all.back().y = y;
      }
  }
  fragments = all;
}

void move_by(int pixels, const Scene& scene, std::vector<Fragment>& fragments) {
  for (Fragment& f : fragments) f.x += pixels;
  std::erase_if(fragments, [&](const Fragment& f) { return f.x >= scene.target.width; });
}

std::vector<Extreme> extremes_of_coverage() {
  const auto of_samples = [](std::uint32_t mask) {
    return on_fragments([=](Fragment& f, std::size_t) {
      if (f.coverage > 1) f.coverage = mask & f.coverage;
    });
  };
  return {{"no fragments", on_lists([](const Scene&, std::vector<Fragment>& f) { f.clear(); })},
          {"each fragment twice", on_lists([](const Scene&, std::vector<Fragment>& fragments) {
             const std::vector<Fragment> once = fragments;
             fragments.insert(fragments.end(), once.begin(), once.end());
           })},
          {"fragments in every pixel", on_lists(cover_all)},
          {"fragments a pixel to the right",
           on_lists([](const Scene& scene, auto& fragments) { move_by(1, scene, fragments); })},
          {"fragments eight pixels to the right",
           on_lists([](const Scene& scene, auto& fragments) { move_by(8, scene, fragments); })},
          {"the last primitive's fragments for all",
           on_lists([](const Scene&, std::vector<Fragment>& fragments) {
             if (fragments.empty()) return;
             const int last = std::ranges::max(fragments, {}, &Fragment::primitive).primitive;
             for (Fragment& f : fragments) f.primitive = last;
           })},
          {"one sample of each fragment",
           on_fragments([](Fragment& f, std::size_t) { f.coverage &= ~(f.coverage - 1); })},
          {"every second sample", of_samples(0x55555555U)},
          {"all samples", [](const Scene& scene, Rendering& drawn) {
             for (Fragment& f : drawn.fragments)
               f.coverage =
                   static_cast<std::uint32_t>((std::uint64_t{1} << scene.target.samples) - 1);
           }}};
}

std::vector<Extreme> extremes_of_values() {
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
      {"stencils of 170",
       [](const Scene&, Rendering& drawn) {
         for (auto& stencil : drawn.stencils) stencil = 170;
       }},
      {"mirrored pictures",
       [](const Scene& scene, Rendering& drawn) {
         // What is resolved of samples may be any mean of them.
         if (scene.target.samples > 1) return;
         const Rendering upright = drawn;
         const int width = scene.target.width;
         for (std::size_t i = 0; i < drawn.pixels.size() / 4; ++i) {
           const auto x = static_cast<int>(i % static_cast<std::size_t>(width));
           const std::size_t other =
               i + static_cast<std::size_t>(width - 1 - x) - static_cast<std::size_t>(x);
           for (std::size_t c = 0; c < 4; ++c)
             drawn.pixels[4 * i + c] = upright.pixels[4 * other + c];
         }
       }},
      {"texture coordinates of 1,000,000", on_details([](FragmentDetail& d, std::size_t) {
         if (d.texture_coordinates) d.texture_coordinates->fill(1e6);
       })},
  };
}

std::vector<Extreme> extremes() {
  std::vector<Extreme> all = extremes_of_values();
  for (Extreme& one : extremes_of_coverage()) all.push_back(std::move(one));
  return all;
}

// "contested 44", or the verdict and the rulings on the values that are permitted.
std::string excuse_of(const Result& result) {
  std::set<int> rulings;
  for (const Disagreement& d : result.disagreements) rulings.insert(d.ruling);
  for (const ValueAggregate& values : result.values) rulings.insert(values.ruling);
  return fmt::format("{} {}", name_of(result.verdict), fmt::join(rulings, " "));
}

// Of a polygon that clipping made, any mean of its vertices' depths is contested (ruling 44), and
// slivers whose vertices may move as far as they are wide may have any depth. A sample that every
// pixel covers may lie where all do (ruling 47).
bool is_excused(const std::string& extreme, const std::string& excuse) {
  return (extreme.find("depth") != std::string::npos &&
          (excuse == "contested 44" || excuse == "permitted 9" || excuse == "contested 9 44")) ||
         (extreme == "all samples" && excuse == "contested 47");
}

// By ruling: the extremes that it convicts, and of how many cases.
using Convicted = std::map<int, std::map<std::string, std::size_t>>;

// Every case of the core, in which each ruling that cases name decides something.
TEST(Extremes, NoneIsExcused) {
  const Suite suite = core_suite();
  const ResolvedPolicy policy{Policy{}};
  std::map<std::string, std::size_t> convicted;
  Convicted by_ruling;
  for (std::size_t i = 0; i < suite.cases.size(); ++i) {
    const Case one = suite.cases[i];
    const Rendering exact = rasterize_for_comparison(one.scene, policy);
    for (const auto& [name, spoil] : extremes()) {
      Rendering spoilt = exact;
      spoil(one.scene, spoilt);
      Result result = compare(one.scene, policy, exact, spoilt, {});
      Result* const only = &result;
      judge({&only, 1}, Latitude::opengl);
      for (const Disagreement& d : result.disagreements)
        if (d.legality == Legality::illegal) ++by_ruling[d.ruling][name];
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
  for (const Rule& rule : all_rules())
    for (const Ruling& ruling : rule.rulings) {
      std::vector<std::string> names;
      for (const auto& [name, cases] : by_ruling[ruling.number]) names.push_back(name);
      RecordProperty(fmt::format("ruling_{}", ruling.number),
                     fmt::format("{} {}: {}", name_of(rule.id), name_of(ruling.source.basis),
                                 fmt::join(names, "; ")));
    }
}

}  // namespace
}  // namespace edgecase
