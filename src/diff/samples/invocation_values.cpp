// SPDX-License-Identifier: MIT
//
// How often the shader runs for a pixel of a multisampled primitive (ruling 34).
#include "diff/samples/sample_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <vector>

namespace edgecase {
namespace {

constexpr RuleId kRule = RuleId::sample_shading_rate;
constexpr int kRuling = 34;
constexpr int kRulingOnPartlyCovered = 60;

// The fragments of one primitive in one pixel.
struct Invocations {
  PixelPosition pixel;
  int primitive = 0;
  int count = 0;
  std::uint32_t coverage = 0;  // of all of them together

  int samples() const { return std::popcount(coverage); }
};

std::vector<Invocations> invocations_of(const ValueContext& context, const Rendering& rendered) {
  std::vector<Invocations> all;
  for (const Fragment& f : rendered.fragments) {
    const ScenePrimitive& primitive = context.primitive_of(f);
    if (!is_multisampled(*primitive.state, context.scene.target)) continue;
    const PixelPosition pixel{f.x, f.y};
    if (all.empty() || all.back().pixel != pixel || all.back().primitive != f.primitive)
      all.push_back({pixel, f.primitive});
    ++all.back().count;
    all.back().coverage |= f.coverage;
  }
  return all;
}

class InvocationComparison {
 public:
  InvocationComparison(const ValueContext& context, const Rendering& rendered)
      : context_(context),
        all_(invocations_of(context, rendered)),
        chosen_(context.choices.samples.rate) {}

  // The first rate that yields all invocations, starting with the chosen one; the chosen one if
  // none does.
  ShadingRate followed() const {
    if (yields(chosen_)) return chosen_;
    const auto rates = values_of<ShadingRate>();
    const auto found = std::ranges::find_if(rates, [&](ShadingRate rate) { return yields(rate); });
    return found != rates.end() ? *found : chosen_;
  }

  void run(Result& result) {
    ValueAggregator aggregator("invocations", kRule, kRuling, cause());
    for (const Invocations& one : all_) {
      aggregator.count_compared(1);
      const int exact = expected(one, chosen_);
      if (one.count == exact) continue;
      if (one.count < least(one)) {
        report(one, exact, result);
        continue;
      }
      const ValueAggregate::Place place{one.pixel.x, one.pixel.y, one.primitive};
      aggregator.add_error(place, {0, static_cast<double>(exact), static_cast<double>(one.count),
                                   std::abs(static_cast<double>(one.count - exact)),
                                   static_cast<double>(context_.scene.target.samples)});
      aggregator.add_place(place);
    }
    aggregator.flush(result);
  }

 private:
  const Multisampling& use_of(const Invocations& one) const {
    return context_.primitives[static_cast<std::size_t>(one.primitive)].state->multisampling;
  }

  int expected(const Invocations& one, ShadingRate rate) const {
    return runs_per_sample(use_of(one), context_.scene.target.samples, rate) ? one.samples() : 1;
  }

  // For a pixel that is covered in part, the least is proportional: samples that share an
  // invocation may be covered together.
  int least(const Invocations& one) const {
    const int samples = context_.scene.target.samples;
    const int whole = least_invocations(use_of(one), samples);
    return (whole * one.samples() + samples - 1) / samples;
  }

  // The least if samples share invocations in any way: each sample that is not covered has its own.
  int least_of_any_sharing(const Invocations& one) const {
    const int samples = context_.scene.target.samples;
    const int whole = least_invocations(use_of(one), samples);
    return std::max(1, whole - (samples - one.samples()));
  }

  bool yields(ShadingRate rate) const {
    return std::ranges::all_of(
        all_, [&](const Invocations& one) { return expected(one, rate) == one.count; });
  }
  Cause cause() const {
    return cause_among(values_of<ShadingRate>(), chosen_, kRule,
                       [&](ShadingRate rate) { return yields(rate); });
  }

  void report(const Invocations& one, int exact, Result& result) const {
    const bool may_share = one.count >= least_of_any_sharing(one);
    Disagreement d = value_disagreement(one.pixel, one.primitive, kRule,
                                        may_share ? kRulingOnPartlyCovered : kRuling);
    d.exact = {static_cast<double>(exact)};
    d.rendered = {static_cast<double>(one.count)};
    d.cause = cause();
    d.explanation = fmt::format(
        "the shader runs {} times for the {} samples that primitive {} covers of the pixel; at "
        "least {} are asked for",
        one.count, one.samples(), one.primitive, least(one));
    result.disagreements.push_back(std::move(d));
  }

  const ValueContext& context_;
  const std::vector<Invocations> all_;
  const ShadingRate chosen_;
};

}  // namespace

ShadingRate followed_rate(const ValueContext& context, const Rendering& rendered) {
  return InvocationComparison(context, rendered).followed();
}

void compare_invocations(const ValueContext& context, const Rendering& rendered, Result& result) {
  InvocationComparison(context, rendered).run(result);
}

}  // namespace edgecase
