// SPDX-License-Identifier: MIT
//
// Ways to look a texture up: the policy's own, and changes of it, or of the way that the renderer
// is measured to follow, by one or two catalogued alternatives.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "diff/textures/lookup_kinship.h"
#include "model/verdict.h"
#include "rules/choices.h"

namespace edgecase {

struct TextureWay {
  TextureChoice choice;
  Cause cause;       // none: the policy's own way
  bool open = true;  // the specification leaves all of it open, including the policy's choices
};

// The rules of a lookup in which the choice is not one that the specification leaves open, as a
// cause; empty if there are none. Without mip chains.
Cause illegal_part(const TextureChoice& choice);

// At most `most` of the numbers below `count`, including 0, one from each of as many stretches:
// irregularly spaced, since differences may occur in every other column.
std::vector<std::size_t> sample_of(std::size_t count, std::size_t most);

// Lookups whose colours or levels are compared with those of ways.
struct WaySearchLookups {
  std::size_t others = 0;    // lookups that the policy's own way does not yield, from number 0 on
  std::size_t agreeing = 0;  // lookups that it yields
  // True if a choice yields the lookup.
  std::function<bool(std::size_t other, const TextureChoice&)> yields;
  std::function<bool(std::size_t agreeing, const TextureChoice&)> agrees;
};

// Finds a way for each lookup of a case that the policy's own way does not yield.
class TextureWaySearch {
 public:
  // `profile`: the choices that the renderer is measured to follow; null: unknown. `kinds`: of the
  // lookups.
  TextureWaySearch(const TextureChoice& chosen, const TextureChoice* profile,
                   std::span<const LookupKinship> kinds);

  // For each of the others, its way or none. A case uses as few ways as possible. Of the ways that
  // explain its first lookup, the one that explains most others is taken; of several, the one that
  // yields most of the agreeing lookups, then an open one. Single changes come before the profile,
  // and that before pairs of changes: a later one must explain more than twice as many.
  std::vector<std::optional<TextureWay>> explain(const WaySearchLookups& lookups) const;

  // The single changes that yield all of the others and all agreeing ones, of which a sample is
  // asked.
  std::vector<Cause> common(const WaySearchLookups& lookups) const;

 private:
  std::vector<std::vector<TextureWay>> tiers_;
};

}  // namespace edgecase
