// SPDX-License-Identifier: MIT
#include "profile/probes/probe_traits.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <variant>

#include "diff/coverage/joint_faults.h"
#include "diff/coverage/shared_edge_faults.h"
#include "model/scene_words.h"
#include "raster/rasterizer.h"
#include "rules/values/flat_attribute.h"

namespace edgecase {
namespace {

bool has_pixel(const std::vector<PixelPosition>& pixels, PixelPosition p) {
  return std::find(pixels.begin(), pixels.end(), p) != pixels.end();
}

OwnershipTable empty_table(std::string title, std::vector<std::string> rows,
                           std::vector<std::string> columns) {
  OwnershipTable table{std::move(title), std::move(rows), std::move(columns), {}};
  table.cells.assign(table.rows.size(), std::vector<OwnershipTable::Cell>(table.columns.size()));
  return table;
}

void count(OwnershipTable::Cell& cell, bool drawn) {
  ++cell.of;
  if (drawn) ++cell.drawn;
}

template <class Enum>
std::vector<std::string> names_of_first(int count) {
  std::vector<std::string> names;
  for (int i = 0; i < count; ++i) names.emplace_back(name_of(static_cast<Enum>(i)));
  return names;
}

// In how many probes of one pixel and one primitive a choice says what the renderer does there.
template <class Probe>
Rate foretold(const Seen<Probe>& seen, const CoverageChoice& choice) {
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

// The smallest of several scenes, the first of those that tie, with what is to be said of it.
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

// Ruling 14 for one scene, as the segments are given: a pixel drawn twice, another fault, or none.
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

}  // namespace

std::vector<OwnershipTable> diamond_tables(const Seen<DiamondProbe>& seen) {
  std::vector<OwnershipTable> tables;
  for (const char* end : {"start", "end"})
    tables.push_back(empty_table(fmt::format("pixel in whose diamond a line has its {}", end),
                                 names_of_first<DiamondPlace>(kDiamondPlaces),
                                 names_of_first<LineDirection>(kLineDirections)));
  for (std::size_t i = 0; i < seen.probes.size(); ++i) {
    if (!seen.observations[i].failure.empty()) continue;
    const DiamondProbe& probe = seen.probes[i];
    OwnershipTable& table = tables[probe.at_start ? 0 : 1];
    count(table.cells[static_cast<std::size_t>(probe.place)]
                     [static_cast<std::size_t>(probe.direction)],
          has_pixel(seen.observations[i].drawn[0], probe.pixel));
  }
  return tables;
}

Trait diamond_trait(const Seen<DiamondProbe>& seen, const CoverageChoice& lines) {
  return {"line.ends", "as the profile has them", foretold(seen, lines), "", {}, ""};
}

std::vector<OwnershipTable> edge_tables(const Seen<EdgeProbe>& seen) {
  const auto sides = names_of_first<EdgeSide>(kEdgeSides);
  OwnershipTable edges = empty_table("sample exactly on an edge of a triangle", {"drawn"}, sides);
  OwnershipTable corners =
      empty_table("sample exactly at a corner, by the edges that meet there", sides, sides);
  for (std::size_t i = 0; i < seen.probes.size(); ++i) {
    if (!seen.observations[i].failure.empty()) continue;
    const EdgeProbe& probe = seen.probes[i];
    const auto side = static_cast<std::size_t>(probe.side);
    count(probe.corner_with ? corners.cells[side][static_cast<std::size_t>(*probe.corner_with)]
                            : edges.cells[0][side],
          has_pixel(seen.observations[i].drawn[0], probe.pixel));
  }
  return {edges, corners};
}

Trait edge_trait(const Seen<EdgeProbe>& seen, const CoverageChoice& triangles) {
  return {"triangle.edges", "as the profile has them", foretold(seen, triangles), "", {}, ""};
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
  Trait straight_trait{name_of(RuleId::line_joint), "no pixel twice, no gap", straight, "", {}, ""};
  if (faults.twice + faults.gaps > 0) {
    straight_trait.alternative = "pixels twice or gaps";
    straight_trait.remark = fmt::format(
        "violation of ruling 14: {} joints with a pixel twice, {} with a gap; for "
        "example {}",
        faults.twice, faults.gaps, scene_words(*faults.example.scene));
  }
  return {straight_trait, {"line.turn", "each segment as if alone", turns, "", {}, ""}};
}

Trait shared_edge_trait(std::span<const Observation> observations, int bits) {
  Trait trait{name_of(RuleId::triangle_shared_edge), "each sample exactly once", {}, "", {}, ""};
  std::size_t holes = 0;
  std::size_t doubles = 0;
  Smallest<SharedEdgeFault> example;
  for (const Observation& observation : observations) {
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
      scene_words(*example.scene));
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
        {fmt::format("clip.{}", name_of(kind)),
         example == nullptr ? "as if not clipped" : "moves or drops fragments",
         finding.rate,
         "",
         {},
         example == nullptr ? "" : fmt::format("for example {}", scene_words(*example))});
  }
  return traits;
}

Trait provoking_trait(std::span<const Scene> scenes, std::span<const Outcome> outcomes) {
  constexpr std::array<std::pair<ProvokingChoice, const char*>, 3> kChoices = {
      {{ProvokingChoice::as_set, "as-set"},
       {ProvokingChoice::first, "first"},
       {ProvokingChoice::last, "last"}}};
  std::array<Rate, 3> rates;
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const auto* rendering = std::get_if<Rendering>(&outcomes[i]);
    const auto has_color = [](const Fragment& fragment) { return fragment.has_color; };
    if (rendering == nullptr ||
        !std::all_of(rendering->fragments.begin(), rendering->fragments.end(), has_color))
      continue;
    const auto primitives = primitives_of(scenes[i]);
    for (std::size_t c = 0; c < kChoices.size(); ++c) {
      ++rates[c].of;
      if (std::all_of(
              rendering->fragments.begin(), rendering->fragments.end(),
              [&](const Fragment& fragment) {
                const auto& primitive = primitives[static_cast<std::size_t>(fragment.primitive)];
                const Color& color =
                    primitive.vertices[provoking_index(primitive, kChoices[c].first)]->color;
                return std::equal(color.begin(), color.end(), fragment.color.begin(),
                                  [](float a, double b) { return a == static_cast<float>(b); });
              }))
        ++rates[c].agreeing;
    }
  }
  std::array<std::size_t, 3> order = {0, 1, 2};
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return rates[a].agreeing > rates[b].agreeing;
  });
  return {name_of(RuleId::attribute_provoking_vertex),
          kChoices[order[0]].second,
          rates[order[0]],
          kChoices[order[1]].second,
          rates[order[1]],
          ""};
}

}  // namespace edgecase
