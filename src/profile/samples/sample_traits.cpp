// SPDX-License-Identifier: MIT
#include "profile/samples/sample_traits.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "profile/rule_tally.h"
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

// Whether each of the told fragments has one of the same samples in the exact rendering that
// `agrees` with it.
template <class Agrees>
Facts fragments_agree(const Rendering& told, const Rendering& exact, Agrees agrees) {
  std::map<FragmentKey, const Fragment*> own;
  for (const Fragment& fragment : exact.fragments) own.emplace(key_of(fragment), &fragment);
  Facts facts;
  for (const Fragment& fragment : told.fragments) {
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

Facts invocations_agree(const Rendering& told, const Rendering& exact) {
  const auto seen = invocations_of(told);
  const auto own = invocations_of(exact);
  Facts facts;
  for (std::size_t i = 0; i < seen.size(); ++i) facts.push_back(seen[i] == own[i]);
  return facts;
}

Facts sample_depths_agree(const Rendering& told, const Rendering& exact) {
  Facts facts;
  for (std::size_t i = 0; i < told.depths.size(); ++i)
    if (told.hits[i] > 0)
      facts.push_back(std::abs(told.depths[i] - exact.depths[i]) < kDepthTolerance);
  return facts;
}

Facts writes_agree(const Rendering& told, const Rendering& exact) {
  Facts facts;
  const std::size_t plane = told.hits.size() / static_cast<std::size_t>(told.samples);
  for (std::size_t pixel = 0; pixel < plane; ++pixel) {
    bool is_same = true;
    for (std::size_t at = pixel; at < told.hits.size(); at += plane)
      is_same = is_same && told.hits[at] == exact.hits[at];
    facts.push_back(is_same);
  }
  return facts;
}

Facts joined(Facts facts, const Facts& more) {
  facts.insert(facts.end(), more.begin(), more.end());
  return facts;
}

Facts agreement(ToldOf what, const Rendering& told, const Rendering& exact) {
  switch (what) {
    case ToldOf::invocations:
      return invocations_agree(told, exact);
    case ToldOf::colors:
      return fragments_agree(told, exact, is_same_color);
    case ToldOf::fragment_depths:
      return fragments_agree(told, exact, is_same_depth);
    case ToldOf::sample_depths:
      return sample_depths_agree(told, exact);
    case ToldOf::all_depths:
      return joined(sample_depths_agree(told, exact), fragments_agree(told, exact, is_same_depth));
    case ToldOf::writes:
      return writes_agree(told, exact);
    case ToldOf::switched_off:
      return joined(invocations_agree(told, exact), sample_depths_agree(told, exact));
  }
  return {};
}

}  // namespace

Trait infer_sample_rule(const std::string& rule, std::string id, ToldOf what,
                        std::span<const DrawnScene> told, const Choices& found) {
  Tally tally = tally_of(rule);
  for (const DrawnScene& one : told) {
    std::vector<Facts> facts;
    for (const std::string& name : names_of_alternatives(rule))
      facts.push_back(agreement(
          what, one.rendering,
          rasterize(one.scene, policy_with(found, rule, name), one.rendering.sample_positions)));
    add_all(tally, facts);
  }
  return tally.trait(std::move(id), Tally::None::counted);
}

Trait infer_line_parameter(std::span<const DrawnScene> lines, const Choices& found) {
  const std::string rule = name_of(RuleId::attribute_smooth);
  std::vector<std::string> names = names_of_alternatives(rule);
  const auto locations = names_of_alternatives(name_of(RuleId::attribute_location));
  Tally tally(names, 0);
  for (const DrawnScene& one : lines) {
    // facts[a]: what alternative a yields with some location.
    std::vector<Facts> facts(names.size());
    for (std::size_t a = 0; a < names.size(); ++a)
      for (const std::string& location : locations) {
        Policy policy = policy_with(found, rule, names[a]);
        policy.rules[name_of(RuleId::attribute_location)] = location;
        const Facts more = agreement(ToldOf::colors, one.rendering,
                                     rasterize(one.scene, policy, one.rendering.sample_positions));
        facts[a].resize(more.size());
        for (std::size_t i = 0; i < more.size(); ++i) facts[a][i] = facts[a][i] || more[i];
      }
    add_all(tally, facts);
  }
  return tally.trait(rule + ":multisampled", Tally::None::counted);
}

Trait infer_resolve(std::span<const DrawnScene> told) {
  Tally tally = tally_of(name_of(RuleId::sample_resolve));
  for (const auto& [scene, rendering] : told) {
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
  return tally.trait(name_of(RuleId::sample_resolve), Tally::None::counted);
}

Trait own_alpha_trait(std::span<const DrawnScene> told, AlphaToCoverage choice) {
  Trait trait{"sample.alpha-to-coverage:own", "each sample by its own alpha", {}, "", {}, ""};
  for (const auto& [scene, rendering] : told)
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

std::vector<AlphaRun> alpha_runs(std::span<const DrawnScene> told) {
  std::vector<AlphaRun> runs;
  for (const auto& [scene, rendering] : told) {
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
  OwnershipTable table{"sample exactly on the boundary of a multisampled line", {}, {}, {}};
  for (int i = 0; i < kLineSides; ++i) table.rows.emplace_back(name_of(static_cast<LineSide>(i)));
  for (int i = 0; i < kLineDirections; ++i)
    table.columns.emplace_back(name_of(static_cast<LineDirection>(i)));
  table.cells.assign(table.rows.size(), std::vector<OwnershipTable::Cell>(table.columns.size()));
  for (std::size_t i = 0; i < probes.size(); ++i) {
    if (!observations[i].failure.empty()) continue;
    OwnershipTable::Cell& cell = table.cells[static_cast<std::size_t>(probes[i].side)]
                                            [static_cast<std::size_t>(probes[i].direction)];
    ++cell.of;
    if (covers(observations[i].samples[0], probes[i])) ++cell.drawn;
  }
  return table;
}

Trait line_side_trait(std::span<const LineSideProbe> probes,
                      std::span<const Observation> observations, const CoverageChoice& lines) {
  Trait trait{"line.multisampled:boundary", "as the profile has it", {}, "", {}, ""};
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
