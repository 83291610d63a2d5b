// SPDX-License-Identifier: MIT
#include "wire/sent_fragments.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <type_traits>
#include <vector>

#include "wire/answer_checks.h"
#include "wire/binary_values.h"

namespace edgecase::wire {
namespace {

// What is told of a fragment, beside where it is.
enum Told : std::uint32_t { kDepth = 1, kColor = 2, kDetail = 4 };

// A fragment as it is sent, without its detail: as many bytes as any other, so that many go at
// once.
template <class Number>
struct SentFragment {
  Number depth = 0;
  std::array<Number, 4> color{};
  std::int32_t x = 0;
  std::int32_t y = 0;
  std::int32_t primitive = 0;
  std::uint32_t coverage = 0;
  // As wide as the numbers, so that no bytes between members are sent unset.
  std::conditional_t<sizeof(Number) == 8, std::uint64_t, std::uint32_t> told = 0;
};
static_assert(sizeof(SentFragment<float>) == 40 && sizeof(SentFragment<double>) == 64);

bool fits_float(double value) {
  if (!std::isfinite(value)) return true;
  return std::fabs(value) <= static_cast<double>(std::numeric_limits<float>::max()) &&
         static_cast<double>(static_cast<float>(value)) == value;
}

bool fit_floats(const std::vector<Fragment>& fragments) {
  return std::ranges::all_of(fragments, [](const Fragment& fragment) {
    return fits_float(fragment.depth) && std::ranges::all_of(fragment.color, fits_float);
  });
}

bool has_detail(const Rendering& rendering, const Fragment& fragment) {
  return fragment.detail >= 0 &&
         tells_something(rendering.details[static_cast<std::size_t>(fragment.detail)]);
}

template <class Number>
SentFragment<Number> sent(const Rendering& rendering, const Fragment& fragment) {
  SentFragment<Number> result;
  result.depth = static_cast<Number>(fragment.depth);
  for (std::size_t i = 0; i < result.color.size(); ++i)
    result.color[i] = static_cast<Number>(fragment.color[i]);
  result.x = fragment.x;
  result.y = fragment.y;
  result.primitive = fragment.primitive;
  result.coverage = fragment.coverage;
  result.told = (fragment.has_depth ? kDepth : 0u) | (fragment.has_color ? kColor : 0u) |
                (has_detail(rendering, fragment) ? kDetail : 0u);
  return result;
}

template <class Number>
Fragment received(const SentFragment<Number>& sent) {
  Fragment fragment;
  fragment.x = sent.x;
  fragment.y = sent.y;
  fragment.primitive = sent.primitive;
  fragment.coverage = sent.coverage;
  fragment.has_depth = (sent.told & kDepth) != 0;
  fragment.has_color = (sent.told & kColor) != 0;
  if (fragment.has_depth) fragment.depth = static_cast<double>(sent.depth) + 0.0;
  if (fragment.has_color)
    for (std::size_t i = 0; i < sent.color.size(); ++i)
      fragment.color[i] = static_cast<double>(sent.color[i]) + 0.0;
  return fragment;
}

template <class Number>
void write_as(Writer& io, const Rendering& rendering) {
  std::vector<SentFragment<Number>> fragments;
  fragments.reserve(rendering.fragments.size());
  for (const Fragment& fragment : rendering.fragments)
    fragments.push_back(sent<Number>(rendering, fragment));
  io.size(fragments.size());
  io.bytes(fragments.data(), fragments.size() * sizeof(SentFragment<Number>));
}

// How many of them have a detail, which is yet to be read.
template <class Number>
int read_as(Reader& io, Rendering& rendering) {
  const std::size_t count = io.size(sizeof(SentFragment<Number>));
  rendering.fragments.reserve(count);
  int details = 0;
  for (std::size_t i = 0; i < count; ++i) {
    SentFragment<Number> sent;
    io.bytes(&sent, sizeof(sent));
    rendering.fragments.push_back(received(sent));
    if ((sent.told & kDetail) != 0) rendering.fragments.back().detail = details++;
  }
  return details;
}

void drop_signs_of_zero(FragmentDetail& detail) {
  wire::drop_signs_of_zero(detail.coordinates);
  for (auto& derivative : detail.derivatives) wire::drop_signs_of_zero(derivative);
  wire::drop_signs_of_zero(detail.texture_coordinates);
  wire::drop_signs_of_zero(detail.level_of_detail);
}

// How many fragments each sample has; nothing where one lies outside.
std::optional<std::vector<std::uint32_t>> counted(const Rendering& rendering) {
  const std::size_t plane = rendering.pixel_index(0, rendering.height);
  std::vector<std::uint32_t> counts(plane * static_cast<std::size_t>(rendering.samples));
  for (const Fragment& fragment : rendering.fragments) {
    if (fragment.x < 0 || fragment.x >= rendering.width || fragment.y < 0 ||
        fragment.y >= rendering.height)
      return std::nullopt;
    std::size_t at = rendering.pixel_index(fragment.x, fragment.y);
    for (std::uint32_t left = fragment.coverage; left != 0; left >>= 1, at += plane) {
      if (at >= counts.size()) return std::nullopt;
      counts[at] += left & 1;
    }
  }
  return counts;
}

}  // namespace

void write_fragments(Writer& io, const Rendering& rendering) {
  const bool narrow = fit_floats(rendering.fragments);
  carry(io, narrow);
  if (narrow)
    write_as<float>(io, rendering);
  else
    write_as<double>(io, rendering);
  for (const Fragment& fragment : rendering.fragments)
    if (has_detail(rendering, fragment))
      carry(io, rendering.details[static_cast<std::size_t>(fragment.detail)]);
}

void read_fragments(Reader& io, Rendering& rendering) {
  bool narrow = false;
  carry(io, narrow);
  int details = narrow ? read_as<float>(io, rendering) : read_as<double>(io, rendering);
  rendering.details.reserve(static_cast<std::size_t>(details));
  for (; details > 0; --details) {
    carry(io, rendering.details.emplace_back());
    drop_signs_of_zero(rendering.details.back());
  }
}

void write_hits(Writer& io, const Rendering& rendering) {
  const auto counts = counted(rendering);
  const bool count_fragments = counts && rendering.hits == *counts;
  carry(io, count_fragments);
  if (!count_fragments) carry(io, rendering.hits);
}

void read_hits(Reader& io, Rendering& rendering) {
  bool count_fragments = false;
  carry(io, count_fragments);
  if (!count_fragments) return carry(io, rendering.hits);
  auto counts = counted(rendering);
  if (!counts) throw Refusal("a fragment is outside the target");
  rendering.hits = *std::move(counts);
}

}  // namespace edgecase::wire
