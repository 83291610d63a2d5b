// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "profile/evidence/inference.h"
#include "profile/samples/samples.h"
#include "raster/rasterizer.h"

namespace edgecase {
namespace {

// A 64th of a pixel, by the planes of plane scenes.
constexpr double kColorTolerance = 1.0 / 64 / kPlainSize;
constexpr double kDepthTolerance = 1.0 / 64 / 64;

using FragmentKey = std::tuple<int, int, int, std::uint32_t>;

FragmentKey key_of(const Fragment& fragment) {
  return {fragment.y, fragment.x, fragment.primitive, fragment.coverage};
}

// For each drawn fragment, whether the exact rendering has one with the same samples that `agrees`
// accepts.
template <class Agrees>
Facts fragments_agree(const Rendering& drawn, const Rendering& exact, Agrees agrees) {
  std::map<FragmentKey, const Fragment*> own;
  for (const Fragment& fragment : exact.fragments) own.emplace(key_of(fragment), &fragment);
  Facts facts;
  for (const Fragment& fragment : drawn.fragments) {
    const auto found = own.find(key_of(fragment));
    facts.push_back(found != own.end() && agrees(fragment, *found->second));
  }
  return facts;
}

bool is_same_color(const Fragment& a, const Fragment& b) {
  return std::abs(a.color[0] - b.color[0]) < kColorTolerance &&
         std::abs(a.color[1] - b.color[1]) < kColorTolerance;
}

bool is_same_depth(const Fragment& a, const Fragment& b) {
  return std::abs(a.depth - b.depth) < kDepthTolerance;
}

// The masks of each pixel's fragments.
std::vector<std::vector<std::uint32_t>> invocations_of(const Rendering& rendering) {
  std::vector<std::vector<std::uint32_t>> masks(static_cast<std::size_t>(rendering.width) *
                                                static_cast<std::size_t>(rendering.height));
  for (const Fragment& fragment : rendering.fragments)
    masks[rendering.pixel_index(fragment.x, fragment.y)].push_back(fragment.coverage);
  return masks;
}

Facts invocations_agree(const Rendering& drawn, const Rendering& exact) {
  const auto seen = invocations_of(drawn);
  const auto own = invocations_of(exact);
  Facts facts;
  for (std::size_t i = 0; i < seen.size(); ++i) facts.push_back(seen[i] == own[i]);
  return facts;
}

Facts sample_depths_agree(const Rendering& drawn, const Rendering& exact) {
  Facts facts;
  for (std::size_t i = 0; i < drawn.depths.size(); ++i)
    if (drawn.hits[i] > 0)
      facts.push_back(std::abs(drawn.depths[i] - exact.depths[i]) < kDepthTolerance);
  return facts;
}

Facts writes_agree(const Rendering& drawn, const Rendering& exact) {
  Facts facts;
  const std::size_t plane = drawn.hits.size() / static_cast<std::size_t>(drawn.samples);
  for (std::size_t pixel = 0; pixel < plane; ++pixel) {
    bool is_same = true;
    for (std::size_t at = pixel; at < drawn.hits.size(); at += plane)
      is_same = is_same && drawn.hits[at] == exact.hits[at];
    facts.push_back(is_same);
  }
  return facts;
}

Facts joined(Facts facts, const Facts& more) {
  facts.insert(facts.end(), more.begin(), more.end());
  return facts;
}

Facts agreement(SampleEvidence evidence, const Rendering& drawn, const Rendering& exact) {
  switch (evidence) {
    case SampleEvidence::invocations:
      return invocations_agree(drawn, exact);
    case SampleEvidence::colors:
      return fragments_agree(drawn, exact, is_same_color);
    case SampleEvidence::fragment_depths:
      return fragments_agree(drawn, exact, is_same_depth);
    case SampleEvidence::sample_depths:
      return sample_depths_agree(drawn, exact);
    case SampleEvidence::all_depths:
      return joined(sample_depths_agree(drawn, exact),
                    fragments_agree(drawn, exact, is_same_depth));
    case SampleEvidence::writes:
      return writes_agree(drawn, exact);
    case SampleEvidence::switched_off:
      return joined(invocations_agree(drawn, exact), sample_depths_agree(drawn, exact));
  }
  return {};
}

}  // namespace

Trait infer_sample_rule(const TraitId& id, SampleEvidence evidence,
                        std::span<const DrawnScene> scenes, const Choices& found) {
  Tally tally(id.rule);
  for (const auto& [scene, rendering] : scenes) {
    std::vector<Facts> facts;
    for (const std::string& name : names_of_alternatives(id.rule))
      facts.push_back(agreement(
          evidence, rendering,
          rasterize(scene, policy_with(found, id.rule, name), rendering.sample_positions)));
    tally.add_all(facts);
  }
  return tally.trait(id, Tally::None::counted);
}

Trait infer_line_parameter(std::span<const DrawnScene> lines, const Choices& found) {
  constexpr RuleId kRule = RuleId::attribute_smooth;
  const auto names = names_of_alternatives(kRule);
  Tally tally(names);
  for (const auto& [scene, rendering] : lines) {
    // facts[a]: what alternative a yields with any location.
    std::vector<Facts> facts(names.size());
    for (std::size_t a = 0; a < names.size(); ++a)
      for (const std::string& location : names_of_alternatives(RuleId::attribute_location)) {
        Policy policy = policy_with(found, kRule, names[a]);
        policy.rules[name_of(RuleId::attribute_location)] = location;
        const Facts more = agreement(SampleEvidence::colors, rendering,
                                     rasterize(scene, policy, rendering.sample_positions));
        facts[a].resize(more.size());
        for (std::size_t i = 0; i < more.size(); ++i) facts[a][i] = facts[a][i] || more[i];
      }
    tally.add_all(facts);
  }
  return tally.trait({kRule, "multisampled"}, Tally::None::counted);
}

Trait infer_resolve(std::span<const DrawnScene> scenes) {
  Tally tally(RuleId::sample_resolve);
  for (const auto& [scene, rendering] : scenes) {
    const std::size_t plane = rendering.pixels.size();
    std::vector<std::uint8_t> values(static_cast<std::size_t>(rendering.samples));
    if (rendering.sample_pixels.size() != plane * values.size()) continue;
    for (std::size_t i = 0; i < plane; ++i) {
      for (std::size_t s = 0; s < values.size(); ++s)
        values[s] = rendering.sample_pixels[s * plane + i];
      std::vector<bool> yields;
      for (const ResolveMethod method : values_of<ResolveMethod>())
        yields.push_back(resolved(values, method) == rendering.pixels[i]);
      tally.add(yields);
    }
  }
  return tally.trait(RuleId::sample_resolve, Tally::None::counted);
}

Trait own_alpha_trait(std::span<const DrawnScene> scenes, AlphaToCoverage choice) {
  Trait trait{{RuleId::sample_alpha_to_coverage, "own"}, "each sample by its own alpha"};
  for (const auto& [scene, rendering] : scenes)
    for (const Fragment& fragment : rendering.fragments) {
      const std::uint32_t kept =
          alpha_mask(fragment.color[3], rendering.samples, choice) & fragment.coverage;
      for (int s = 0; s < rendering.samples; ++s) {
        if ((fragment.coverage >> s & 1) == 0) continue;
        ++trait.rate.of;
        const bool is_written =
            rendering.hits[rendering.sample_index(fragment.x, fragment.y, s)] > 0;
        if (is_written == ((kept >> s & 1) != 0)) ++trait.rate.agreeing;
      }
    }
  if (trait.rate.agreeing == trait.rate.of) return trait;
  trait.alternative = "not each by its own alpha";
  trait.remark = "violation of ruling 33: samples are kept or dropped by the alpha of others";
  return trait;
}

std::vector<AlphaRun> alpha_runs(std::span<const DrawnScene> scenes) {
  std::vector<AlphaRun> runs;
  for (const auto& [scene, rendering] : scenes) {
    const std::vector<Vertex>& vertices = scene.draws[0].vertices;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const PixelPosition pixel = alpha_pixel(i);
      std::uint32_t mask = 0;
      for (int s = 0; s < rendering.samples; ++s)
        if (rendering.hits[rendering.sample_index(pixel.x, pixel.y, s)] > 0)
          mask |= std::uint32_t{1} << s;
      const float alpha = vertices[i].color[3];
      if (runs.empty() || runs.back().mask != mask) runs.push_back({alpha, alpha, mask});
      runs.back().last = alpha;
    }
  }
  return runs;
}

namespace {

bool covers(const SampleCoverage& coverage, const LineSideProbe& probe) {
  const auto& pixels = coverage[probe.sample];
  return std::find(pixels.begin(), pixels.end(), probe.pixel) != pixels.end();
}

}  // namespace

OwnershipTable line_side_table(std::span<const LineSideProbe> probes,
                               std::span<const Observation> observations) {
  OwnershipTable table("sample exactly on the boundary of a multisampled line",
                       names_of<LineSide>(), names_of<LineDirection>());
  for (std::size_t i = 0; i < probes.size(); ++i)
    if (observations[i].failure.empty())
      table
          .cells[static_cast<std::size_t>(probes[i].side)]
                [static_cast<std::size_t>(probes[i].direction)]
          .count(covers(observations[i].samples[0], probes[i]));
  return table;
}

Trait line_side_trait(std::span<const LineSideProbe> probes,
                      std::span<const Observation> observations, const CoverageChoice& lines) {
  Trait trait{{RuleId::line_multisampled, "boundary"}, "as the profile has it"};
  for (std::size_t i = 0; i < probes.size(); ++i) {
    const Observation& seen = observations[i];
    if (!seen.failure.empty()) continue;
    const auto primitives = primitives_of(seen.scene);
    const SampleCoverage own =
        covered_samples(primitives[0], seen.scene.target, lines, seen.positions);
    ++trait.rate.of;
    if (covers(own, probes[i]) == covers(seen.samples[0], probes[i])) ++trait.rate.agreeing;
  }
  return trait;
}

}  // namespace edgecase
