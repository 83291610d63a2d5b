// SPDX-License-Identifier: MIT
//
// Pixels (rulings 10 and 11): each must hold the colour of the renderer's own last fragment there,
// or the clear colour. This catches a renderer that reports correct fragments and shows a wrong
// picture.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <utility>
#include <vector>

#include "diff/findings/add_disagreement.h"
#include "diff/findings/patience.h"
#include "diff/values/ignored_multisample.h"
#include "diff/values/pixel_truth.h"
#include "diff/values/sample_writers.h"
#include "diff/values/value_diff.h"
#include "rules/values/framebuffer.h"

namespace edgecase {
namespace {

bool is_within(const std::uint8_t* pixel, const std::array<Interval, 4>& bounds) {
  for (std::size_t c = 0; c < 4; ++c) {
    const Unorm8Range range = unorm8_permitted(bounds[c]);
    if (pixel[c] < range.low || pixel[c] > range.high) return false;
  }
  return true;
}

bool is_stored(const std::uint8_t* pixel, const PixelTruth& truth) {
  return is_within(pixel, truth.permitted);
}

// "0 to 3, 255, 17 to 19, 255"
std::string codes_of(const PixelTruth& truth) {
  std::string text;
  for (const Interval& component : truth.permitted) {
    const Unorm8Range range = unorm8_permitted(component);
    text += fmt::format("{}{}", text.empty() ? "" : ", ", range.low);
    if (range.high != range.low) text += fmt::format(" to {}", range.high);
  }
  return text;
}

class PixelComparison {
 public:
  PixelComparison(const ValueContext& context, const Rendering& rendered)
      : context_(context), rendered_(rendered), clear_(truth_of_clear(context.scene)) {
    for (std::size_t c = 0; c < 4; ++c) clear_code_[c] = to_unorm8(clear_.exact[c]);
    if (!is_stored(clear_code_.data(), clear_)) return;
    clear_row_.resize(4 * static_cast<std::size_t>(rendered_.width));
    for (auto at = clear_row_.begin(); at != clear_row_.end(); at += 4)
      std::ranges::copy(clear_code_, at);
  }

  void run(Result& result) {
    // Fragments are sorted by row, column and primitive, so they are read along with the pixels.
    auto next = rendered_.fragments.begin();
    for (int y = 0; y < rendered_.height; ++y) {
      Patience::check();
      for (int x = 0; x < rendered_.width; ++x) {
        const bool is_of_row = next != rendered_.fragments.end() && next->y == y;
        x = skip_clear({x, y}, is_of_row ? std::min(next->x, rendered_.width) : rendered_.width);
        if (x == rendered_.width) break;
        const auto first = next;
        while (next != rendered_.fragments.end() && next->x == x && next->y == y) ++next;
        compare_samples({x, y}, {first, next}, result);
      }
    }
    aggregator_.flush(result);
    if (may_be_dithered_) compare_dithering(context_, rendered_, result);
  }

 private:
  bool is_multisampled() const { return rendered_.samples > 1; }

  // The first column of a row, from a pixel on and up to column `end`, before which nothing was
  // drawn, that does not hold the clear colour; else `end`.
  int skip_clear(PixelPosition from, int end) {
    if (is_multisampled() || clear_row_.empty() || end <= from.x) return from.x;
    const auto size = 4 * static_cast<std::size_t>(end - from.x);
    const std::uint8_t* const stored =
        rendered_.pixels.data() + 4 * rendered_.pixel_index(from.x, from.y);
    std::size_t same = size;
    if (std::memcmp(stored, clear_row_.data(), size) != 0)
      same = static_cast<std::size_t>(
          std::mismatch(stored, stored + size, clear_row_.begin()).first - stored);
    aggregator_.count_compared(4, same / 4);
    return from.x + static_cast<int>(same / 4);
  }

  void compare_samples(PixelPosition pixel, std::span<const Fragment> fragments, Result& result) {
    for (int sample = 0; sample < rendered_.samples; ++sample) {
      const std::vector<std::uint8_t>& planes =
          is_multisampled() ? rendered_.sample_pixels : rendered_.pixels;
      compare(pixel, sample, fragments,
              planes.data() + 4 * rendered_.sample_index(pixel.x, pixel.y, sample), result);
    }
  }

  PixelTruth truth_of(const Fragment* fragment) const {
    return fragment != nullptr ? truth_of_fragment(context_, *fragment) : clear_;
  }

  void compare(PixelPosition pixel, int sample, std::span<const Fragment> fragments,
               const std::uint8_t* stored, Result& result) {
    aggregator_.count_compared(4);
    // Nothing was drawn, and nothing is there: most pixels of most scenes.
    if (fragments.empty() && !clear_row_.empty() && is_clear(stored)) return;
    if (holds_last_color(fragments, stored)) return;
    const auto all = last_writers(context_, fragments, sample);
    // compare_sample_hits tests what alpha to coverage kept from writing, if hits are reported.
    const auto writers = rendered_.hits.empty() ? left_by_alpha(context_, all) : all;
    const auto holds_color_of = [&](const Fragment* writer) {
      return is_stored(stored, truth_of(writer));
    };
    const auto found = std::ranges::find_if(writers, holds_color_of);
    if (found != writers.end()) {
      aggregate(pixel, *found, stored);
      return;
    }
    const Fragment* const last = writers.front();
    const Fragment* const earlier = earlier_one(fragments, sample, last, stored);
    DisagreementClass of = value_class(-1, RuleId::framebuffer_unorm8);
    of.sample = sample;
    of.cause = cause_of_switch(fragments, sample, stored);
    if (std::ranges::any_of(all, holds_color_of))
      put_under(RuleId::sample_alpha_to_coverage, of);
    else if (earlier != nullptr)
      put_under(RuleId::framebuffer_order, of);
    else
      contest(truth_of(last), stored, of);
    if (Disagreement* const d = add_disagreement(result, pixel, of))
      explain(last, earlier, stored, *d);
  }

  // A colour that only a contested ruling accepts stands under that one.
  static void contest(const PixelTruth& truth, const std::uint8_t* stored, DisagreementClass& of) {
    const auto contested = std::ranges::find_if(
        truth.contested, [&](const auto& more) { return is_within(stored, more.bounds); });
    if (contested == truth.contested.end()) return;
    of.rule = contested->rule;
    of.ruling = contested->ruling;
  }

  // Compares all four bytes as one word.
  bool is_clear(const std::uint8_t* stored) const {
    std::array<std::uint8_t, 4> code;
    std::copy_n(stored, code.size(), code.begin());
    return std::bit_cast<std::uint32_t>(code) == std::bit_cast<std::uint32_t>(clear_code_);
  }

  // True if a pixel holds the rounded colour that its last fragment reported; then it is correct.
  // Neighbours mostly have the same colour.
  bool holds_last_color(std::span<const Fragment> fragments, const std::uint8_t* stored) {
    if (is_multisampled() || fragments.empty() || !fragments.back().has_color) return false;
    const std::array<double, 4>& color = fragments.back().color;
    if (color != last_color_) {
      if (std::ranges::any_of(color, [](double component) { return std::isnan(component); }))
        return false;
      last_color_ = color;
      std::ranges::transform(color, last_code_.begin(), to_unorm8);
    }
    return std::ranges::equal(last_code_, std::span(stored, last_code_.size()));
  }

  // Behaviour without GL_MULTISAMPLE that yields what is stored.
  Cause cause_of_switch(std::span<const Fragment> fragments, int sample,
                        const std::uint8_t* stored) const {
    for (const MultisampleSwitch choice : switches_beside(context_, fragments))
      for (const Fragment* writer : last_writers(context_, fragments, sample, choice))
        if (is_stored(stored, truth_of(writer))) return cause_of(choice);
    return {};
  }

  void aggregate(PixelPosition pixel, const Fragment* writer, const std::uint8_t* stored) {
    const PixelTruth truth = truth_of(writer);
    const bool is_told = writer == nullptr || writer->has_color;
    const ValueAggregate::Place place{pixel.x, pixel.y, writer == nullptr ? -1 : writer->primitive};
    bool differs = false;
    for (std::size_t c = 0; c < 4; ++c) {
      if (stored[c] == to_unorm8(truth.exact[c])) continue;
      differs = true;
      may_be_dithered_ = may_be_dithered_ || (!is_multisampled() && has_one_color(writer));
      const double exact = truth.exact[c] * 255;
      ValueAggregator::Error error{static_cast<int>(c), exact, static_cast<double>(stored[c]),
                                   std::fabs(stored[c] - exact), 255};
      const Unorm8Range codes = unorm8_permitted(truth.permitted[c]);
      if (!is_told) error.permitted = Interval(codes.low, codes.high);
      aggregator_.add_error(place, error);
    }
    if (differs) aggregator_.add_place(place);
  }

  bool has_one_color(const Fragment* writer) const {
    return writer == nullptr || has_flat_color(context_, *writer);
  }

  // An earlier fragment that has the stored colour, or none.
  const Fragment* earlier_one(std::span<const Fragment> fragments, int sample, const Fragment* last,
                              const std::uint8_t* stored) const {
    const Fragment* earlier = nullptr;
    for (const Fragment& fragment : fragments) {
      if (&fragment == last) break;
      if (covers_sample(context_, fragment, sample) &&
          is_stored(stored, truth_of_fragment(context_, fragment)))
        earlier = &fragment;
    }
    return earlier;
  }

  void explain(const Fragment* last, const Fragment* earlier, const std::uint8_t* stored,
               Disagreement& d) const {
    d.figure = value_figure({d.x, d.y});
    const PixelTruth truth = truth_of(last);
    for (std::size_t c = 0; c < 4; ++c) {
      d.exact.push_back(to_unorm8(truth.exact[c]));
      d.rendered.push_back(stored[c]);
    }
    const std::string what =
        last == nullptr
            ? "the clear colour, since no fragment was drawn there"
            : fmt::format("the colour of primitive {}, the last drawn there", last->primitive);
    std::string note;
    if (earlier != nullptr)
      note = fmt::format("; that is the colour of primitive {}, drawn earlier", earlier->primitive);
    else if (last != nullptr && is_stored(stored, clear_))
      note = "; that is the clear colour";
    if (last != nullptr && !last->has_color)
      note += fmt::format(". The fragment does not tell its colour; the specification permits {}",
                          codes_of(truth));
    d.explanation = fmt::format("the {} should hold {}, ({}); it holds ({}){}",
                                is_multisampled() ? fmt::format("sample {}", d.sample) : "pixel",
                                what, fmt::join(d.exact, ", "), fmt::join(d.rendered, ", "), note);
  }

  const ValueContext& context_;
  const Rendering& rendered_;
  PixelTruth clear_;
  std::array<std::uint8_t, 4> clear_code_{};  // as it is stored
  std::vector<std::uint8_t> clear_row_;       // one row; empty if pixels must not hold it
  std::array<double, 4> last_color_{};        // the latest colour of a last fragment
  std::array<std::uint8_t, 4> last_code_{};   // the same in 8 bits
  bool may_be_dithered_ = false;              // some flat colour is not stored as its nearest code
  ValueAggregator aggregator_{"pixel", RuleId::framebuffer_unorm8};
};

}  // namespace

void compare_pixels(const ValueContext& context, const Rendering& rendered, Result& result) {
  PixelComparison(context, rendered).run(result);
}

}  // namespace edgecase
