// SPDX-License-Identifier: MIT
//
// The choice of a centre: let x have f fraction bits, f > 0. With a size of at least 2 the centre c
// is whole, so x - c has f fraction bits too, and is a float32 number exactly if |x - c| <
// 2^(24-f). Each vertex thus confines the centre to an open interval, and the permitted centres are
// the intersection of all intervals, found in one pass. Size 1 means a target one pixel wide with
// all vertices inside: differences are below 1/2 and always exact.
//
// A coordinate that is itself a float32 number has |x| < 2^(24-f), so the centre 0 suits all of
// them: enlarging the viewport until its centre can be 0 always ends the search, unless a vertex
// lies at the very end of the range, 8192.
#include "casefile/scene/viewport.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <utility>

#include "casefile/json/numbers.h"
#include "exact/homogeneous.h"
#include "exact/numeral.h"

namespace edgecase {

namespace {

constexpr int kSignificantBits = 24;
constexpr int kNoBound = 1 << 30;  // pixels; beyond every centre that can occur

int trailing_zeros(std::int64_t n) {
  return std::countr_zero(static_cast<std::uint64_t>(n));
}

// Significant bits of n, from its highest set bit to its lowest.
int significant_bits(std::int64_t n) {
  if (n == 0) return 0;
  const auto magnitude = static_cast<std::uint64_t>(n < 0 ? -n : n);
  return static_cast<int>(std::bit_width(magnitude)) - std::countr_zero(magnitude);
}

// The vertices' conditions on one side of the viewport, in pixels, inclusive.
struct Demands {
  int left = 0;   // the side starts here or further left
  int right = 0;  // and ends here or further right
  int lowest_centre = -kNoBound;
  int highest_centre = kNoBound;
};

// The margin in pixels that a draw needs around its vertices, besides the pixel that keeps every
// vertex strictly inside.
int room_of(const Draw& draw) {
  const PrimitiveKind kind = kind_of(draw.primitive);
  if (kind == PrimitiveKind::triangle) return 0;
  const Fixed size = kind == PrimitiveKind::line ? draw.line_width : draw.point_size;
  if (size <= Fixed::from_integer(1)) return 0;
  return static_cast<int>((size.ceil() + 1) / 2);
}

// w without its factors of two: at most 2^24.
std::int64_t odd_part(float w) {
  int exponent = 0;
  const auto bits = static_cast<std::int64_t>(std::ldexp(std::frexp(w, &exponent), 24));
  return bits >> trailing_zeros(bits);
}

// For a vertex with w, (x - c) w must be a float32 number: |x - c| < 2^(24-f) over w's odd part.
void demand(Fixed x, std::int64_t odd, int room, Demands& demands) {
  demands.left = std::min(demands.left, static_cast<int>(x.ceil()) - 1 - room);
  demands.right = std::max(demands.right, static_cast<int>(x.floor()) + 1 + room);
  const int fraction_bits =
      Fixed::kFractionBits - std::min(Fixed::kFractionBits, trailing_zeros(x.raw()));
  if (fraction_bits == 0 && odd == 1) return;
  const std::int64_t reach_of_one = std::int64_t{1}
                                    << (kSignificantBits + Fixed::kFractionBits - fraction_bits);
  const Fixed reach = Fixed::from_raw((reach_of_one + odd - 1) / odd);
  demands.lowest_centre =
      std::max(demands.lowest_centre, static_cast<int>((x - reach).floor()) + 1);
  demands.highest_centre =
      std::min(demands.highest_centre, static_cast<int>((x + reach).ceil()) - 1);
}

std::optional<ViewportSide> choose_side(const Demands& demands) {
  std::optional<ViewportSide> fallback;
  for (int size = 1; size <= kMaxViewportSize; size *= 2) {
    const int lowest = demands.right - size;
    if (lowest > demands.left) continue;
    if (!fallback) fallback = ViewportSide{demands.left, size};
    const int half = size / 2;
    const int from = std::max(lowest, demands.lowest_centre - half);
    const int to = std::min(demands.left, demands.highest_centre - half);
    if (from <= to || size == 1) return ViewportSide{size == 1 ? demands.left : to, size};
  }
  return fallback;
}

// Whether a quotient's product with w is a float32 number; powers of two do not matter.
std::optional<Inexactness> find_product_inexactness(std::int64_t quotient, float w,
                                                    const std::string& shown) {
  // At most 24 + 24 bits.
  const std::int64_t short_quotient = quotient == 0 ? 0 : quotient >> trailing_zeros(quotient);
  const std::int64_t odd = odd_part(w);
  if (fits_float32(short_quotient * odd)) return std::nullopt;
  const int spare = std::max(1, kSignificantBits - significant_bits(short_quotient));
  return Inexactness{
      fmt::format("{} has no exact clip coordinate with w = {}: the product has {} significant "
                  "bits, and OpenGL's float32 holds {}",
                  shown, short_decimal(w), significant_bits(short_quotient * odd),
                  kSignificantBits),
      fmt::format("use a power of two as w, or one of {} significant bits at most ({} has {})",
                  spare, short_decimal(w), significant_bits(odd))};
}

Inexactness too_fine(std::string message) {
  return {std::move(message),
          "give the coordinate fewer fraction bits, or move it nearer to the target"};
}

}  // namespace

bool fits_float32(std::int64_t n) {
  return significant_bits(n) <= kSignificantBits;
}

Viewport clip_viewport(const Target& target) {
  const auto size = [](int pixels) {
    return static_cast<int>(std::bit_ceil(static_cast<unsigned>(pixels)));
  };
  return {0, 0, size(target.width), size(target.height)};
}

bool has_clip_vertices(const std::vector<Draw>& draws) {
  return std::any_of(draws.begin(), draws.end(), [](const Draw& draw) {
    return std::any_of(draw.vertices.begin(), draw.vertices.end(),
                       [](const Vertex& vertex) { return vertex.clip.has_value(); });
  });
}

Shifts shifts_of(const Supersampling& passes) {
  if (passes.empty()) return {{Fixed()}, {Fixed()}};
  Shifts shifts;
  for (const ShadingPass& pass : passes) {
    shifts.x.push_back(shift_of(pass).x);
    shifts.y.push_back(shift_of(pass).y);
  }
  for (std::vector<Fixed>* side : {&shifts.x, &shifts.y}) {
    std::ranges::sort(*side);
    side->erase(std::unique(side->begin(), side->end()), side->end());
  }
  return shifts;
}

std::optional<Viewport> choose_viewport(const Target& target, const std::vector<Draw>& draws,
                                        const Supersampling& passes) {
  if (has_clip_vertices(draws)) return clip_viewport(target);
  Demands across{0, target.width, -kNoBound, kNoBound};
  Demands up{0, target.height, -kNoBound, kNoBound};
  const Shifts shifts = shifts_of(passes);
  for (const Draw& draw : draws) {
    const int room = room_of(draw);
    for (const Vertex& vertex : draw.vertices) {
      const std::int64_t odd = odd_part(vertex.w);
      for (const Fixed shift : shifts.x) demand(vertex.position.x + shift, odd, room, across);
      for (const Fixed shift : shifts.y) demand(vertex.position.y + shift, odd, room, up);
    }
  }
  const std::optional<ViewportSide> columns = choose_side(across);
  const std::optional<ViewportSide> rows = choose_side(up);
  if (!columns || !rows) return std::nullopt;
  return Viewport{columns->origin, rows->origin, columns->size, rows->size};
}

std::optional<Inexactness> find_inexactness(Fixed coordinate, ViewportSide side, char axis,
                                            float w) {
  const Fixed low = Fixed::from_integer(side.origin);
  const Fixed high = low + Fixed::from_integer(side.size);
  const std::string shown = fmt::format("{} = {}", axis, to_decimal(coordinate));
  if (coordinate <= low || coordinate >= high)
    return Inexactness{fmt::format("{} does not lie strictly inside the viewport, which spans {} "
                                   "to {}",
                                   shown, to_decimal(low), to_decimal(high)),
                       "move the vertex, enlarge the viewport, or leave the viewport out"};
  if (!fits_float32(coordinate.raw()))
    return too_fine(fmt::format("{} has {} significant bits, and OpenGL's float32 holds {}", shown,
                                significant_bits(coordinate.raw()), kSignificantBits));
  // The centre is a multiple of 1/2, hence exact as Fixed, and far below 24 bits.
  const Fixed centre = Fixed::from_raw((low.raw() + high.raw()) / 2);
  const std::int64_t difference = (coordinate - centre).raw();
  if (!fits_float32(difference))
    return too_fine(fmt::format(
        "{} is {} from the viewport's centre, {} significant bits where "
        "OpenGL's float32 holds {}",
        shown, to_decimal(coordinate - centre), significant_bits(difference), kSignificantBits));
  // Clip coordinate: difference / (size / 2). Only an odd factor of the size can be inexact.
  const std::int64_t odd = side.size >> std::countr_zero(static_cast<unsigned>(side.size));
  if (difference % odd == 0 && fits_float32(difference / odd))
    return find_product_inexactness(difference / odd, w,
                                    shown + fmt::format(" in a viewport of {}", side.size));
  return Inexactness{fmt::format("{} has no exact clip coordinate in a viewport of size {}: {} / "
                                 "{} is no float32 number",
                                 shown, side.size, to_decimal(coordinate - centre),
                                 to_decimal(Fixed::from_raw((high - low).raw() / 2))),
                     "use a viewport whose sizes are powers of two, or leave the viewport out"};
}

std::optional<Inexactness> find_depth_inexactness(Fixed z, float w) {
  return find_product_inexactness(z.raw(), w, fmt::format("z = {}", to_decimal(z)));
}

namespace {

constexpr int kGridBits = 30;  // of each coordinate below the leading bit of the largest

float largest_of(const ClipPosition& clip) {
  return std::max({std::fabs(clip.x), std::fabs(clip.y), std::fabs(clip.z), std::fabs(clip.w)});
}

// The exponent of the grid's unit, 2^(e-30).
int grid_exponent(const ClipPosition& clip) {
  int exponent = 0;  // largest = m 2^exponent, 1/2 <= m < 1
  std::frexp(largest_of(clip), &exponent);
  return exponent - 1 - kGridBits;
}

// Values are at most the largest magnitude: 2^31 units. Float32 numbers above 2^24 units are whole
// already.
float rounded(float value, int exponent) {
  const double units = std::nearbyint(std::ldexp(static_cast<double>(value), -exponent));
  return static_cast<float>(std::ldexp(units, exponent)) + 0.0F;
}

}  // namespace

ClipPosition round_to_grid(const ClipPosition& clip) {
  const int exponent = grid_exponent(clip);
  return {rounded(clip.x, exponent), rounded(clip.y, exponent), rounded(clip.z, exponent),
          rounded(clip.w, exponent)};
}

std::string text_of(const ClipPosition& clip) {
  return fmt::format("({}, {}, {}, {})", short_decimal(clip.x), short_decimal(clip.y),
                     short_decimal(clip.z), short_decimal(clip.w));
}

std::optional<Inexactness> find_clip_fault(const ClipPosition& clip, const std::string& subject) {
  if (!std::isfinite(clip.w) || !std::isfinite(clip.x) || !std::isfinite(clip.y) ||
      !std::isfinite(clip.z))
    return Inexactness{
        fmt::format("{} has clip coordinates beyond float32, {}", subject, text_of(clip)),
        "use smaller numbers"};
  const float largest = largest_of(clip);
  if (largest >= kMinW && largest <= kMaxW) return std::nullopt;
  return Inexactness{
      fmt::format("{} has clip coordinates {}, out of range", subject, text_of(clip)),
      fmt::format("keep the largest of |x|, |y|, |z| and |w| from {} to {}", exact_decimal(kMinW),
                  exact_decimal(kMaxW))};
}

std::optional<Inexactness> find_volume_fault(const ClipPosition& clip, const std::string& subject) {
  if (!(clip.w > 0))
    return Inexactness{
        fmt::format("{} lies at or behind the eye: its w is {}", subject, short_decimal(clip.w)),
        "move it in front of the eye, where w is above 0"};
  const std::pair<char, float> axes[] = {{'x', clip.x}, {'y', clip.y}, {'z', clip.z}};
  for (const auto& [axis, value] : axes)
    if (std::fabs(value) > clip.w)
      return Inexactness{
          fmt::format("{} lies outside the clip volume: its clip coordinates are {}, and {} is not "
                      "within -w and w",
                      subject, text_of(clip), axis),
          axis == 'z' ? "move it between the near and the far plane" : "move it into the view"};
  return std::nullopt;
}

// A coordinate is at most 2^31 units, doubled. Its window coordinate, times w, is at most 2^31
// times the sum below (model/scene.h's window_position), and must be at most 2^46.
bool fits_clipping(const Viewport& viewport) {
  constexpr int kMostUnits = 1 << 15;
  return viewport.width + std::abs(2 * viewport.x + viewport.width) <= kMostUnits &&
         viewport.height + std::abs(2 * viewport.y + viewport.height) <= kMostUnits;
}

void place_clip_vertex(const Viewport& viewport, Vertex& vertex) {
  const ClipPosition& clip = *vertex.clip;
  vertex.w = clip.w;
  vertex.position = {};
  vertex.z = {};
  if (!is_in_clip_volume(clip)) return;
  vertex.position = nearest_point(window_position(clip, viewport));
  const int exponent = grid_exponent(clip);
  const auto units = [&](float value) {
    return static_cast<std::int64_t>(std::ldexp(static_cast<double>(value), -exponent));
  };
  vertex.z = nearest_point({units(clip.z), 0, units(clip.w)}).x;
}

}  // namespace edgecase
