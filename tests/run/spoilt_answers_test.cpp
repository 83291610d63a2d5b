// SPDX-License-Identifier: MIT
//
// Agree means that the picture is right. For each case of the core suite and each field of an
// answer, an answer that is right but for one number of that field never agrees; nor does one that
// tells no colours, or no depths, and has a wrong picture.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <iostream>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "diff/compare.h"
#include "diff/judge.h"
#include "model/rendering_fields.h"
#include "raster/rasterizer.h"
#include "suite/selection.h"
#include "tests/support/core_suite.h"
#include "tests/support/share.h"
#include "wire/fragments.h"
#include "wire/json_values.h"

namespace edgecase {
namespace {

// Picks an element, another one for each `turn`, such that neighbours are picked seldom.
template <class Numbers>
auto* picked(Numbers& numbers, std::uint64_t turn) {
  const std::uint64_t hash = (turn + 1) * 0x9e3779b97f4a7c15u >> 20;
  return numbers.empty() ? nullptr : &numbers[hash % numbers.size()];
}

// The float32 numbers that follow on a number, and that lie far from it.
double next_float(double value) {
  const auto number = static_cast<float>(value);
  return static_cast<double>(std::nextafter(number, number > 0.5F ? 0.0F : 1.0F));
}
double far_from(double value) {
  return value > 0.5 ? 0 : 1;
}

// Changes one number of an answer. False: the answer has no such field.
using Spoil = std::function<bool(Rendering&, std::uint64_t turn)>;

template <class Number>
Spoil spoil_plane(std::vector<Number> Rendering::*plane, Number (*change)(Number)) {
  return [=](Rendering& answer, std::uint64_t turn) {
    Number* const number = picked(answer.*plane, turn);
    if (number != nullptr) *number = change(*number);
    return number != nullptr;
  };
}

Spoil spoil_fragment(std::function<bool(Fragment&, const Rendering&)> change) {
  return [change = std::move(change)](Rendering& answer, std::uint64_t turn) {
    Fragment* const fragment = picked(answer.fragments, turn);
    if (fragment == nullptr || !change(*fragment, answer)) return false;
    sort_fragments(answer);
    return true;
  };
}

Spoil spoil_detail(std::function<double*(FragmentDetail&)> number, double (*change)(double)) {
  return [=](Rendering& answer, std::uint64_t turn) {
    Fragment* const fragment = picked(answer.fragments, turn);
    if (fragment == nullptr || fragment->detail < 0) return false;
    // Fragments may share a detail.
    answer.details.push_back(answer.details[static_cast<std::size_t>(fragment->detail)]);
    fragment->detail = static_cast<int>(answer.details.size()) - 1;
    double* const told = number(answer.details.back());
    if (told == nullptr || !std::isfinite(*told)) return false;
    *told = change(*told);
    return true;
  };
}

std::uint8_t next_code(std::uint8_t code) {
  return static_cast<std::uint8_t>(code == 255 ? 254 : code + 1);
}
std::uint8_t far_code(std::uint8_t code) {
  return static_cast<std::uint8_t>(code ^ 0xff);
}
double next_depth(double depth) {
  return depth > 0.5 ? depth - 0x1p-16 : depth + 0x1p-16;
}

struct NamedSpoil {
  std::string name;
  Spoil spoil;
};

std::vector<NamedSpoil> spoils_of_planes() {
  return {
      {"a pixel by one code", spoil_plane(&Rendering::pixels, next_code)},
      {"a pixel", spoil_plane(&Rendering::pixels, far_code)},
      {"a sample by one code", spoil_plane(&Rendering::sample_pixels, next_code)},
      {"a sample", spoil_plane(&Rendering::sample_pixels, far_code)},
      {"a stored depth by a little", spoil_plane(&Rendering::depths, next_depth)},
      {"a stored depth", spoil_plane(&Rendering::depths, far_from)},
      {"a stencil", spoil_plane(&Rendering::stencils, next_code)},
      {"an accumulated number by a little", spoil_plane(&Rendering::accumulated, next_float)},
      {"an accumulated number", spoil_plane(&Rendering::accumulated, far_from)},
      {"a mip chain",
       [](Rendering& answer, std::uint64_t turn) {
         if (answer.mip_chains.empty()) return false;
         TextureLevel* const level = picked(answer.mip_chains.begin()->second, turn);
         float* const texel = picked(level->texels, turn);
         *texel = *texel > 0.5F ? 0.0F : 1.0F;
         return true;
       }},
      {"hits",
       spoil_plane<std::uint32_t>(
           &Rendering::hits, [](std::uint32_t hits) { return hits == 0 ? hits + 1 : hits - 1; })},
      {"all pixels black",
       [](Rendering& answer, std::uint64_t) {
         const std::vector<std::uint8_t> before = answer.pixels;
         std::ranges::fill(answer.pixels, std::uint8_t{0});
         return answer.pixels != before;
       }},
  };
}

std::vector<NamedSpoil> spoils_of_fragments() {
  std::vector<NamedSpoil> spoils = {
      {"a fragment lost",
       [](Rendering& answer, std::uint64_t turn) {
         const Fragment* const fragment = picked(answer.fragments, turn);
         if (fragment == nullptr) return false;
         answer.fragments.erase(answer.fragments.begin() + (fragment - answer.fragments.data()));
         return true;
       }},
      {"a fragment twice",
       [](Rendering& answer, std::uint64_t turn) {
         const Fragment* const fragment = picked(answer.fragments, turn);
         if (fragment == nullptr) return false;
         answer.fragments.push_back(Fragment(*fragment));
         sort_fragments(answer);
         return true;
       }},
      {"a fragment moved", spoil_fragment([](Fragment& fragment, const Rendering& answer) {
         fragment.x = fragment.x + 1 < answer.width ? fragment.x + 1 : fragment.x - 1;
         return fragment.x >= 0;
       })},
      {"a fragment's samples", spoil_fragment([](Fragment& fragment, const Rendering& answer) {
         if (answer.samples == 1) return false;
         fragment.coverage ^= 1;
         return fragment.coverage != 0;
       })},
      {"a fragment's depth", spoil_fragment([](Fragment& fragment, const Rendering&) {
         fragment.depth = next_float(fragment.depth);
         return fragment.has_depth;
       })},
      {"a fragment's depth far off", spoil_fragment([](Fragment& fragment, const Rendering&) {
         fragment.depth = far_from(fragment.depth);
         return fragment.has_depth;
       })},
  };
  for (std::size_t c = 0; c < 4; ++c) {
    spoils.push_back({"component " + std::to_string(c) + " by a little",
                      spoil_fragment([c](Fragment& fragment, const Rendering&) {
                        if (!std::isfinite(fragment.color[c])) return false;
                        fragment.color[c] = next_float(fragment.color[c]);
                        return fragment.has_color;
                      })});
    spoils.push_back({"component " + std::to_string(c),
                      spoil_fragment([c](Fragment& fragment, const Rendering&) {
                        fragment.color[c] = far_from(fragment.color[c]);
                        return fragment.has_color;
                      })});
  }
  return spoils;
}

std::vector<NamedSpoil> spoils_of_details() {
  std::vector<NamedSpoil> spoils;
  const auto add = [&](const std::string& name,
                       const std::function<double*(FragmentDetail&)>& number) {
    spoils.push_back({name + " by a little", spoil_detail(number, next_float)});
    spoils.push_back({name, spoil_detail(number, far_from)});
  };
  for (std::size_t i = 0; i < 4; ++i)
    add("gl_FragCoord " + std::to_string(i), [i](FragmentDetail& detail) {
      return detail.coordinates ? &(*detail.coordinates)[i] : nullptr;
    });
  for (std::size_t function = 0; function < kDerivatives; ++function)
    add("derivative " + std::to_string(function), [function](FragmentDetail& detail) {
      auto& told = detail.derivatives[function];
      return told ? &(*told)[0] : nullptr;
    });
  for (std::size_t i = 0; i < 2; ++i) {
    add("texture coordinate " + std::to_string(i), [i](FragmentDetail& detail) {
      return detail.texture_coordinates ? &(*detail.texture_coordinates)[i] : nullptr;
    });
    add("level of detail " + std::to_string(i), [i](FragmentDetail& detail) {
      return detail.level_of_detail ? &(*detail.level_of_detail)[i] : nullptr;
    });
  }
  return spoils;
}

// The right answer, telling less.
Rendering without_values(Rendering answer) {
  for (Fragment& fragment : answer.fragments) fragment.has_color = fragment.has_depth = false;
  for (Rendering& pass : answer.passes) pass = without_values(std::move(pass));
  return answer;
}
Rendering without_samples(Rendering answer) {
  answer.sample_pixels.clear();
  answer.hits.clear();
  return answer;
}

// Nothing: the answer is refused where it is read.
std::optional<Result> judged(const Scene& scene, const Rendering& exact, const Rendering& answer) {
  try {
    check_rendering(answer, scene);
  } catch (const wire::Refusal&) {
    return std::nullopt;
  }
  Result result = compare(scene, {}, exact, answer, {8});
  Result* const results[] = {&result};
  judge(results, Latitude::opengl);
  return result;
}

class SpoiltAnswers : public testing::Test {
 protected:
  void TearDown() override {
    std::cout << "spoilt answers:";
    for (const auto& [verdict, count] : verdicts_) std::cout << " " << count << " " << verdict;
    std::cout << "\n";
    EXPECT_GT(verdicts_["violation"], 0u);
    EXPECT_EQ(verdicts_["agree"], 0u);
  }

  void expect_none_agrees(const Case& one, const Rendering& exact, const Rendering& answer,
                          const std::vector<NamedSpoil>& spoils) {
    const auto right = judged(one.scene, exact, answer);
    ASSERT_TRUE(right);
    EXPECT_EQ(name_of(right->verdict), std::string("agree")) << one.id;
    for (const auto& [name, spoil] : spoils) {
      ++turn_;
      Rendering spoilt = answer;
      Rendering& drawing =
          spoilt.passes.empty() || turn_ % 2 == 0 ? spoilt : *picked(spoilt.passes, turn_);
      if (!spoil(drawing, turn_)) continue;
      const auto result = judged(one.scene, exact, spoilt);
      const std::string verdict = result ? name_of(result->verdict) : "garbage";
      ++verdicts_[verdict];
      EXPECT_NE(verdict, "agree") << one.id << ": " << name << ", turn " << turn_;
    }
  }

 private:
  std::uint64_t turn_ = 0;
  std::map<std::string, std::size_t> verdicts_;
};

TEST_F(SpoiltAnswers, AreNeverAgreed) {
  const Suite suite = core_suite();
  ASSERT_GT(suite.cases.size(), 200u);
  std::vector<NamedSpoil> all = spoils_of_planes();
  for (const auto& more : {spoils_of_fragments(), spoils_of_details()})
    all.insert(all.end(), more.begin(), more.end());
  Dealer dealer;
  for (const Case& one : suite.cases) {
    if (!dealer.deal()) continue;
    const Rendering exact = rasterize_for_comparison(one.scene, {});
    expect_none_agrees(one, exact, exact, all);
    expect_none_agrees(one, exact, without_values(exact), spoils_of_planes());
    expect_none_agrees(one, exact, without_samples(exact), spoils_of_planes());
    if (HasFatalFailure()) FAIL() << one.id;
  }
}

}  // namespace
}  // namespace edgecase
