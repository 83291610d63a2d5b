// SPDX-License-Identifier: MIT
//
// Pixels computed in double precision, one per lane: storing their codes from vectors, and listing
// the pixels whose code is left open.
//
// This file is compiled once for each of Highway's targets.
#if defined(EDGECASE_KERNELS_CODE_WORDS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef EDGECASE_KERNELS_CODE_WORDS_INL_H_
#undef EDGECASE_KERNELS_CODE_WORDS_INL_H_
#else
#define EDGECASE_KERNELS_CODE_WORDS_INL_H_
#endif

#include <hwy/highway.h>

#include <bit>
#include <cstdint>
#include <vector>

#include "kernels/kernels.h"

HWY_BEFORE_NAMESPACE();
namespace edgecase {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Doubles = hn::ScalableTag<double>;
using Words = hn::Rebind<std::int32_t, Doubles>;
using DoubleVector = hn::Vec<Doubles>;
using WordVector = hn::Vec<Words>;
static_assert(std::endian::native == std::endian::little, "red is the lowest byte of a word");

// Stores the first `count` lanes, at least 1, or all lanes if there are fewer.
HWY_INLINE void StoreWords(WordVector word, PixelWord* at, int count) {
  const Words d;
  auto* const out = reinterpret_cast<std::int32_t*>(at);
  if (count >= static_cast<int>(hn::Lanes(d)))
    hn::StoreU(word, d, out);
  else
    hn::BlendedStore(word, hn::FirstN(d, static_cast<std::size_t>(count)), d, out);
}

// Adds the pixels whose lanes are `open`, starting at `first` and ending at column `last`.
HWY_INLINE void AddDoubtful(hn::Mask<Doubles> open, PixelPosition first, int last,
                            std::vector<PixelPosition>& doubtful) {
  const Doubles d;
  alignas(64) double flags[HWY_MAX_BYTES / sizeof(double)];
  hn::Store(hn::IfThenElseZero(open, hn::Set(d, 1.0)), d, flags);
  for (int i = 0; i < static_cast<int>(hn::Lanes(d)) && first.x + i <= last; ++i)
    if (flags[i] != 0) doubtful.push_back({first.x + i, first.y});
}

}  // namespace HWY_NAMESPACE
}  // namespace edgecase
HWY_AFTER_NAMESPACE();

#endif
