// SPDX-License-Identifier: MIT
#include "profile/coverage/coverage.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "diff/coverage/neighbour_faults.h"
#include "model/scene.h"
#include "profile/evidence/inference.h"
#include "raster/rasterizer.h"
#include "rules/values/attributes.h"

namespace edgecase {
namespace {

bool has_pixel(const std::vector<PixelPosition>& pixels, PixelPosition p) {
  return std::find(pixels.begin(), pixels.end(), p) != pixels.end();
}

// The share of probes, each of one pixel and one primitive, in which a choice matches the renderer.
template <class Probe>
Rate agreement(const Seen<Probe>& seen, const CoverageChoice& choice) {
  Rate rate;
  for (std::size_t i = 0; i < seen.probes.size(); ++i) {
    const Observation& observation = seen.observations[i];
    if (!observation.failure.empty()) continue;
    const auto primitives = primitives_of(observation.scene);
    const auto own = covered_pixels(primitives[0], observation.scene.target, choice);
    const PixelPosition pixel = seen.probes[i].pixel;
    ++rate.of;
    if (has_pixel(own, pixel) == has_pixel(observation.drawn[0], pixel)) ++rate.agreeing;
  }
  return rate;
}

// The smallest of several scenes, the first in case of a tie, with details of it.
template <class Detail>
struct Smallest {
  const Scene* scene = nullptr;
  Detail detail{};

  void offer(const Scene& other, const Detail& its_detail) {
    const auto size = [](const Scene& s) {
      return std::pair{primitives_of(s).size(), s.target.width};
    };
    if (scene != nullptr && size(other) >= size(*scene)) return;
    scene = &other;
    detail = its_detail;
  }
};

std::vector<PrimitiveCoverage> coverage_of(const Observation& observation) {
  std::vector<PrimitiveCoverage> coverage;
  for (const auto& drawn : observation.drawn) coverage.push_back({{{}}, {drawn}});
  return coverage;
}

// Ruling 14 for one scene, with the segments as given: pixels drawn twice, and other faults.
struct JointFaultCounts {
  std::size_t twice = 0;
  std::size_t gaps = 0;
  Smallest<int> example;
};

bool count_joint_faults(const Observation& observation, JointFaultCounts& counts) {
  const auto primitives = primitives_of(observation.scene);
  const auto faults = joint_faults(primitives, coverage_of(observation), observation.scene);
  bool any = false;
  for (const JointFault& fault : faults) {
    if (fault.clause.empty()) continue;
    any = true;
    const auto& first = observation.drawn[static_cast<std::size_t>(fault.first)];
    const auto& second = observation.drawn[static_cast<std::size_t>(fault.second)];
    const bool twice = std::any_of(first.begin(), first.end(),
                                   [&](PixelPosition p) { return has_pixel(second, p); });
    ++(twice ? counts.twice : counts.gaps);
  }
  return any;
}

// Whether every fragment has the colour of the vertex that provokes under the choice.
bool has_colors_of(ProvokingChoice choice, const Scene& scene, const Rendering& rendering) {
  const auto primitives = primitives_of(scene);
  return std::ranges::all_of(rendering.fragments, [&](const Fragment& fragment) {
    const ScenePrimitive& primitive = primitives[static_cast<std::size_t>(fragment.primitive)];
    const Color& color = primitive.vertices[provoking_index(primitive, choice)]->color;
    return std::equal(color.begin(), color.end(), fragment.color.begin(),
                      [](float a, double b) { return a == static_cast<float>(b); });
  });
}

}  // namespace

std::vector<OwnershipTable> diamond_tables(const Seen<DiamondProbe>& seen) {
  std::vector<OwnershipTable> tables;
  for (const char* end : {"start", "end"})
    tables.emplace_back(fmt::format("pixel in whose diamond a line has its {}", end),
                        names_of<DiamondPlace>(), names_of<LineDirection>());
  for (std::size_t i = 0; i < seen.probes.size(); ++i) {
    if (!seen.observations[i].failure.empty()) continue;
    const DiamondProbe& probe = seen.probes[i];
    auto& row = tables[probe.at_start ? 0 : 1].cells[static_cast<std::size_t>(probe.place)];
    row[static_cast<std::size_t>(probe.direction)].count(
        has_pixel(seen.observations[i].drawn[0], probe.pixel));
  }
  return tables;
}

Trait diamond_trait(const Seen<DiamondProbe>& seen, const CoverageChoice& lines) {
  return {TraitId("line.ends"), "as the profile has them", agreement(seen, lines)};
}

std::vector<OwnershipTable> edge_tables(const Seen<EdgeProbe>& seen) {
  const auto sides = names_of<EdgeSide>();
  OwnershipTable edges("sample exactly on an edge of a triangle", {"drawn"}, sides);
  OwnershipTable corners("sample exactly at a corner, by the edges that meet there", sides, sides);
  for (std::size_t i = 0; i < seen.probes.size(); ++i) {
    if (!seen.observations[i].failure.empty()) continue;
    const EdgeProbe& probe = seen.probes[i];
    const auto side = static_cast<std::size_t>(probe.side);
    OwnershipTable::Cell& cell =
        probe.corner_with ? corners.cells[side][static_cast<std::size_t>(*probe.corner_with)]
                          : edges.cells[0][side];
    cell.count(has_pixel(seen.observations[i].drawn[0], probe.pixel));
  }
  return {edges, corners};
}

Trait edge_trait(const Seen<EdgeProbe>& seen, const CoverageChoice& triangles) {
  return {TraitId("triangle.edges"), "as the profile has them", agreement(seen, triangles)};
}

std::vector<Trait> joint_traits(const Seen<JointProbe>& seen, const CoverageChoice& lines) {
  JointFaultCounts faults;
  Rate straight;
  Rate turns;
  for (std::size_t i = 0; i < seen.probes.size(); ++i) {
    const Observation& observation = seen.observations[i];
    if (!observation.failure.empty()) continue;
    if (seen.probes[i].goes_on) {
      ++straight.of;
      if (!count_joint_faults(observation, faults))
        ++straight.agreeing;
      else
        faults.example.offer(observation.scene, 0);
      continue;
    }
    ++turns.of;
    const auto primitives = primitives_of(observation.scene);
    if (std::all_of(primitives.begin(), primitives.end(), [&](const ScenePrimitive& line) {
          return covered_pixels(line, observation.scene.target, lines) ==
                 observation.drawn[static_cast<std::size_t>(line.index)];
        }))
      ++turns.agreeing;
  }
  Trait straight_trait{RuleId::line_joint, "no pixel twice, no gap", straight};
  if (faults.twice + faults.gaps > 0) {
    straight_trait.alternative = "pixels twice or gaps";
    straight_trait.remark = fmt::format(
        "violation of ruling 14: {} joints with a pixel twice, {} with a gap; for "
        "example {}",
        faults.twice, faults.gaps, scene_text(*faults.example.scene));
  }
  return {straight_trait, {TraitId("line.turn"), "each segment as if alone", turns}};
}

Trait shared_edge_trait(std::span<const Observation* const> observations, int bits) {
  Trait trait{RuleId::triangle_shared_edge, "each sample exactly once"};
  std::size_t holes = 0;
  std::size_t doubles = 0;
  Smallest<SharedEdgeFault> example;
  for (const Observation* seen : observations) {
    const Observation& observation = *seen;
    if (!observation.failure.empty()) continue;
    const auto primitives = primitives_of(observation.scene);
    const auto faults =
        shared_edge_faults(primitives, coverage_of(observation), observation.scene, bits);
    ++trait.rate.of;
    if (faults.empty()) ++trait.rate.agreeing;
    for (const SharedEdgeFault& fault : faults) ++(fault.hits == 0 ? holes : doubles);
    if (!faults.empty()) example.offer(observation.scene, faults.front());
  }
  if (example.scene == nullptr) return trait;
  const SharedEdgeFault& fault = example.detail;
  trait.alternative = "holes or double hits";
  trait.remark = fmt::format(
      "violation of ruling 5: {} holes and {} double hits; triangles {} and {} hit pixel ({}, {}) "
      "{} times in {}",
      holes, doubles, fault.first, fault.second, fault.pixel.x, fault.pixel.y, fault.hits,
      scene_text(*example.scene));
  return trait;
}

std::vector<Trait> clip_traits(const Seen<ClipProbe>& seen,
                               std::span<const Observation> unclipped) {
  struct Finding {
    Rate rate;
    Smallest<int> example;
  };
  std::map<PrimitiveKind, Finding> findings;
  for (std::size_t i = 0; i < seen.probes.size(); ++i) {
    const Observation& clipped = seen.observations[i];
    if (!clipped.failure.empty() || !unclipped[i].failure.empty()) continue;
    Finding& finding = findings[kind_of(clipped.scene.draws[0].primitive)];
    ++finding.rate.of;
    if (clipped.drawn == unclipped[i].drawn)
      ++finding.rate.agreeing;
    else
      finding.example.offer(clipped.scene, 0);
  }
  std::vector<Trait> traits;
  for (const auto& [kind, finding] : findings) {
    const Scene* example = finding.example.scene;
    traits.push_back(
        {TraitId(fmt::format("clip.{}", name_of(kind))),
         example == nullptr ? "as if not clipped" : "moves or drops fragments",
         finding.rate,
         "",
         {},
         example == nullptr ? "" : fmt::format("for example {}", scene_text(*example))});
  }
  return traits;
}

Trait provoking_trait(std::span<const Scene> scenes,
                      std::span<const std::optional<Rendering>> renderings) {
  constexpr RuleId kRule = RuleId::attribute_provoking_vertex;
  const auto names = names_of_alternatives(kRule);
  std::vector<std::size_t> agreeing(names.size());
  std::size_t asked = 0;
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    if (!renderings[i] || !std::ranges::all_of(renderings[i]->fragments, &Fragment::has_color))
      continue;
    ++asked;
    for (std::size_t c = 0; c < names.size(); ++c)
      if (has_colors_of(values_of<ProvokingChoice>()[c], scenes[i], *renderings[i])) ++agreeing[c];
  }
  return leading(kRule, names, agreeing, asked);
}

}  // namespace edgecase
