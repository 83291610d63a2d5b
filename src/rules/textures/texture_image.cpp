// SPDX-License-Identifier: MIT
#include "rules/textures/texture_image.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "exact/elementary.h"
#include "rules/textures/directed.h"

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

namespace {

constexpr int kCodes = 256;

using CodeTable = std::array<Interval, kCodes>;

// A float32 number; NaN may be any number.
Interval number_of(float value) {
  if (std::isnan(value)) return Interval::everything();
  return static_cast<double>(value);
}

// Converts each component of a stored texel to a number.
class Decoder {
 public:
  explicit Decoder(TextureFormat format) : format_(format) {}

  Interval operator()(float stored, std::size_t component) const {
    constexpr std::size_t kAlpha = 3;
    if (holds_floats(format_)) return number_of(stored);
    const bool coded = format_ == TextureFormat::srgb8 && component != kAlpha;
    return (coded ? linear_ : numbers_)[code_of(stored)];
  }

 private:
  static CodeTable table_of(Interval (*number)(int)) {
    CodeTable table;
    for (int code = 0; code < kCodes; ++code) table[static_cast<std::size_t>(code)] = number(code);
    return table;
  }
  // Clamped to the table, whatever a renderer may report of its levels.
  static std::size_t code_of(float stored) {
    return stored > 0 ? static_cast<std::size_t>(std::min(stored, 255.0F)) : 0;
  }

  static inline const CodeTable numbers_ = table_of(unorm8_to_number);
  static inline const CodeTable linear_ = table_of(srgb_to_linear);
  TextureFormat format_;
};

}  // namespace

Interval unorm8_to_number(int code) {
  return {Down::quotient(code, 255), Up::quotient(code, 255)};
}

// Both pieces over whole numbers: s/12.92 is 5 code/16473, and (s + 0.055)/1.055 is
// (40 code + 561)/10761.
//
// The error of the power, in units of 2^-53 of the result: the quotient is off by 1, which the
// power makes 2.4; the double next to 2.4 is off by 2^-53, times a logarithm of less than 2.4 in
// magnitude: 2.4; the power itself is off by less than 2, one unit in the last place. The total is
// less than 8 units, 2^-50.
Interval srgb_to_linear(int code) {
  if (code == 255) return 1;
  constexpr int kLastOfLine = 10;  // 10/255 < 0.04045 < 11/255
  if (code <= kLastOfLine)
    return {Down::quotient(5.0 * code, 16473), Up::quotient(5.0 * code, 16473)};
  constexpr double kError = 0x1p-50;
  const double power = raised((40.0 * code + 561) / 10761, 2.4);
  return {Down::product(power, 1 - kError), Up::product(power, 1 + kError)};
}

double srgb_to_linear_number(double coded) {
  const double s = std::clamp(coded, 0.0, 1.0);
  return s <= 0.04045 ? s / 12.92 : std::min(raised((s + 0.055) / 1.055, 2.4), 1.0);
}

double linear_to_srgb_number(double linear) {
  constexpr double kEndOfLine = 0.04045 / 12.92;
  const double l = std::clamp(linear, 0.0, 1.0);
  return l <= kEndOfLine ? l * 12.92 : std::min(1.055 * raised(l, 1 / 2.4) - 0.055, 1.0);
}

namespace {

Texel with_colors(const Texel& texel, double (*function)(double)) {
  constexpr std::size_t kAlpha = 3;
  Texel result = texel;
  for (std::size_t k = 0; k < kAlpha; ++k)
    result[k] = {function(texel[k].low), function(texel[k].high)};
  return result;
}

}  // namespace

Texel srgb_coded(const Texel& linear) {
  return with_colors(linear, linear_to_srgb_number);
}

Texel srgb_decoded(const Texel& coded) {
  return with_colors(coded, srgb_to_linear_number);
}

DecodedTexture srgb_coded(const DecodedTexture& linear) {
  DecodedTexture coded = linear;
  for (DecodedLevel& level : coded.levels)
    for (Texel& texel : level.texels) texel = srgb_coded(texel);
  return coded;
}

Texel decode_border(const std::array<float, 4>& border, TextureFormat format) {
  Texel texel;
  for (std::size_t k = 0; k < texel.size(); ++k) {
    const float value = border[k];
    if (holds_floats(format))
      texel[k] = number_of(value);
    else
      texel[k] = value > 0 ? std::min(static_cast<double>(value), 1.0) : 0.0;
  }
  return texel;
}

DecodedLevel decode(const TextureLevel& level, TextureFormat format) {
  const Decoder number(format);
  DecodedLevel decoded{level.width, level.height, {}};
  decoded.texels.resize(level.texels.size() / 4);
  for (std::size_t i = 0; i < decoded.texels.size(); ++i)
    for (std::size_t k = 0; k < 4; ++k) decoded.texels[i][k] = number(level.texels[4 * i + k], k);
  return decoded;
}

DecodedTexture decode(const Texture& texture, const std::vector<TextureLevel>& levels) {
  DecodedTexture decoded{texture.dimensions, texture.format, {}};
  for (const TextureLevel& level : levels.empty() ? texture.levels : levels)
    decoded.levels.push_back(decode(level, texture.format));
  return decoded;
}

}  // namespace edgecase
