// SPDX-License-Identifier: MIT
//
// The ways of taking derivatives, and the rounding of depth buffers; value_traits.cpp has the rest.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "diff/values/value_diff.h"
#include "profile/profile_text.h"
#include "profile/values/value_traits.h"
#include "raster/attributes.h"
#include "rules/values/depth_buffer.h"

namespace edgecase {
namespace {

constexpr std::size_t kMostMethods = 16;
using Holds = std::array<bool, kMostMethods>;

std::size_t method_count() {
  return values_of<DerivativeMethod>().size();
}

// What was counted of one form of derivative, of the samples that tell methods apart.
struct Counts {
  std::array<std::array<std::size_t, kMostMethods>, 2> axis{};  // x alone, y alone
  std::array<std::size_t, kMostMethods> both{};
  std::size_t of = 0;
};

std::size_t best_of(const std::array<std::size_t, kMostMethods>& counts) {
  return static_cast<std::size_t>(std::max_element(counts.begin(), counts.end()) - counts.begin());
}

class DerivativeForm {
 public:
  DerivativeForm(Derivative x, Derivative y, const RuleChoices& found, RowOrder rows)
      : forms_{x, y}, found_(found), rows_(rows) {}

  Counts count(const std::vector<SampledScene>& scenes) const {
    Counts counts;
    for (const SampledScene& scene : scenes) {
      const auto primitives = primitives_of(scene.scene);
      std::vector<PrimitiveAttributes> attributes;
      for (const ScenePrimitive& primitive : primitives)
        attributes.push_back(attributes_of(primitive, found_, scene.scene.target));
      for (const SampledScene::Sample& sample : scene.samples)
        add(sample, attributes[static_cast<std::size_t>(sample.primitive)],
            in_quad(sample.pixel, rows_, scene.scene.target.height), counts);
    }
    return counts;
  }

 private:
  void add(const SampledScene::Sample& sample, const PrimitiveAttributes& attributes,
           const QuadPixel& at, Counts& counts) const {
    if (!sample.derivatives[static_cast<std::size_t>(forms_[0])] ||
        !sample.derivatives[static_cast<std::size_t>(forms_[1])])
      return;
    const std::array<Holds, 2> holds{methods_of(sample, attributes, at, forms_[0]),
                                     methods_of(sample, attributes, at, forms_[1])};
    Holds both{};
    for (std::size_t m = 0; m < method_count(); ++m) both[m] = holds[0][m] && holds[1][m];
    // Where all methods yield the same nothing is learnt; where none does, that they are missing.
    if (std::all_of(both.begin(), both.begin() + static_cast<std::ptrdiff_t>(method_count()),
                    [](bool held) { return held; }))
      return;
    ++counts.of;
    for (std::size_t m = 0; m < method_count(); ++m) {
      for (std::size_t a = 0; a < 2; ++a)
        if (holds[a][m]) ++counts.axis[a][m];
      if (both[m]) ++counts.both[m];
    }
  }

  static Holds methods_of(const SampledScene::Sample& sample, const PrimitiveAttributes& attributes,
                          const QuadPixel& at, Derivative derivative) {
    Holds holds{};
    for (std::size_t m = 0; m < method_count(); ++m) {
      const DerivativeMethod method = values_of<DerivativeMethod>()[m];
      holds[m] = true;
      for (std::size_t c = 0; c < 4 && holds[m]; ++c) {
        const double rendered = (*sample.derivatives[static_cast<std::size_t>(derivative)])[c];
        const Interval range =
            derivative_inexact(attributes.color[c], at, axis_of(derivative), method);
        holds[m] = std::isfinite(rendered) && rounded_to_float(range).contains(to_float(rendered));
      }
    }
    return holds;
  }

  std::array<Derivative, 2> forms_;
  const RuleChoices& found_;
  RowOrder rows_;
};

// What people should know of a form beside the method.
std::string remark_of(const Counts& counts, std::size_t best) {
  const auto method = [](std::size_t m) { return name_of(values_of<DerivativeMethod>()[m]); };
  const std::size_t x = best_of(counts.axis[0]);
  const std::size_t y = best_of(counts.axis[1]);
  if (counts.axis[0][x] == counts.axis[0][best] && counts.axis[1][y] == counts.axis[1][best])
    return "";
  return fmt::format("x and y differ: x is {} ({}), y is {} ({})", method(x),
                     percent({counts.axis[0][x], counts.of}), method(y),
                     percent({counts.axis[1][y], counts.of}));
}

Trait trait_of(Derivative x, const Counts& counts, DerivativeMethod standard) {
  std::size_t best = best_of(counts.both);
  for (std::size_t m = 0; m < method_count(); ++m)
    if (values_of<DerivativeMethod>()[m] == standard && counts.both[m] == counts.both[best])
      best = m;
  Trait trait{name_of(derivative_rule_of(x)),
              name_of(values_of<DerivativeMethod>()[best]),
              {counts.both[best], counts.of},
              "",
              {},
              ""};
  if (counts.of == 0) {
    trait.remark = "no such derivative is told";
    return trait;
  }
  std::size_t second = best == 0 ? 1 : 0;
  for (std::size_t m = 0; m < method_count(); ++m)
    if (m != best && counts.both[m] > counts.both[second]) second = m;
  trait.runner_up = name_of(values_of<DerivativeMethod>()[second]);
  trait.runner_up_rate = {counts.both[second], counts.of};
  trait.remark = remark_of(counts, best);
  return trait;
}

constexpr std::array<std::pair<Derivative, Derivative>, 3> kForms{
    {{Derivative::x, Derivative::y},
     {Derivative::x_fine, Derivative::y_fine},
     {Derivative::x_coarse, Derivative::y_coarse}}};

// Of all forms, with rows of quads counted from one end.
struct Reading {
  RowOrder rows;
  std::array<Counts, 3> forms;

  // Of the samples, those that each form's best method yields.
  Rate rate() const {
    Rate rate;
    for (const Counts& counts : forms) {
      rate.agreeing += counts.both[best_of(counts.both)];
      rate.of += counts.of;
    }
    return rate;
  }
};

Reading read(const std::vector<SampledScene>& scenes, const RuleChoices& found, RowOrder rows) {
  Reading reading{rows, {}};
  for (std::size_t form = 0; form < kForms.size(); ++form)
    reading.forms[form] =
        DerivativeForm(kForms[form].first, kForms[form].second, found, rows).count(scenes);
  return reading;
}

Trait rows_trait(const Reading& best, const Reading& other) {
  Trait trait{name_of(RuleId::derivative_quad_rows),
              name_of(best.rows),
              best.rate(),
              name_of(other.rows),
              other.rate(),
              ""};
  if (trait.rate.of == 0) trait.remark = "no derivative is told";
  return trait;
}

}  // namespace

ValueTraits infer_derivatives(const std::vector<SampledScene>& scenes, const RuleChoices& found) {
  ValueTraits result;
  result.values = found.values;
  Reading best = read(scenes, found, RowOrder::bottom_up);
  Reading other = read(scenes, found, RowOrder::top_down);
  if (other.rate().agreeing > best.rate().agreeing) std::swap(best, other);
  result.values.quad_rows = best.rows;
  for (std::size_t form = 0; form < kForms.size(); ++form) {
    const Trait trait =
        trait_of(kForms[form].first, best.forms[form], ValueChoice{}.derivatives[form]);
    parse_name(trait.alternative, result.values.derivatives[form]);
    result.traits.push_back(trait);
  }
  result.traits.push_back(rows_trait(best, other));
  return result;
}

void DepthTrait::add_failure(const std::string& reason) {
  if (failure_.empty()) failure_ = reason;
}

void DepthTrait::add(const Rendering& rendering) {
  if (rendering.depths.empty()) return;
  const double largest = std::ldexp(1.0, bits_of(format_)) - 1;
  for (const Fragment& fragment : rendering.fragments) {
    if (!fragment.has_depth) continue;
    const double stored = rendering.depths[rendering.pixel_index(fragment.x, fragment.y)];
    const double depth = std::clamp(fragment.depth, 0.0, 1.0);
    if (bits_of(format_) == 0) {
      ++of_;
      if (stored == to_float(depth)) ++agreeing_[0];
      continue;
    }
    // 24 bits times 24 bits: exact.
    const double scaled = depth * largest;
    if (std::floor(scaled) == scaled) continue;
    ++of_;
    const double value = std::nearbyint(stored * largest);
    if (value == std::nearbyint(scaled)) ++agreeing_[0];
    if (value == std::floor(scaled)) ++agreeing_[1];
    if (value == std::ceil(scaled)) ++agreeing_[2];
    if (value != std::floor(scaled) && value != std::ceil(scaled)) ++neither_;
  }
}

Trait DepthTrait::trait() const {
  const std::string id = fmt::format("framebuffer.depth:{}", name_of(format_));
  if (of_ == 0)
    return {id, "not available", {}, "", {}, failure_.empty() ? "no depth is told" : failure_};
  if (bits_of(format_) == 0) return {id, "as told", {agreeing_[0], of_}, "", {}, ""};
  constexpr std::array kNames{"nearest", "truncate", "up"};
  const auto best = static_cast<std::size_t>(std::max_element(agreeing_.begin(), agreeing_.end()) -
                                             agreeing_.begin());
  std::size_t second = best == 0 ? 1 : 0;
  for (std::size_t i = 0; i < kNames.size(); ++i)
    if (i != best && agreeing_[i] > agreeing_[second]) second = i;
  Trait trait{id, kNames[best], {agreeing_[best], of_}, kNames[second], {agreeing_[second], of_},
              ""};
  if (neither_ > 0)
    trait.remark =
        fmt::format("{} of {} depths are neither of the two neighbours of what the fragment tells",
                    neither_, of_);
  return trait;
}

}  // namespace edgecase
