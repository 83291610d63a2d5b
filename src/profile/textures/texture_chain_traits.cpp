// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "profile/tally.h"
#include "profile/textures/texture_traits.h"

namespace edgecase {
namespace {

constexpr std::array kFormats{TextureFormat::rgba8, TextureFormat::srgb8, TextureFormat::rgba32f};
constexpr std::array kSrgb{MipmapSrgb::linear, MipmapSrgb::codes};

// Methods by the indices of their parts, all of them.
struct Parts {
  std::size_t filter = 0;
  std::size_t rounding = 0;
  std::size_t srgb = 0;

  MipmapMethod method() const {
    return {values_of<MipmapFilter>()[filter], values_of<MipmapRounding>()[rounding], kSrgb[srgb]};
  }
  std::size_t index() const {
    return (filter * values_of<MipmapRounding>().size() + rounding) * kSrgb.size() + srgb;
  }
};

std::vector<Parts> all_parts() {
  std::vector<Parts> result;
  for (std::size_t f = 0; f < values_of<MipmapFilter>().size(); ++f)
    for (std::size_t r = 0; r < values_of<MipmapRounding>().size(); ++r)
      for (std::size_t s = 0; s < kSrgb.size(); ++s) result.push_back({f, r, s});
  return result;
}

// Of one component of a texel, which methods yield it.
using Yields = std::vector<bool>;

// Floats may err by what float32 arithmetic takes; their numbers lie in 0 to 1.
bool is_same(float told, float made, TextureFormat format) {
  return format == TextureFormat::rgba32f ? std::fabs(told - made) <= 0x1p-19f : told == made;
}

void add_yields(const ToldChain& chain, std::vector<Yields>& all) {
  for (std::size_t k = 1; k < chain.levels.size(); ++k) {
    const std::vector<float>& told = chain.levels[k].texels;
    std::vector<TextureLevel> made;
    for (const Parts& parts : all_parts())
      made.push_back(reduced(chain.levels[k - 1], chain.format, parts.method()));
    for (std::size_t i = 0; i < told.size(); ++i) {
      Yields yields;
      for (const TextureLevel& level : made)
        yields.push_back(i < level.texels.size() &&
                         is_same(told[i], level.texels[i], chain.format));
      all.push_back(std::move(yields));
    }
  }
}

// The catalogue's own, and what comes first, where several do as well.
Parts best_of(const std::vector<Yields>& all) {
  std::vector<std::size_t> counts(all_parts().size());
  for (const Yields& yields : all)
    for (std::size_t i = 0; i < yields.size(); ++i)
      if (yields[i]) ++counts[i];
  Parts best;
  for (const Parts& parts : all_parts())
    if (counts[parts.index()] > counts[best.index()]) best = parts;
  return best;
}

template <std::size_t Parts::*Part>
Trait trait_of(const std::string& id, std::vector<std::string> names, const Parts& best,
               const std::vector<Yields>& all) {
  const std::size_t count = names.size();
  Tally tally(std::move(names), best.*Part);
  for (const Yields& yields : all) {
    Yields agree;
    for (std::size_t i = 0; i < count; ++i) {
      Parts other = best;
      other.*Part = i;
      agree.push_back(yields[other.index()]);
    }
    tally.add(agree);
  }
  Trait trait = tally.trait(id);
  if (all.empty()) trait.remark = "no chain is told";
  return trait;
}

template <class Values>
std::vector<std::string> names_of(const Values& values) {
  std::vector<std::string> names;
  for (const auto value : values) names.push_back(name_of(value));
  return names;
}

}  // namespace

std::vector<Trait> infer_mip_chains(std::span<const ToldChain> chains) {
  std::vector<Trait> traits;
  for (const TextureFormat format : kFormats) {
    std::vector<Yields> all;
    for (const ToldChain& chain : chains)
      if (chain.format == format) add_yields(chain, all);
    const Parts best = best_of(all);
    const std::string suffix =
        format == TextureFormat::rgba8 ? "" : fmt::format(":{}", name_of(format));
    traits.push_back(trait_of<&Parts::filter>(name_of(RuleId::mipmap_filter) + suffix,
                                              names_of(values_of<MipmapFilter>()), best, all));
    if (format != TextureFormat::rgba32f)
      traits.push_back(trait_of<&Parts::rounding>(name_of(RuleId::mipmap_rounding) + suffix,
                                                  names_of(values_of<MipmapRounding>()), best,
                                                  all));
    if (format == TextureFormat::srgb8)
      traits.push_back(
          trait_of<&Parts::srgb>(name_of(RuleId::mipmap_srgb), {"linear", "codes"}, best, all));
  }
  return traits;
}

}  // namespace edgecase
