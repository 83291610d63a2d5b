// SPDX-License-Identifier: MIT
//
// Compares a renderer's mip chains with exact's (rulings 25 and 48). The count and sizes of levels
// are fixed. Contents are not, except that a filter keeps an image of one colour and, if none of
// its weights is negative, stays between the least and the largest of the texels that it reads,
// which lie near the one that it makes. The filter and rounding that make a chain are its cause.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "diff/findings/add_disagreement.h"
#include "diff/textures/texture_lookups.h"
#include "exact/interval.h"
#include "rules/all_rules.h"
#include "rules/textures/mip_chain.h"

namespace edgecase {
namespace {

constexpr int kRuling = 25;

using Chain = std::vector<TextureLevel>;

std::string sizes_of(const Chain& chain) {
  std::string text;
  for (const TextureLevel& level : chain)
    text += fmt::format("{}{}x{}", text.empty() ? "" : ", ", level.width, level.height);
  return text;
}

bool same_sizes(const Chain& a, const Chain& b) {
  return std::ranges::equal(a, b, [](const TextureLevel& left, const TextureLevel& right) {
    return left.width == right.width && left.height == right.height;
  });
}

bool same_number(float a, float b) {
  return a == b || (std::isnan(a) && std::isnan(b));
}

bool same_texels(const TextureLevel& a, const TextureLevel& b) {
  return std::ranges::equal(a.texels, b.texels, same_number);
}

// True if the method makes each level of the chain from the one before.
bool makes(const MipmapMethod& method, const Chain& chain, TextureFormat format) {
  for (std::size_t level = 1; level < chain.size(); ++level)
    if (!same_texels(chain[level], reduced(chain[level - 1], format, method))) return false;
  return true;
}

// The parts of a method that differ from the policy's.
Cause changes_of(const MipmapMethod& method, const MipmapMethod& chosen) {
  Cause cause;
  const auto add = [&](RuleId rule, auto value, auto other) {
    if (value != other) cause.parts.push_back(alternative_id(rule, name_of(value)));
  };
  add(RuleId::mipmap_filter, method.filter, chosen.filter);
  add(RuleId::mipmap_rounding, method.rounding, chosen.rounding);
  add(RuleId::mipmap_srgb, method.srgb, chosen.srgb);
  return cause;
}

// The catalogued way that makes exactly this chain from its level 0, as a cause with as few parts
// as possible; empty if there is none. An empty cause: the policy's own way.
std::optional<Cause> way_of(const Chain& chain, TextureFormat format, const MipmapMethod& chosen) {
  std::optional<Cause> fewest;
  for (const MipmapFilter filter : values_of<MipmapFilter>())
    for (const MipmapRounding rounding : values_of<MipmapRounding>())
      for (const MipmapSrgb srgb : values_of<MipmapSrgb>()) {
        const MipmapMethod method{filter, rounding, srgb};
        Cause cause = changes_of(method, chosen);
        if (fewest && fewest->size() <= cause.size()) continue;
        if (makes(method, chain, format)) fewest = std::move(cause);
      }
  return fewest;
}

// A disagreement about a texture, which has no pixel, is shown at the first one.
Disagreement about_texture(RuleId rule) {
  Disagreement d = value_disagreement({0, 0}, -1, rule, kRuling);
  d.figure = {};
  return d;
}

// The distance of two numbers; very large if one is NaN or infinite.
double distance(double a, double b) {
  const double difference = std::fabs(a - b);
  return std::isfinite(difference) ? difference : 0x1p24;
}

// Texels have no pixel either, and differ at the first one.
void compare_texels(std::size_t texture, const Chain& exact, const Chain& reported,
                    Result& result) {
  constexpr ValueAggregate::Place kPlace{0, 0, -1};
  ValueAggregator aggregator(fmt::format("mip chain of texture {}", texture), RuleId::mipmap_filter,
                             kRuling);
  for (std::size_t level = 1; level < exact.size(); ++level) {
    const TextureLevel& wanted = exact[level];
    for (int j = 0; j < wanted.height; ++j) {
      for (int i = 0; i < wanted.width; ++i) {
        aggregator.count_compared(4);
        bool differs = false;
        for (std::size_t c = 0; c < 4; ++c) {
          const float is = reported[level].texels[wanted.index(i, j) + c];
          const float should = wanted.texels[wanted.index(i, j) + c];
          if (same_number(is, should)) continue;
          differs = true;
          const auto rendered = static_cast<double>(is);
          const auto number = static_cast<double>(should);
          aggregator.add_error(
              kPlace, {static_cast<int>(c), number, rendered, distance(number, rendered), 0});
        }
        if (differs) aggregator.add_place(kPlace);
      }
    }
  }
  aggregator.flush(result);
}

// A chain that a renderer reported, with everything it is compared with.
struct ReportedChain {
  std::size_t texture;
  const Texture& given;
  const Chain& exact;
  const Chain& reported;
  const TextureChoice& chosen;
  bool is_judged;  // by OpenGL, not by the policy alone
};

// The sizes of a chain with this count of levels.
Chain sizes_for(const TextureLevel& base, LevelCount count) {
  Chain chain;
  const int levels = levels_of_chain(base.width, base.height, count);
  for (int level = 0; level < levels; ++level)
    chain.push_back({level_size(base.width, level), level_size(base.height, level), {}});
  return chain;
}

// The count of levels that gives these sizes; no cause if none does.
Cause count_of(const ReportedChain& chain) {
  for (const LevelCount count : {LevelCount::larger_side, LevelCount::smaller_side})
    if (same_sizes(chain.reported, sizes_for(chain.given.levels.front(), count)))
      return alternative_id(RuleId::mipmap_level_count, name_of(count));
  return {};
}

void report_sizes(const ReportedChain& chain, bool legal, Result& result) {
  Disagreement d = about_texture(RuleId::mipmap_level_count);
  d.legality = by_letter(legal);
  d.policy_agrees = same_sizes(chain.exact, chain.reported);
  d.cause = count_of(chain);
  d.exact = {static_cast<double>(chain.exact.size())};
  d.rendered = {static_cast<double>(chain.reported.size())};
  d.explanation = fmt::format("texture {} has the levels {}; the renderer made {}", chain.texture,
                              sizes_of(chain.exact), sizes_of(chain.reported));
  add_disagreement(result, std::move(d));
}

// Level 0 is given by the scene; nothing generates it.
void report_base(const ReportedChain& chain, Result& result) {
  Disagreement d = about_texture(RuleId::mipmap_filter);
  const auto& should = chain.exact[0].texels;
  const auto& is = chain.reported[0].texels;
  for (std::size_t i = 0; i < should.size() && d.exact.empty(); ++i) {
    if (same_number(should[i], is[i])) continue;
    d.exact = {static_cast<double>(should[i])};
    d.rendered = {static_cast<double>(is[i])};
    d.explanation =
        fmt::format("level 0 of texture {} is not what was given: texel {} has {:.9g} for {:.9g}",
                    chain.texture, i / 4, d.rendered[0], d.exact[0]);
  }
  add_disagreement(result, std::move(d));
}

// Texels of a level along one axis, both inclusive.
struct Span {
  int first = 0;
  int last = 0;
};
struct Window {
  Span columns;
  Span rows;
};

// Without what lies beyond the level.
Span clipped(int first, int last, int size) {
  return {std::clamp(first, 0, size - 1), std::clamp(last, 0, size - 1)};
}

int floor_quotient(int dividend, int divisor) {
  return dividend / divisor - (dividend % divisor < 0 ? 1 : 0);
}
int ceiling_quotient(int dividend, int divisor) {
  return -floor_quotient(-dividend, divisor);
}

// What the Khronos tests accept with a warning: up to half a smaller texel beyond its own area,
// ends included (compareGenMipmapVeryLenient in VK-GL-CTS).
Span tested_span(int i, int size, int halved) {
  return clipped(floor_quotient((2 * i - 1) * size, 2 * halved),
                 ceiling_quotient((2 * i + 3) * size, 2 * halved), size);
}

// The texels that the smaller texel's own area meets, and two more on either side. It holds the
// tested span.
Span widest_span(int i, int size, int halved) {
  return clipped(floor_quotient(i * size, halved) - 2, ceiling_quotient((i + 1) * size, halved) + 1,
                 size);
}

// The window of texel i, j of a level, in the level above.
template <class SpanOf>
Window window_of(int i, int j, const TextureLevel& level, const TextureLevel& above,
                 const SpanOf& span_of) {
  return {span_of(i, above.width, level.width), span_of(j, above.height, level.height)};
}

// The least and the largest number of one component; everything if one is NaN or infinite.
Interval range_of(const TextureLevel& level, const Window& window, std::size_t component) {
  Interval range = static_cast<double>(
      level.texels[level.index(window.columns.first, window.rows.first) + component]);
  for (int j = window.rows.first; j <= window.rows.last; ++j)
    for (int i = window.columns.first; i <= window.columns.last; ++i) {
      const auto number = static_cast<double>(level.texels[level.index(i, j) + component]);
      if (!std::isfinite(number)) return Interval::everything();
      range = hull(range, number);
    }
  return range;
}

// Codes may be rounded once, and decoded and encoded again; floats err by 1 part in 10^5.
Interval with_rounding(Interval range, TextureFormat format) {
  const double error = holds_floats(format) ? range.magnitude() * 1e-5 : 1;
  return {range.low - error, range.high + error};
}

// Filters with negative weights in use, cubic and Lanczos ones, lead less than the range of their
// texels beyond it.
Interval with_negative_weights(Interval range) {
  const double size = range.high - range.low;
  return {range.low - size, range.high + size};
}

// A texel that no filter yields (ruling 25), or none that the Khronos tests accept (ruling 48).
struct StrayTexel {
  std::size_t level = 0;
  std::size_t texel = 0;
  std::size_t component = 0;
  Interval range;  // of the texels that bound it
  bool of_one_color = false;
  int ruling = kRuling;
};

bool is_within(float number, Interval range, TextureFormat format) {
  return !std::isfinite(range.magnitude()) ||
         with_rounding(range, format).contains(static_cast<double>(number));
}

// The ruling that a texel breaks, by the texels of the level above near it; 0 if none.
int ruling_on(const TextureLevel& level, int i, int j, std::size_t component,
              const TextureLevel& above, TextureFormat format) {
  const float number = level.texels[level.index(i, j) + component];
  const auto range_in = [&](const auto& span_of) {
    return range_of(above, window_of(i, j, level, above, span_of), component);
  };
  if (is_within(number, range_in(tested_span), format)) return 0;
  const Interval widest = with_negative_weights(range_in(widest_span));
  return is_within(number, widest, format) ? kRulingOnMipHull : kRuling;
}

// The worst texel of a level: the first that breaks ruling 25, else the first that breaks 48.
std::optional<StrayTexel> stray_in(const Chain& chain, std::size_t of, TextureFormat format) {
  const TextureLevel& base = chain[0];
  const TextureLevel& above = chain[of - 1];
  const TextureLevel& level = chain[of];
  const Window whole{{0, base.width - 1}, {0, base.height - 1}};
  std::optional<StrayTexel> found;
  for (std::size_t c = 0; c < 4; ++c) {
    const Interval range = range_of(base, whole, c);
    const bool is_one_color = range.low == range.high;
    for (int j = 0; j < level.height; ++j)
      for (int i = 0; i < level.width; ++i) {
        const std::size_t texel = level.index(i, j);
        if (is_one_color && !is_within(level.texels[texel + c], range, format))
          return StrayTexel{of, texel / 4, c, range, true, kRuling};
        const int ruling = ruling_on(level, i, j, c, above, format);
        if (ruling == 0 || (found && (found->ruling == kRuling || ruling != kRuling))) continue;
        const Window widest = window_of(i, j, level, above, widest_span);
        found = StrayTexel{of, texel / 4, c, range_of(above, widest, c), false, ruling};
      }
  }
  return found;
}

std::optional<StrayTexel> find_stray(const Chain& chain, TextureFormat format) {
  std::optional<StrayTexel> found;
  for (std::size_t level = 1; level < chain.size(); ++level) {
    const auto stray = stray_in(chain, level, format);
    if (!stray) continue;
    if (stray->ruling == kRuling) return stray;
    if (!found) found = stray;
  }
  return found;
}

void report_stray(const ReportedChain& chain, const StrayTexel& stray, Result& result) {
  Disagreement d = about_texture(RuleId::mipmap_filter);
  d.ruling = stray.ruling;
  const TextureLevel& level = chain.reported[stray.level];
  d.exact = {
      static_cast<double>(chain.exact[stray.level].texels[4 * stray.texel + stray.component])};
  d.rendered = {static_cast<double>(level.texels[4 * stray.texel + stray.component])};
  const std::string of_above =
      stray.of_one_color ? fmt::format("all of level 0 has {:.9g}", stray.range.low)
                         : fmt::format("level {} has {:.9g} to {:.9g} within two texels",
                                       stray.level - 1, stray.range.low, stray.range.high);
  constexpr const char* kComponents[] = {"red", "green", "blue", "alpha"};
  d.explanation = fmt::format("level {} of texture {}: texel {} has a {} of {:.9g}, and {}",
                              stray.level, chain.texture, stray.texel, kComponents[stray.component],
                              d.rendered[0], of_above);
  add_disagreement(result, std::move(d));
}

void report_way(const ReportedChain& chain, const Cause& way, Result& result) {
  Disagreement d = about_texture(way.size() == 1 ? way.rule() : RuleId::mipmap_filter);
  d.legality = Legality::legal;
  d.cause = way;
  d.exact = {static_cast<double>(chain.exact.size())};
  d.rendered = {static_cast<double>(chain.reported.size())};
  d.explanation =
      fmt::format("the levels of texture {} are what {} makes", chain.texture, text_of(way));
  add_disagreement(result, std::move(d));
}

void compare_chain(const ReportedChain& chain, Result& result) {
  const bool legal =
      same_sizes(chain.reported, sizes_for(chain.given.levels.front(), LevelCount::larger_side));
  const bool same = same_sizes(chain.exact, chain.reported);
  if (!same || (chain.is_judged && !legal)) report_sizes(chain, legal, result);
  if (!same) return;
  if (!same_texels(chain.exact[0], chain.reported[0])) return report_base(chain, result);
  if (std::ranges::equal(chain.exact, chain.reported, same_texels)) return;
  if (const auto stray = find_stray(chain.reported, chain.given.format); stray && chain.is_judged)
    report_stray(chain, *stray, result);
  const std::optional<Cause> way = way_of(chain.reported, chain.given.format, chain.chosen.mipmap);
  if (way && !way->empty())
    report_way(chain, *way, result);
  else
    compare_texels(chain.texture, chain.exact, chain.reported, result);
}

}  // namespace

void compare_mip_chains(const ValueContext& context, const Rendering& exact,
                        const Rendering& rendered, Result& result) {
  for (const auto& [texture, reported] : rendered.mip_chains) {
    const auto wanted = exact.mip_chains.find(texture);
    if (wanted == exact.mip_chains.end()) continue;
    compare_chain({texture, *context.scene.textures[texture], wanted->second, reported,
                   context.choices.textures, context.latitude != Latitude::none},
                  result);
  }
}

}  // namespace edgecase
