// SPDX-License-Identifier: MIT
#include "diff/samples/sample_values.h"

#include <algorithm>
#include <bit>
#include <span>
#include <utility>

#include "diff/output/operations_compare.h"
#include "diff/values/pixel_values.h"
#include "raster/samples.h"
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

  void set(std::size_t index, const Writers& writers, int sample) {
    const Fragment* const nearest = likely(writers, sample);
    for (std::size_t c = 0; c < 4; ++c) planes_.low[index + c] = 255;
    for (const Fragment* writer : writers) {
      const PixelTruth truth =
          writer != nullptr ? truth_of_fragment(context_, *writer) : truth_of_clear(context_.scene);
      for (std::size_t c = 0; c < 4; ++c) {
        const Unorm8Range range = unorm8_permitted(truth.permitted[c]);
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

}  // namespace edgecase
