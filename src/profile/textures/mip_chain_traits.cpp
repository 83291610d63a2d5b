// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "profile/evidence/tally.h"
#include "profile/textures/textures.h"

namespace edgecase {
namespace {

constexpr auto kSrgb = values_of<MipmapSrgb>();

// A method, as indices of its parts in the catalogue's tables.
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

// Which methods yield one component of a texel.
using Yields = std::vector<bool>;

// Floats from 0 to 1 may err as float32 arithmetic does.
bool is_same(float rendered, float made, TextureFormat format) {
  return holds_floats(format) ? std::fabs(rendered - made) <= 0x1p-19f : rendered == made;
}

void add_yields(const GeneratedChain& chain, std::vector<Yields>& all) {
  for (std::size_t k = 1; k < chain.levels.size(); ++k) {
    const std::vector<float>& rendered = chain.levels[k].texels;
    std::vector<TextureLevel> made;
    for (const Parts& parts : all_parts())
      made.push_back(reduced(chain.levels[k - 1], chain.format, parts.method()));
    for (std::size_t i = 0; i < rendered.size(); ++i) {
      Yields yields;
      for (const TextureLevel& level : made)
        yields.push_back(i < level.texels.size() &&
                         is_same(rendered[i], level.texels[i], chain.format));
      all.push_back(std::move(yields));
    }
  }
}

// Among equals, the first.
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

// One rule, with the two others as in the best method.
Trait trait_of(TraitId id, std::size_t Parts::*part, const Parts& best,
               const std::vector<Yields>& all) {
  Tally tally(names_of_alternatives(id.rule), best.*part);
  for (const Yields& yields : all) {
    Yields agree;
    for (std::size_t i = 0; i < names_of_alternatives(id.rule).size(); ++i) {
      Parts other = best;
      other.*part = i;
      agree.push_back(yields[other.index()]);
    }
    tally.add(agree);
  }
  Trait trait = tally.trait(std::move(id));
  if (all.empty()) trait.remark = "no chain is reported";
  return trait;
}

}  // namespace

std::vector<Trait> infer_mip_chains(std::span<const GeneratedChain> chains) {
  std::vector<Trait> traits;
  for (const TextureFormat format : kTextureFormats) {
    std::vector<Yields> all;
    for (const GeneratedChain& chain : chains)
      if (chain.format == format) add_yields(chain, all);
    const Parts best = best_of(all);
    const std::string probe = probe_of(format);
    traits.push_back(trait_of({RuleId::mipmap_filter, probe}, &Parts::filter, best, all));
    if (!holds_floats(format))
      traits.push_back(trait_of({RuleId::mipmap_rounding, probe}, &Parts::rounding, best, all));
    if (format == TextureFormat::srgb8)
      traits.push_back(trait_of(RuleId::mipmap_srgb, &Parts::srgb, best, all));
  }
  return traits;
}

}  // namespace edgecase
