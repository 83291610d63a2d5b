// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "diff/findings/add_disagreement.h"
#include "diff/findings/patience.h"
#include "diff/output/operations_compare.h"
#include "diff/samples/sample_values.h"
#include "diff/values/pixel_truth.h"
#include "diff/values/sample_writers.h"
#include "raster/samples.h"
#include "rules/samples/shading_rate.h"
#include "rules/values/framebuffer.h"

namespace edgecase {
namespace {

using Writers = std::vector<const Fragment*>;  // null: the clear colour

class Inference {
 public:
  Inference(const ValueContext& context, const Rendering& rendered, AlphaEnds ends)
      : context_(context), rendered_(rendered), ends_(ends) {
    const std::size_t size = rendered.pixels.size() * static_cast<std::size_t>(rendered.samples);
    planes_.low.resize(size);
    planes_.nearest.resize(size);
    planes_.high.resize(size);
  }

  SamplePlanes run() {
    auto next = rendered_.fragments.begin();
    for (int y = 0; y < rendered_.height; ++y) {
      for (int x = 0; x < rendered_.width; ++x) {
        const auto first = next;
        while (next != rendered_.fragments.end() && next->x == x && next->y == y) ++next;
        truths_.clear();
        for (int sample = 0; sample < rendered_.samples; ++sample) {
          const std::size_t index = rendered_.sample_index(x, y, sample);
          set(4 * index, writers({first, next}, sample, index), sample);
        }
      }
    }
    return std::move(planes_);
  }

 private:
  Writers writers(std::span<const Fragment> fragments, int sample, std::size_t index) const {
    const Writers all = last_writers(context_, fragments, sample);
    if (all.size() == 1) return all;
    if (!rendered_.hits.empty()) return left_by_hits(all, fragments, sample, index);
    return ends_ == AlphaEnds::heeded ? left_by_alpha(context_, all) : all;
  }

  // All writers but the last depend on their alphas.
  Writers left_by_hits(const Writers& all, std::span<const Fragment> fragments, int sample,
                       std::size_t index) const {
    std::uint32_t least = 0;
    std::uint32_t most = 0;
    for (const Fragment& fragment : fragments) {
      if (!covers_sample(context_, fragment, sample)) continue;
      ++most;
      if (!is_thinned(context_, fragment)) ++least;
    }
    if (rendered_.hits[index] >= most) return {all.front()};
    if (rendered_.hits[index] <= least) return {all.back()};
    return all;
  }

  // The last writer of the sample if alpha to coverage follows the policy.
  const Fragment* likely(const Writers& writers, int sample) const {
    const AlphaToCoverage choice = context_.choices.samples.alpha_to_coverage;
    const auto writes = [&](const Fragment* writer) {
      if (writer == nullptr || !is_thinned(context_, *writer) || !writer->has_color) return true;
      return (alpha_mask(writer->color[3], rendered_.samples, choice) >> sample & 1) != 0;
    };
    const auto found = std::ranges::find_if(writers, writes);
    return found != writers.end() ? *found : writers.front();
  }

  // Samples of a pixel mostly have the same writers.
  const PixelTruth& truth_of(const Fragment* writer) {
    Patience::check();
    const auto [known, is_new] = truths_.try_emplace(writer);
    if (is_new)
      known->second =
          writer != nullptr ? truth_of_fragment(context_, *writer) : truth_of_clear(context_.scene);
    return known->second;
  }

  void set(std::size_t index, const Writers& writers, int sample) {
    const Fragment* const nearest = likely(writers, sample);
    for (std::size_t c = 0; c < 4; ++c) planes_.low[index + c] = 255;
    for (const Fragment* writer : writers) {
      const PixelTruth& truth = truth_of(writer);
      for (std::size_t c = 0; c < 4; ++c) {
        const Unorm8Range range = unorm8_permitted(accepted(truth, c));
        std::uint8_t& low = planes_.low[index + c];
        std::uint8_t& high = planes_.high[index + c];
        low = static_cast<std::uint8_t>(std::min<int>(low, range.low));
        high = static_cast<std::uint8_t>(std::max<int>(high, range.high));
        if (writer == nearest) planes_.nearest[index + c] = to_unorm8(truth.exact[c]);
      }
    }
  }

  const ValueContext& context_;
  const Rendering& rendered_;
  const AlphaEnds ends_;
  std::map<const Fragment*, PixelTruth> truths_;  // of one pixel
  SamplePlanes planes_;
};

}  // namespace

SamplePlanes reported_samples(const Rendering& rendered) {
  return {rendered.sample_pixels, rendered.sample_pixels, rendered.sample_pixels};
}

SamplePlanes inferred_samples(const ValueContext& context, const Rendering& rendered,
                              AlphaEnds ends) {
  if (has_fragment_operations(context.scene)) return samples_by_operations(context, rendered, ends);
  return Inference(context, rendered, ends).run();
}

// How often the shader runs for a pixel of a multisampled primitive (ruling 34).

namespace {

constexpr RuleId kRule = RuleId::sample_shading_rate;
constexpr int kRuling = 34;

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
    add_disagreement(result, std::move(d));
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
