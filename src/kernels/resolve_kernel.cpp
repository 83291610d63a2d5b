// SPDX-License-Identifier: MIT
//
// resolve_four: the mean of four bytes, rounded to nearest, ties to even.
//
// With quotient q and remainder r of the sum by 4, (sum + 1 + (q & 1)) >> 2 is q for r = 0 and 1, q
// + 1 for r = 3, and q + (q & 1) for r = 2.
#include "kernels/kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/resolve_kernel.cpp"
#include <hwy/foreach_target.h>
// Highway requires its header after the list of targets.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace edgecase {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

void ResolveFour(const std::array<const std::uint8_t*, 4>& samples, std::uint8_t* out,
                 std::size_t bytes) {
  const hn::ScalableTag<std::int16_t> d;
  const hn::Rebind<std::uint8_t, decltype(d)> d_bytes;
  const std::size_t lanes = hn::Lanes(d);
  const auto one = hn::Set(d, 1);
  for (std::size_t i = 0; i < bytes; i += lanes) {
    auto sum = hn::PromoteTo(d, hn::LoadU(d_bytes, samples[0] + i));
    for (std::size_t s = 1; s < 4; ++s)
      sum = hn::Add(sum, hn::PromoteTo(d, hn::LoadU(d_bytes, samples[s] + i)));
    const auto is_odd = hn::And(hn::ShiftRight<2>(sum), one);
    const auto mean = hn::ShiftRight<2>(hn::Add(sum, hn::Add(one, is_odd)));
    hn::StoreU(hn::DemoteTo(d_bytes, mean), d_bytes, out + i);
  }
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace edgecase
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace edgecase {

HWY_EXPORT(ResolveFour);

void resolve_four(std::span<const PixelPlane, 4> samples, const PixelPlane& resolved,
                  std::size_t pixels) {
  std::array<const std::uint8_t*, 4> bytes{};
  for (std::size_t s = 0; s < 4; ++s)
    bytes[s] = reinterpret_cast<const std::uint8_t*>(samples[s].pixels);
  HWY_DYNAMIC_DISPATCH(ResolveFour)
  (bytes, reinterpret_cast<std::uint8_t*>(resolved.pixels), pixels * sizeof(PixelWord));
}

}  // namespace edgecase
#endif
