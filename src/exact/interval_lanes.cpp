// SPDX-License-Identifier: MIT
#include "exact/interval_lanes.h"

#include <cstdint>
#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "exact/interval_lanes.cpp"
#include <hwy/foreach_target.h>
// Highway requires its header after the list of targets.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace edgecase {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

// At most 16 lanes: a target's vectors may be longer.
using Doubles = hn::CappedTag<double, 16>;
using Integers = hn::RebindToSigned<Doubles>;
using Vector = hn::Vec<Doubles>;

struct Ends {
  Vector low, high;
};

// Of a number: the next double above. See next_above in exact/interval.h.
HWY_INLINE Vector NextAbove(Vector value) {
  const Doubles d;
  const Integers di;
  const auto bits = hn::BitCast(di, hn::Add(value, hn::Zero(d)));
  const auto step = hn::Or(hn::BroadcastSignBit(bits), hn::Set(di, 1));
  const Vector infinity = hn::Set(d, std::numeric_limits<double>::infinity());
  return hn::IfThenElse(hn::Eq(value, infinity), value, hn::BitCast(d, hn::Add(bits, step)));
}

HWY_INLINE Ends Everything() {
  const Vector infinity = hn::Set(Doubles(), std::numeric_limits<double>::infinity());
  return {hn::Neg(infinity), infinity};
}

HWY_INLINE Ends Where(hn::Mask<Doubles> mask, Ends yes, Ends no) {
  return {hn::IfThenElse(mask, yes.low, no.low), hn::IfThenElse(mask, yes.high, no.high)};
}

HWY_INLINE Ends Outward(Vector low, Vector high) {
  const auto unknown = hn::Or(hn::IsNaN(low), hn::IsNaN(high));
  return Where(unknown, Everything(), {hn::Neg(NextAbove(hn::Neg(low))), NextAbove(high)});
}

HWY_INLINE Ends Outward(Vector a, Vector b, Vector c, Vector d) {
  const auto unknown =
      hn::Or(hn::Or(hn::IsNaN(a), hn::IsNaN(b)), hn::Or(hn::IsNaN(c), hn::IsNaN(d)));
  const Vector low = hn::Min(hn::Min(a, b), hn::Min(c, d));
  const Vector high = hn::Max(hn::Max(a, b), hn::Max(c, d));
  return Where(unknown, Everything(), {hn::Neg(NextAbove(hn::Neg(low))), NextAbove(high)});
}

template <LaneOperation kOperation>
HWY_INLINE Ends Result(Ends a, Ends b) {
  if constexpr (kOperation == LaneOperation::add)
    return Outward(hn::Add(a.low, b.low), hn::Add(a.high, b.high));
  if constexpr (kOperation == LaneOperation::subtract)
    return Outward(hn::Sub(a.low, b.high), hn::Sub(a.high, b.low));
  if constexpr (kOperation == LaneOperation::multiply)
    return Outward(hn::Mul(a.low, b.low), hn::Mul(a.low, b.high), hn::Mul(a.high, b.low),
                   hn::Mul(a.high, b.high));
  if constexpr (kOperation == LaneOperation::divide) {
    const Vector zero = hn::Zero(Doubles());
    const auto has_zero = hn::And(hn::Le(b.low, zero), hn::Ge(b.high, zero));
    return Where(has_zero, Everything(),
                 Outward(hn::Div(a.low, b.low), hn::Div(a.low, b.high), hn::Div(a.high, b.low),
                         hn::Div(a.high, b.high)));
  }
}

HWY_INLINE Ends Widened(Ends value, Vector relative) {
  const Vector magnitude = hn::Max(hn::Abs(value.low), hn::Abs(value.high));
  const Vector margin = NextAbove(hn::Mul(magnitude, relative));
  return Outward(hn::Sub(value.low, margin), hn::Add(value.high, margin));
}

template <LaneOperation kOperation>
void Compute(const LaneOperands& of) {
  const Doubles d;
  const Vector relative = hn::Set(d, of.relative);
  const Ends one = {hn::Set(d, of.b_low[0]), hn::Set(d, of.b_high[0])};
  for (std::size_t i = 0; i < of.count; i += hn::Lanes(d)) {
    const Ends a = {hn::LoadU(d, of.a_low + i), hn::LoadU(d, of.a_high + i)};
    const Ends b =
        of.b_is_one ? one : Ends{hn::LoadU(d, of.b_low + i), hn::LoadU(d, of.b_high + i)};
    Ends result = Result<kOperation>(a, b);
    if (of.relative >= 0) result = Widened(result, relative);
    hn::StoreU(result.low, d, of.low + i);
    hn::StoreU(result.high, d, of.high + i);
  }
}

void ComputeLanes(LaneOperation operation, const LaneOperands& of) {
  switch (operation) {
    case LaneOperation::add:
      return Compute<LaneOperation::add>(of);
    case LaneOperation::subtract:
      return Compute<LaneOperation::subtract>(of);
    case LaneOperation::multiply:
      return Compute<LaneOperation::multiply>(of);
    case LaneOperation::divide:
      return Compute<LaneOperation::divide>(of);
  }
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace edgecase
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace edgecase {

HWY_EXPORT(ComputeLanes);

void compute_lanes(LaneOperation operation, const LaneOperands& of) {
  HWY_DYNAMIC_DISPATCH(ComputeLanes)(operation, of);
}

}  // namespace edgecase
#endif
