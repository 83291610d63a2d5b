// SPDX-License-Identifier: MIT
#include "rules/values/framebuffer.h"

#include <algorithm>
#include <cmath>

namespace edgecase {

Unorm8Range unorm8_permitted(Interval value) {
  const double low = std::clamp(value.low, 0.0, 1.0) * 255;
  const double high = std::clamp(value.high, 0.0, 1.0) * 255;
  return {static_cast<int>(std::floor(low)), static_cast<int>(std::ceil(high))};
}

Rule unorm8_rule() {
  return {RuleId::framebuffer_unorm8,
          "A colour is stored as the nearest 8-bit value",
          "2.3.5.2 (conversion from floating-point to normalized fixed-point)",
          "either of the two nearest values; the nearest is preferred",
          "",
          {},
          {{10,
            "Pixels of an 8-bit target: either integer next to 255 times the clamped colour of "
            "the last fragment, as the renderer itself reports it, or of any colour that ruling "
            "9 permits if it reports none. The alpha of a multisampled point smaller than 1 may "
            "first be multiplied by the square of its size (17.2). A pixel without fragments "
            "holds the clear colour, likewise rounded. Dithering is always disabled, so the choice "
            "between two integers does not depend on the pixel (17.3.8): where one draw gives "
            "pixels of a target of one sample one and the same flat colour, and where they hold "
            "the clear colour, all have one code of each component."}}};
}

Rule order_rule() {
  return {RuleId::framebuffer_order,
          "Primitives take effect in the order in which they are drawn",
          "2.1 (execution model)",
          "none",
          "",
          {},
          {{11,
            "Without blending and depth test the last primitive drawn determines a pixel. The "
            "colour of an earlier one there is a violation."}}};
}

namespace {

double largest_of(DepthFormat format) {
  return std::ldexp(1.0, bits_of(format)) - 1;
}

// depth * largest, and how much the rounded product is too small.
struct Steps {
  double product;
  double rest;
};

Steps steps_of(double depth, double largest) {
  const double product = depth * largest;
  return {product, std::fma(depth, largest, -product)};
}

double below(Steps steps) {
  const double step = std::floor(steps.product);
  return step == steps.product && steps.rest < 0 ? step - 1 : step;
}

double above(Steps steps) {
  const double step = std::ceil(steps.product);
  return step == steps.product && steps.rest > 0 ? step + 1 : step;
}

double nearest(Steps steps) {
  const bool is_half = steps.product - std::floor(steps.product) == 0.5;
  if (is_half && steps.rest != 0) return steps.rest > 0 ? above(steps) : below(steps);
  return std::nearbyint(steps.product);
}

}  // namespace

int bits_of(DepthFormat format) {
  switch (format) {
    case DepthFormat::depth16:
      return 16;
    case DepthFormat::depth24:
      return 24;
    case DepthFormat::none:
    case DepthFormat::depth32f:
      return 0;
  }
  return 0;
}

double to_depth(double depth, DepthFormat format, DepthBits bits) {
  if (std::isnan(depth)) return 0;
  const double clamped = std::clamp(depth, 0.0, 1.0);
  if (bits_of(format) == 0) return to_float(clamped);
  const bool has_24 = bits_of(format) == 24;
  const double largest = bits == DepthBits::fewer     ? std::ldexp(1.0, has_24 ? 22 : 15) - 1
                         : bits == DepthBits::sixteen ? largest_of(DepthFormat::depth16)
                                                      : largest_of(format);
  const double step = bits != DepthBits::lowest_lost ? 1 : has_24 ? 4 : 2;  // between integers
  return std::min(nearest(steps_of(clamped, largest / step)) * step, largest) / largest;
}

bool is_depth_of(double stored, DepthFormat format) {
  return bits_of(format) == 0 ? stored == to_float(stored) : stored == to_depth(stored, format);
}

Interval depth_permitted(Interval depth, DepthFormat format) {
  if (bits_of(format) == 0)
    return {std::min(to_float(depth.low), to_depth(depth.low, format)),
            std::max(to_float(depth.high), to_depth(depth.high, format))};
  const double low = std::clamp(depth.low, 0.0, 1.0);
  const double high = std::clamp(depth.high, 0.0, 1.0);
  const double largest = largest_of(format);
  return {below(steps_of(low, largest)) / largest, above(steps_of(high, largest)) / largest};
}

bool is_within_one_code(double stored, Interval permitted, DepthFormat format) {
  if (bits_of(format) == 0 || !is_depth_of(stored, format)) return false;
  const double largest = largest_of(format);
  const double code = std::nearbyint(stored * largest);
  return code >= std::nearbyint(permitted.low * largest) - 1 &&
         code <= std::nearbyint(permitted.high * largest) + 1;
}

Rule depth_bits_rule() {
  return {RuleId::framebuffer_depth_bits,
          "A depth buffer keeps the bits of its format",
          "2.3.5.2, with 8.5.1 (required texture formats)",
          "none",
          "as-set",
          alternatives_of<DepthBits>(),
          {}};
}

Rule depth_buffer_rule() {
  return {
      RuleId::framebuffer_depth,
      "A depth is stored as the nearest value of the depth buffer's format",
      "2.3.5.2 (conversion from floating-point to normalized fixed-point)",
      "either of the two nearest integers, of which the nearest is preferred; for float32, a depth "
      "without polygon offset may be clamped or not",
      "",
      {},
      {{18,
        "Depth buffers of 16 and 24 bits: either integer next to 2^bits - 1 times the depth of "
        "the last fragment, as the renderer itself reports it, or of any depth that ruling 9 "
        "permits if it reports none. Of 32 float bits: that depth. Depths are clamped to 0 to 1 "
        "first, also where the buffer is of floats (14.6.5, 15.2.3); a float32 depth beyond 0 to "
        "1 to which no polygon offset was added may be kept. A pixel without fragments holds the "
        "clear value."},
       {59,
        "Contested: a stored depth of 16 or 24 bits is one code beyond either integer next to "
        "2^bits - 1 times the fragment's depth: the one that the renderer reports, or any that "
        "ruling 9 permits if it reports none. 2.3.5.2 stores one of these two integers. But a "
        "fixed-point depth reaches gl_FragCoord.z by a conversion of which 15.2.2, and OpenGL ES "
        "3.2 in 14.2.2, ask no more than that 0 and 1 stay: the reported depth may be a code off "
        "what was converted. No Khronos test asks the last bit of a stored depth."}}};
}

}  // namespace edgecase
