// SPDX-License-Identifier: MIT
//
// Ways to look a texture up: the policy's own, and those that one or two catalogued alternatives
// make of it or of what the renderer is measured to follow.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "model/cause.h"
#include "model/texture.h"
#include "rules/choices.h"

namespace edgecase {

// Which choices about textures a lookup can show: without a mirrored image none about mirroring.
//
// A kind of lookups: of one draw, in primitives with perspective or without.
struct LookupKinship {
  const TextureUse* use = nullptr;
  const Texture* texture = nullptr;
  bool has_perspective = false;  // are derivatives other from pixel to pixel?
  bool is_query = false;         // of textureQueryLod, which shows no texel
  bool is_level_given = false;   // lambda' is what the renderer tells, whatever it made it of
};

// Does the level of detail show in the lookup?
bool shows_level(const LookupKinship& kin);

// The choice with OpenGL's own in the place of all that such a lookup cannot show: two choices of
// which this makes the same yield the same.
TextureChoice relevant_part(const TextureChoice& choice, const LookupKinship& kin);

struct TextureWay {
  TextureChoice choice;
  Cause cause;       // none: the policy's own way
  bool open = true;  // the specification leaves all of it open, what the policy chooses included
};

// The rules of a lookup in which a choice is not one that the specification leaves open, as a
// cause; none: there are none. Mip chains aside.
Cause illegal_part(const TextureChoice& choice);

// At most so many of a row's numbers, 0 with them, one from each of as many stretches: irregularly,
// since what differs may do so in every other column.
std::vector<std::size_t> sample_of(std::size_t count, std::size_t most);

// Lookups whose colours or levels are held against ways.
struct WaySearchLookups {
  std::size_t others = 0;    // lookups that the policy's own way does not yield: number 0 and so on
  std::size_t agreeing = 0;  // lookups that it yields
  // Does a lookup come out so under a choice?
  std::function<bool(std::size_t other, const TextureChoice&)> yields;
  std::function<bool(std::size_t agreeing, const TextureChoice&)> agrees;
};

// Which way each of a case's lookups went that the policy's own does not yield.
class TextureWaySearch {
 public:
  // `profile`: what the renderer is measured to follow; null: not known. `kinds`: of the lookups.
  TextureWaySearch(const TextureChoice& chosen, const TextureChoice* profile,
                   std::span<const LookupKinship> kinds);

  // For each of the others, the way or none. A case goes as few ways as explain it. Of the ways
  // that explain its first lookup the one that explains most others is taken; of several, the one
  // that yields most of what agrees, too, then one that is open. Single changes come before the
  // profile, that before pairs of changes: what comes later must explain more than twice as many.
  std::vector<std::optional<TextureWay>> explain(const WaySearchLookups& lookups) const;

 private:
  std::vector<std::vector<TextureWay>> tiers_;
};

}  // namespace edgecase
