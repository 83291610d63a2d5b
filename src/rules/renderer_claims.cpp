// SPDX-License-Identifier: MIT
#include "rules/renderer_claims.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

namespace edgecase {
namespace {

// GL_SUBPIXEL_BITS of every implementation (table 23.55).
constexpr int kLeastSubpixelBits = 4;

// A finite number that is the whole text.
std::optional<double> number_in(std::string_view text) {
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(number))
    return std::nullopt;
  return number;
}

class ClaimReader {
 public:
  explicit ClaimReader(const RendererInfo& info) : info_(info) {
    const std::string* const api = trait("api");
    claims_.lookups.is_es = api != nullptr && *api == "OpenGL ES";
  }

  RendererClaims take() {
    claims_.sizes.points = steps("point_size_steps");
    claims_.sizes.lines = steps("sampled_line_width_steps");
    if (claims_.lookups.is_es && claims_.sizes.points.step > 0) {
      refuse("point_size_steps", "OpenGL ES has no steps between sizes of points (3.2, 13.5)");
      claims_.sizes.points = {};
    }
    read_bias();
    if (info_.subpixel_bits < kLeastSubpixelBits)
      claims_.refused.push_back(fmt::format("subpixel_bits {}: at least {} are required",
                                            info_.subpixel_bits, kLeastSubpixelBits));
    return std::move(claims_);
  }

 private:
  const std::string* trait(const char* name) const {
    const auto found = info_.traits.find(name);
    return found == info_.traits.end() ? nullptr : &found->second;
  }

  void refuse(const char* name, const char* why) {
    claims_.refused.push_back(fmt::format("{} \"{}\": {}", name, *trait(name), why));
  }

  SizeSteps steps(const char* name) {
    constexpr std::string_view kBetween = " by ";
    const std::string* const text = trait(name);
    if (text == nullptr) return {};
    const std::size_t by = std::min(text->find(kBetween), text->size());
    const auto least = number_in(std::string_view(*text).substr(0, by));
    const auto step = by < text->size()
                          ? number_in(std::string_view(*text).substr(by + kBetween.size()))
                          : std::nullopt;
    if (!least || !step || *least < 0 || *step <= 0) {
      refuse(name, "it must be two numbers, as in \"1 by 0.125\"");
      return {};
    }
    if (*least <= 1) return {*least, *step};
    refuse(name, "the size 1 must be supported (GL 4.6 core, 14.4.1)");
    return {};
  }

  void read_bias() {
    const std::string* const text = trait("max_texture_lod_bias");
    if (text == nullptr) return;
    const auto bias = number_in(*text);
    if (bias && *bias >= kLeastBiasLimit)
      claims_.lookups.bias = *bias;
    else
      refuse("max_texture_lod_bias",
             "it must be a number of at least 2 (GL 4.6 core, table 23.54)");
  }

  const RendererInfo& info_;
  RendererClaims claims_;
};

}  // namespace

RendererClaims claims_of(const RendererInfo& info) {
  return ClaimReader(info).take();
}

}  // namespace edgecase
