// SPDX-License-Identifier: MIT
#include "rules/textures/wrap.h"

#include <algorithm>

namespace edgecase {
namespace {

// The remainder of a division that rounds down: 0 to period - 1.
int rest_of(std::int64_t texel, int period) {
  const std::int64_t rest = texel % period;
  return static_cast<int>(rest < 0 ? rest + period : rest);
}

// The image and its mirror image alternate.
int mirrored(std::int64_t texel, int size) {
  const int rest = rest_of(texel, 2 * size);
  return rest < size ? rest : 2 * size - 1 - rest;
}

}  // namespace

Wrap effective(Wrap wrap, WrapChoice choice) {
  const bool replaced = choice == WrapChoice::mirrored_as_repeat && wrap == Wrap::mirrored_repeat;
  return replaced ? Wrap::repeat : wrap;
}

std::optional<int> wrapped(std::int64_t texel, int size, Wrap wrap, WrapChoice choice) {
  switch (effective(wrap, choice)) {
    case Wrap::repeat:
      return rest_of(texel, size);
    case Wrap::mirrored_repeat:
      return mirrored(texel, size);
    case Wrap::clamp_to_edge:
      return static_cast<int>(std::clamp<std::int64_t>(texel, 0, size - 1));
    case Wrap::clamp_to_border:
      if (texel < 0 || texel >= size) return std::nullopt;
      return static_cast<int>(texel);
  }
  return std::nullopt;
}

Rule wrap_rule() {
  return {RuleId::texture_wrap,
          "Texels beyond the image are found as the texture's wrap mode says",
          "8.14.2 (coordinate wrapping and texel selection)",
          "none",
          "as-set",
          alternatives_of<WrapChoice>(),
          {}};
}

}  // namespace edgecase
