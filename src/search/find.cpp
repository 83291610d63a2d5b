// SPDX-License-Identifier: MIT
#include "search/find.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <utility>

#include "diff/verdicts.h"
#include "model/names.h"
#include "model/rule_id.h"

namespace edgecase {
namespace {

std::string shape_of(const ScenePrimitive& primitive) {
  const Fixed one = Fixed::from_integer(1);
  switch (primitive.kind) {
    case PrimitiveKind::point:
      return primitive.state->point_size == one ? "point" : "large point";
    case PrimitiveKind::line:
      return primitive.state->line_width == one ? "line" : "wide line";
    case PrimitiveKind::triangle:
      break;
  }
  return "triangle";
}

// The geometry of each primitive of a scene, and of a whole pixel.
class Geometry {
 public:
  explicit Geometry(const Scene& scene) {
    if (scene.target.samples > 1) samples_ = fmt::format(", {} samples", scene.target.samples);
    for (const ScenePrimitive& primitive : primitives_of(scene))
      shapes_.push_back(shape_of(primitive));
  }
  std::string of(int primitive) const {
    const bool is_one = primitive >= 0 && primitive < static_cast<int>(shapes_.size());
    return (is_one ? shapes_[static_cast<std::size_t>(primitive)] : "whole pixel") + samples_;
  }

 private:
  std::string samples_;
  std::vector<std::string> shapes_;
};

}  // namespace

std::vector<Shown> shown_by(const Scene& scene, const Result& result, Latitude latitude) {
  const Surface surface = scene.target.surface;
  if (result.failure) {
    std::vector<Shown> shown;
    for (Signature& signature : signatures_of(result, surface))
      shown.push_back({{std::move(signature), "scene"}, Verdict::not_run});
    return shown;
  }
  const Geometry geometry(scene);
  std::map<FindKey, Verdict> found;
  const auto add = [&](Signature signature, int primitive, Verdict verdict) {
    Verdict& worst = found[{std::move(signature), geometry.of(primitive)}];
    worst = std::max(worst, verdict);
  };
  // Those that are only counted show nothing that those in full do not.
  for (const Disagreement& d : result.disagreements)
    add(signature_of(d, surface), d.primitive, verdict_of(d, latitude));
  for (const ValueAggregate& values : result.values)
    if (!values.differing.empty())
      add(signature_of(values, surface), values.worst.primitive, verdict_of(values, latitude));
  std::vector<Shown> shown;
  for (auto& [key, verdict] : found) shown.push_back({key, verdict});
  std::ranges::stable_sort(shown, std::greater<>(), &Shown::verdict);
  return shown;
}

std::string describe(const Result& result) {
  constexpr std::size_t kMost = 4;  // pixels that are listed
  std::string words = name_of(result.verdict);
  if (result.failure) return fmt::format("{}, {}", words, result.failure->reason);
  const std::size_t count = count_disagreements(result);
  for (std::size_t i = 0; i < std::min(result.disagreements.size(), kMost); ++i) {
    const Disagreement& d = result.disagreements[i];
    words += fmt::format(", {} ({}, {})", name_of(d.kind), d.x, d.y);
  }
  if (count > kMost) words += fmt::format(" and {} more", count - kMost);
  for (const ValueAggregate& values : result.values)
    if (!values.differing.empty())
      words += fmt::format(", {} of {} fragments", values.attribute, values.differing.size());
  return words;
}

std::string title_of(const Find& find) {
  return fmt::format("{} ({})", title_of(find.key.signature), find.key.geometry);
}

const Disagreement* first_disagreement(const Find& find) {
  Surface surface = Surface::fbo;
  parse_name(find.key.signature.surface, surface);
  for (const Disagreement& d : find.result.disagreements)
    if (signature_of(d, surface) == find.key.signature) return &d;
  return nullptr;
}

std::string rule_of(const Find& find) {
  if (!find.key.signature.rule.empty()) return find.key.signature.rule;
  if (const Disagreement* d = first_disagreement(find)) return name_of(d->rule);
  for (const ValueAggregate& values : find.result.values)
    if (text_of(values.cause) == find.key.signature.cause) return name_of(values.rule);
  return name_of(RuleId::fragment_once);
}

}  // namespace edgecase
