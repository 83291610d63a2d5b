// SPDX-License-Identifier: MIT
#include "wire/fragments.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "model/rendering.h"
#include "wire/binary.h"

namespace edgecase::wire {

namespace {

// Flags for the values that a fragment has, beside its position.
enum Flag : std::uint32_t { kDepth = 1, kColor = 2, kDetail = 4 };

// A run as sent: fragments of one primitive at neighbouring pixels of a row that have the same
// values; a fragment with a detail is a run of its own. All have the same size, so that many are
// copied at once.
template <class Number>
struct SentRun {
  Number depth = 0;
  std::array<Number, 4> color{};
  std::int32_t x = 0;  // of the first pixel
  std::int32_t y = 0;
  std::int32_t primitive = 0;
  std::uint32_t coverage = 0;
  std::uint32_t flags = 0;
  std::uint32_t length = 1;
};
static_assert(sizeof(SentRun<float>) == 44 && sizeof(SentRun<double>) == 64);

bool fits_float(double value) {
  if (!std::isfinite(value)) return true;
  return std::fabs(value) <= static_cast<double>(std::numeric_limits<float>::max()) &&
         static_cast<double>(static_cast<float>(value)) == value;
}

bool fit_floats(const Fragment& fragment) {
  return fits_float(fragment.depth) && std::ranges::all_of(fragment.color, fits_float);
}

std::uint32_t flags_of(const Rendering& rendering, const Fragment& fragment) {
  const bool has_detail = fragment.detail >= 0 &&
                          has_values(rendering.details[static_cast<std::size_t>(fragment.detail)]);
  return (fragment.has_depth ? kDepth : 0u) | (fragment.has_color ? kColor : 0u) |
         (has_detail ? kDetail : 0u);
}

bool is_next_of_run(const Fragment& before, const Fragment& fragment) {
  return fragment.x - std::int64_t{1} == before.x && fragment.y == before.y &&
         fragment.primitive == before.primitive && fragment.coverage == before.coverage &&
         have_equal_values(before, fragment);
}

// A run that starts at fragment `first`, and the flags of its values.
struct Run {
  std::size_t first = 0;
  std::uint32_t flags = 0;
  std::uint32_t length = 1;
};

std::vector<Run> runs_of(const Rendering& rendering) {
  const std::vector<Fragment>& fragments = rendering.fragments;
  std::vector<Run> runs;
  for (std::size_t i = 0; i < fragments.size(); ++i) {
    const std::uint32_t flags = flags_of(rendering, fragments[i]);
    if (i > 0 && flags == runs.back().flags && (flags & kDetail) == 0 &&
        is_next_of_run(fragments[i - 1], fragments[i]))
      ++runs.back().length;
    else
      runs.push_back({i, flags, 1});
  }
  return runs;
}

template <class Number>
SentRun<Number> sent(const Run& run, const Fragment& fragment) {
  SentRun<Number> result;
  result.depth = static_cast<Number>(fragment.depth);
  for (std::size_t i = 0; i < result.color.size(); ++i)
    result.color[i] = static_cast<Number>(fragment.color[i]);
  result.x = fragment.x;
  result.y = fragment.y;
  result.primitive = fragment.primitive;
  result.coverage = fragment.coverage;
  result.flags = run.flags;
  result.length = run.length;
  return result;
}

// Each member is written in its final place. Copying a freshly assembled fragment is several times
// slower: the processor cannot load at once what it has yet to store in pieces.
template <class Number>
void receive(const SentRun<Number>& sent, std::span<Fragment> fragments) {
  const bool has_depth = (sent.flags & kDepth) != 0;
  const bool has_color = (sent.flags & kColor) != 0;
  const double depth = has_depth ? static_cast<double>(sent.depth) + 0.0 : 0;
  std::array<double, 4> color{};
  for (std::size_t i = 0; i < color.size() && has_color; ++i)
    color[i] = static_cast<double>(sent.color[i]) + 0.0;
  int x = sent.x;
  for (Fragment& fragment : fragments) {
    fragment.x = x++;
    fragment.y = sent.y;
    fragment.primitive = sent.primitive;
    fragment.coverage = sent.coverage;
    fragment.depth = depth;
    for (std::size_t i = 0; i < color.size(); ++i) fragment.color[i] = color[i];
    fragment.has_depth = has_depth;
    fragment.has_color = has_color;
  }
}

template <class Number>
void write_as(Writer& io, const Rendering& rendering, const std::vector<Run>& runs) {
  std::vector<SentRun<Number>> sent_runs;
  sent_runs.reserve(runs.size());
  for (const Run& run : runs)
    sent_runs.push_back(sent<Number>(run, rendering.fragments[run.first]));
  io.size(sent_runs.size());
  io.bytes(sent_runs.data(), sent_runs.size() * sizeof(SentRun<Number>));
}

// Checks a whole run for all conditions on fragments, except for details.
template <class Number>
void check_run(const SentRun<Number>& run, const Rendering& rendering, std::size_t primitives) {
  if (run.length == 0 || ((run.flags & kDetail) != 0 && run.length > 1))
    throw Refusal(fmt::format("a run has {} fragments", run.length));
  const bool is_inside = run.x >= 0 && run.x < rendering.width && run.y >= 0 &&
                         run.y < rendering.height &&
                         run.length <= static_cast<std::uint32_t>(rendering.width - run.x);
  if (!is_inside)
    throw Refusal(fmt::format("a fragment is at pixel ({}, {}), outside the target",
                              run.x + std::int64_t{run.length} - 1, run.y));
  if (run.primitive < 0 || static_cast<std::size_t>(run.primitive) >= primitives)
    throw Refusal(
        fmt::format("a fragment is of primitive {}, and there are {}", run.primitive, primitives));
  if (run.coverage < 1 || run.coverage >= std::uint64_t{1} << rendering.samples)
    throw Refusal(fmt::format("a fragment has the coverage {}, which is none of {} samples",
                              run.coverage, rendering.samples));
}

// The number of fragments in the next runs. It may be many times the number of their bytes, so all
// runs are checked before any memory is reserved.
template <class Number>
std::size_t count_fragments(Reader io, std::size_t runs, const Rendering& rendering,
                            std::size_t primitives) {
  std::size_t count = 0;
  for (; runs > 0; --runs) {
    SentRun<Number> run;
    io.bytes(&run, sizeof(run));
    check_run(run, rendering, primitives);
    count += run.length;
    if (count > kMostFragments)
      throw Refusal(fmt::format("there are more than {} fragments", kMostFragments));
  }
  return count;
}

// Returns how many of them have a detail, which is yet to be read.
template <class Number>
int read_as(Reader& io, std::size_t primitives, Rendering& rendering) {
  std::vector<Fragment>& fragments = rendering.fragments;
  const std::size_t runs = io.size(sizeof(SentRun<Number>));
  fragments.reserve(count_fragments<Number>(io, runs, rendering, primitives));
  int details = 0;
  for (std::size_t i = 0; i < runs; ++i) {
    SentRun<Number> run;
    io.bytes(&run, sizeof(run));
    fragments.resize(fragments.size() + run.length);
    receive(run, std::span(fragments).last(run.length));
    if ((run.flags & kDetail) != 0) fragments.back().detail = details++;
  }
  return details;
}

template <class Numbers>
void drop_signs(std::optional<Numbers>& numbers) {
  if (numbers) drop_signs_of_zero(*numbers);
}
void drop_signs(DerivativeValues& derivatives) {
  if (!derivatives.has_any()) return;
  for (std::size_t i = 0; i < kDerivatives; ++i) drop_signs(derivatives[i]);
}

}  // namespace

void write_fragments(Writer& io, const Rendering& rendering) {
  const std::vector<Run> runs = runs_of(rendering);
  const bool narrow = std::ranges::all_of(
      runs, [&](const Run& run) { return fit_floats(rendering.fragments[run.first]); });
  carry(io, narrow);
  if (narrow)
    write_as<float>(io, rendering, runs);
  else
    write_as<double>(io, rendering, runs);
  for (const Run& run : runs)
    if ((run.flags & kDetail) != 0)
      carry(io, rendering.details[static_cast<std::size_t>(rendering.fragments[run.first].detail)]);
}

void read_fragments(Reader& io, const Scene& scene, Rendering& rendering) {
  const std::vector<bool> textured = textured_primitives(scene);
  bool narrow = false;
  carry(io, narrow);
  const int details = narrow ? read_as<float>(io, textured.size(), rendering)
                             : read_as<double>(io, textured.size(), rendering);
  if (details == 0) return;
  rendering.details.reserve(static_cast<std::size_t>(details));
  for (const Fragment& fragment : rendering.fragments) {
    if (fragment.detail < 0) continue;
    FragmentDetail& detail = rendering.details.emplace_back();
    carry(io, detail);
    check_detail(detail, scene.details, textured[static_cast<std::size_t>(fragment.primitive)]);
    for_each_field<FragmentDetail>([&](const auto& field) { drop_signs(detail.*field.member); });
  }
}

namespace {

// The number of fragments at each sample; nothing if a fragment lies outside the target.
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
