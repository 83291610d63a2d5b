// SPDX-License-Identifier: MIT
//
// The depth buffer (ruling 18): each pixel must hold the depth of the renderer's own last fragment
// there, in the buffer's format, or the clear value. Each sample of a multisampled target has its
// own depth, that of the primitive at the sample, wherever the fragment's attributes were
// evaluated.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "diff/findings/add_disagreement.h"
#include "diff/findings/patience.h"
#include "diff/values/ignored_multisample.h"
#include "diff/values/sample_writers.h"
#include "diff/values/value_causes.h"
#include "diff/values/value_diff.h"
#include "rules/values/framebuffer.h"

namespace edgecase {
namespace {

constexpr RuleId kRule = RuleId::framebuffer_depth;
constexpr int kRuling = 18;
constexpr double kClearDepth = 1;

// The depth before conversion, as exact as it is known.
struct DepthTruth {
  double depth = kClearDepth;
  int primitive = -1;
};

// Where a choice evaluates the depth of a sample, or of a pixel that is not multisampled.
Point depth_place_of(const ValueContext& context, const Fragment& fragment, int sample,
                     const LocationChoice& choice) {
  const ScenePrimitive& primitive = context.primitive_of(fragment);
  const bool multisampled = is_multisampled(*primitive.state, context.scene.target);
  return place_in(
      {fragment.x, fragment.y},
      multisampled ? sample_depth_location(primitive.kind, context.sample_position(sample), choice)
                   : centre_of_pixel());
}

Interval permitted_at(const ValueContext& context, const Fragment& fragment, Point place) {
  return depth_permitted_at(context.values_of(fragment), place);
}

// True if it is drawn without GL_MULTISAMPLE on a target of several samples.
bool lacks_multisampling(const ValueContext& context, const Fragment& fragment) {
  return context.scene.target.samples > 1 &&
         !context.primitive_of(fragment).state->multisampling.enabled;
}

// True if the fragment itself reports the depth that it writes to a sample.
bool reports_depth(const ValueContext& context, const Fragment& fragment) {
  return fragment.has_depth &&
         !is_multisampled(*context.primitive_of(fragment).state, context.scene.target);
}

DepthTruth truth_of(const ValueContext& context, const Fragment* last, int sample) {
  if (last == nullptr) return {};
  if (reports_depth(context, *last)) return {last->depth, last->primitive};
  const Point chosen = depth_place_of(context, *last, sample, context.choices.values.locations);
  return {middle(depth_exact(context.values_of(*last).chosen, chosen)), last->primitive};
}

// All depths that it may have been.
Interval permitted_truth(const ValueContext& context, const Fragment* last, int sample) {
  if (last == nullptr) return kClearDepth;
  if (reports_depth(context, *last))
    return clamped_depth(context.values_of(*last).lawful, last->depth);
  return permitted_at(context, *last, depth_place_of(context, *last, sample, {}));
}

// The distance between stored values near this one.
double step_at(double depth, DepthFormat format) {
  const int bits = bits_of(format);
  return bits == 0 ? float_ulp(depth) : 1 / (std::ldexp(1.0, bits) - 1);
}

void explain(const DepthTruth& truth, double stored, DepthFormat format, Disagreement& d) {
  d.figure = value_figure({d.x, d.y});
  d.exact = {to_depth(truth.depth, format)};
  d.rendered = {stored};
  d.explanation = fmt::format(
      "the depth buffer should hold {:.9g}, {}; it holds {:.9g}", d.exact[0],
      truth.primitive < 0
          ? "the clear value, since no fragment was drawn there"
          : fmt::format("the depth of primitive {}, the last drawn there", truth.primitive),
      stored);
}

class DepthComparison {
 public:
  DepthComparison(const ValueContext& context, const Rendering& rendered)
      : context_(context), rendered_(rendered), format_(context.scene.target.depth) {
    const SamplePositions& positions = context.sample_positions();
    ways_.push_back(positions);
    for (const Point position : positions) ways_.emplace_back(positions.size(), position);
    ways_.emplace_back(positions.size(), centre_of_pixel());
    if (bits_of(format_) > 0)
      bits_ = changes_beside(RuleId::framebuffer_depth_bits, context.choices);
  }

  void run(Result& result) {
    // Fragments are sorted by row, column and primitive, so they are read along with the pixels.
    auto next = rendered_.fragments.begin();
    for (int y = 0; y < rendered_.height; ++y) {
      Patience::check();
      for (int x = 0; x < rendered_.width; ++x) {
        const auto first = next;
        while (next != rendered_.fragments.end() && next->x == x && next->y == y) ++next;
        for (int sample = 0; sample < rendered_.samples; ++sample)
          compare({x, y}, sample, {first, next});
      }
    }
    aggregator_.flush(result);
    report_misses(result);
  }

 private:
  // A sample whose depth is beyond the permitted range.
  struct Miss {
    PixelPosition pixel;
    std::span<const Fragment> fragments;
    const Fragment* writer = nullptr;
    int sample = 0;
    double stored = 0;
  };

  bool is_permitted(const DepthTruth& truth, const Fragment* writer, int sample,
                    double stored) const {
    return stored == to_depth(truth.depth, format_) ||
           (is_depth_of(stored, format_) &&
            depth_permitted(permitted_truth(context_, writer, sample), format_).contains(stored));
  }

  // Without GL_MULTISAMPLE, samples have the depths of single-sample rasterization, those of
  // multisample rasterization, each at its own position, or all that of one sample, which the
  // implementation takes for the centermost (14.3.1, 17.3.10). True if all samples of the pixel
  // that the fragment wrote last have their depths in one of these ways.
  bool is_stored_in_one_way(PixelPosition pixel, std::span<const Fragment> fragments,
                            const Fragment& writer) const {
    return std::ranges::any_of(ways_, [&](const SamplePositions& places) {
      for (int sample = 0; sample < rendered_.samples; ++sample) {
        if (last_writers(context_, fragments, sample) != std::vector<const Fragment*>{&writer})
          continue;
        const double stored = rendered_.depths[rendered_.sample_index(pixel.x, pixel.y, sample)];
        const Point place = place_in(pixel, places[static_cast<std::size_t>(sample)]);
        if (!is_depth_of(stored, format_) || !stores(writer, place, stored)) return false;
      }
      return true;
    });
  }

  bool is_permitted(PixelPosition pixel, std::span<const Fragment> fragments,
                    const Fragment* writer) const {
    return writer != nullptr && lacks_multisampling(context_, *writer) &&
           is_stored_in_one_way(pixel, fragments, *writer);
  }

  void compare(PixelPosition pixel, int sample, std::span<const Fragment> fragments) {
    aggregator_.count_compared(1);
    const double stored = rendered_.depths[rendered_.sample_index(pixel.x, pixel.y, sample)];
    const auto writers = last_writers(context_, fragments, sample);
    if (writers.front() != nullptr)
      std::erase_if(bits_, [&](const Change& change) {
        const DepthBits bits = change.applied_to(context_.choices).output.depth_bits;
        return stored != to_depth(truth_of(context_, writers.front(), sample).depth, format_, bits);
      });
    for (const Fragment* writer : writers) {
      const DepthTruth truth = truth_of(context_, writer, sample);
      if (!is_permitted(truth, writer, sample, stored) && !is_permitted(pixel, fragments, writer))
        continue;
      aggregate(pixel, truth, stored);
      return;
    }
    misses_.push_back({pixel, fragments, writers.front(), sample, stored});
  }

  bool is_one_code_off(const Miss& miss) const {
    if (miss.writer == nullptr) return false;
    const Interval depth = permitted_truth(context_, miss.writer, miss.sample);
    return is_within_one_code(miss.stored, depth_permitted(depth, format_), format_);
  }

  // Reports each miss with the cause that accounts for most of them.
  void report_misses(Result& result) const {
    std::map<Cause, int> counts;
    std::vector<std::vector<Cause>> causes;
    for (const Miss& miss : misses_) {
      Patience::check();
      for (const Cause& cause : causes.emplace_back(causes_of(miss))) ++counts[cause];
    }
    for (std::size_t i = 0; i < misses_.size(); ++i) {
      const Miss& miss = misses_[i];
      DisagreementClass of = value_class(-1, kRule, kRuling);
      of.sample = miss.sample;
      for (const Cause& cause : causes[i])
        if (of.cause.empty() || counts[cause] > counts[of.cause]) of.cause = cause;
      if (of.cause.rule() == RuleId::sample_depth) of.rule = RuleId::sample_depth;
      const bool is_of_codes =
          of.cause.empty() || of.cause.rule() == RuleId::framebuffer_depth_bits;
      if (is_of_codes && is_one_code_off(miss)) of.ruling = kRulingOnDepthCodes;
      if (Disagreement* const d = add_disagreement(result, miss.pixel, of))
        explain(truth_of(context_, miss.writer, miss.sample), miss.stored, format_, *d);
    }
  }

  // Other locations of depths, other behaviour without GL_MULTISAMPLE, or other bits, that yield
  // what is stored.
  std::vector<Cause> causes_of(const Miss& miss) const {
    std::vector<Cause> causes;
    if (miss.writer != nullptr &&
        is_multisampled(*context_.primitive_of(*miss.writer).state, context_.scene.target))
      for (const Change& change : changes_beside(RuleId::sample_depth, context_.choices))
        if (stores(*miss.writer,
                   depth_place_of(context_, *miss.writer, miss.sample,
                                  locations_of(change, context_.choices)),
                   miss.stored))
          causes.push_back(change.id);
    for (const MultisampleSwitch choice : switches_beside(context_, miss.fragments))
      add_causes_of_switch(miss, choice, causes);
    if (miss.writer != nullptr)
      for (const Change& change : bits_) causes.push_back(change.id);
    return causes;
  }

  void add_causes_of_switch(const Miss& miss, MultisampleSwitch choice,
                            std::vector<Cause>& causes) const {
    const Fragment* writer = nullptr;
    for (const Fragment& fragment : miss.fragments)
      if (covers_sample(context_, fragment, miss.sample, choice) &&
          writes_depth(context_, fragment, miss.sample, choice))
        writer = &fragment;
    const Cause cause = cause_of(choice);
    if (writer == nullptr) {
      if (miss.stored == to_depth(kClearDepth, format_)) causes.push_back(cause);
      return;
    }
    if (stores_under(*writer, miss, choice, context_.choices.values.locations)) {
      causes.push_back(cause);
      return;
    }
    for (const Change& change : changes_beside(RuleId::sample_depth, context_.choices))
      if (stores_under(*writer, miss, choice, locations_of(change, context_.choices)))
        causes.push_back(Cause(change.id) + cause);
  }

  bool stores_under(const Fragment& writer, const Miss& miss, MultisampleSwitch choice,
                    const LocationChoice& locations) const {
    const ScenePrimitive& primitive = context_.primitive_of(writer);
    Point place = depth_place_of(context_, writer, miss.sample, locations);
    if (!primitive.state->multisampling.enabled &&
        unsampled(primitive.kind, choice) == Unsampled::by_each_sample)
      place = place_in(
          {writer.x, writer.y},
          sample_depth_location(primitive.kind, context_.sample_position(miss.sample), locations));
    return stores(writer, place, miss.stored);
  }

  // True if what is stored is the fragment's depth at a location.
  bool stores(const Fragment& writer, Point place, double stored) const {
    return depth_permitted(permitted_at(context_, writer, place), format_).contains(stored);
  }

  void aggregate(PixelPosition pixel, const DepthTruth& truth, double stored) {
    if (stored == to_depth(truth.depth, format_)) return;
    const ValueAggregate::Place place{pixel.x, pixel.y, truth.primitive};
    aggregator_.add_error(place, {0, truth.depth, stored,
                                  std::fabs(stored - truth.depth) / step_at(stored, format_), 1});
    aggregator_.add_place(place);
  }

  const ValueContext& context_;
  const Rendering& rendered_;
  const DepthFormat format_;
  // Locations where a pixel's samples may take their depths without GL_MULTISAMPLE, by sample.
  std::vector<SamplePositions> ways_;
  ValueAggregator aggregator_{"depth buffer", kRule, kRuling};
  std::vector<Miss> misses_;
  Changes bits_;  // under which every fragment's depth is stored as it is
};

}  // namespace

void compare_depths(const ValueContext& context, const Rendering& rendered, Result& result) {
  DepthComparison(context, rendered).run(result);
}

}  // namespace edgecase
