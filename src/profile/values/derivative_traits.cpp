// SPDX-License-Identifier: MIT
//
// Which derivatives a renderer takes, and how it converts depths.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <utility>

#include "diff/values/value_diff.h"
#include "profile/evidence/inference.h"
#include "profile/values/values.h"
#include "raster/attributes.h"
#include "rules/values/framebuffer.h"

namespace edgecase {
namespace {

constexpr std::size_t kMostMethods = 16;
using Holds = std::array<bool, kMostMethods>;

std::size_t method_count() {
  return values_of<DerivativeMethod>().size();
}

std::size_t index_of(const std::string& method) {
  const auto names = names_of<DerivativeMethod>();
  return static_cast<std::size_t>(std::ranges::find(names, method) - names.begin());
}

// Counts for one form of derivative, over the samples that distinguish methods.
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

  Counts count(std::span<const SampledScene> scenes) const {
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
    // A sample that all methods yield is evidence for none. One that none yields counts against
    // all.
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

// The remark if x and y follow different methods.
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

Trait trait_of(Derivative x, const Counts& counts) {
  const auto names = names_of_alternatives(derivative_rule_of(x));
  const auto methods = values_of<DerivativeMethod>();
  const auto own = std::ranges::find(methods, ValueChoice{}.derivatives[form_of(x)]);
  Trait trait = leading(derivative_rule_of(x), names, std::span(counts.both).first(names.size()),
                        counts.of, static_cast<std::size_t>(own - methods.begin()));
  if (counts.of > 0) {
    trait.remark = remark_of(counts, index_of(trait.alternative));
    return trait;
  }
  trait.runner_up.clear();
  trait.remark = "no such derivative is reported";
  return trait;
}

constexpr std::array<std::pair<Derivative, Derivative>, 3> kForms{
    {{Derivative::x, Derivative::y},
     {Derivative::x_fine, Derivative::y_fine},
     {Derivative::x_coarse, Derivative::y_coarse}}};

// All forms, with rows of quads counted from one end.
struct Reading {
  RowOrder rows;
  std::array<Counts, 3> forms;

  // The share of samples that each form's best method yields.
  Rate rate() const {
    Rate rate;
    for (const Counts& counts : forms) {
      rate.agreeing += counts.both[best_of(counts.both)];
      rate.of += counts.of;
    }
    return rate;
  }
};

Reading read(std::span<const SampledScene> scenes, const RuleChoices& found, RowOrder rows) {
  Reading reading{rows, {}};
  for (std::size_t form = 0; form < kForms.size(); ++form)
    reading.forms[form] =
        DerivativeForm(kForms[form].first, kForms[form].second, found, rows).count(scenes);
  return reading;
}

Trait rows_trait(const Reading& best, const Reading& other) {
  Trait trait{RuleId::derivative_quad_rows, name_of(best.rows), best.rate(),
              name_of(other.rows),          other.rate(),       ""};
  if (trait.rate.of == 0) trait.remark = "no derivative is reported";
  return trait;
}

}  // namespace

std::vector<Trait> infer_derivatives(std::span<const SampledScene> scenes, RuleChoices& found) {
  Reading best = read(scenes, found, RowOrder::bottom_up);
  Reading other = read(scenes, found, RowOrder::top_down);
  if (other.rate().agreeing > best.rate().agreeing) std::swap(best, other);
  std::vector<Trait> traits;
  for (std::size_t form = 0; form < kForms.size(); ++form)
    traits.push_back(trait_of(kForms[form].first, best.forms[form]));
  traits.push_back(rows_trait(best, other));
  for (const Trait& trait : traits)
    found = with_alternative(found, trait.id.rule, trait.alternative);
  return traits;
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
  TraitId id{RuleId::framebuffer_depth, name_of(format_)};
  if (of_ == 0)
    return {std::move(id),
            "not available",
            {},
            "",
            {},
            failure_.empty() ? "no depth is reported" : failure_};
  if (bits_of(format_) == 0) return {std::move(id), "as told", {agreeing_[0], of_}};
  static const std::array<std::string, 3> kNames{"nearest", "truncate", "up"};
  Trait trait = leading(std::move(id), kNames, agreeing_, of_);
  if (neither_ > 0)
    trait.remark = fmt::format(
        "{} of {} depths are neither of the two neighbours of the fragment's own", neither_, of_);
  return trait;
}

}  // namespace edgecase
