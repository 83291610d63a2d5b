// SPDX-License-Identifier: MIT
//
// The fragments of an answer as bytes and as JSON, and the checks of both. For src/wire only.
#pragma once

#include <cstddef>
#include <exception>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "model/rendering.h"
#include "model/scene.h"
#include "wire/binary.h"
#include "wire/json_values.h"
#include "wire/request_line.h"

namespace edgecase::wire {

// Coverage only, the short form of an answer: an array of integers, four for each run of pixels in
// a row, [primitive, y, x_first, x_last, ...], ends inclusive, y up. A pixel in two runs of a
// primitive was drawn twice.

// The largest number of fragments in runs, of which few bytes could demand much memory. Our own
// OpenGL workers capture at most this many.
constexpr std::size_t kMostFragments = std::size_t{1} << 24;

// The largest number of fragments that a primitive may have at a sample. A faulty rasterizer draws
// some twice; what goes far beyond is no rendering.
constexpr std::size_t kMostOfPrimitive = 4;

// The limits of runs: the target in pixels, and the number of primitives in the scene.
struct RunBounds {
  int width;
  int height;
  int primitives;
};

// The array, by primitive, then row, then column; equal fragments give equal arrays. Also as text.
std::vector<int> coverage_runs(const Rendering& rendering);
std::string coverage_runs_json(const Rendering& rendering);

// The pixels of an array of runs as fragments without depth and colour, in order of the runs.
// Throws a Refusal for an invalid array and for more than kMostFragments.
std::vector<Fragment> read_coverage_runs(const nlohmann::json& value, const Path& path,
                                         const RunBounds& bounds);

// The same for numbers from another source than JSON.
std::vector<Fragment> fragments_of_runs(const std::vector<int>& numbers, const RunBounds& bounds);

// The fragments of an answer. Readers throw a Refusal.

// For each primitive, whether its draw has a texture.
std::vector<bool> textured_primitives(const Scene& scene);

// Reads an array of fragments and their details, and appends them to a rendering with known sizes.
// `textured` is the result of textured_primitives; a scene without primitives has no fragments.
void read_fragments(const nlohmann::json& value, const Path& path, const Scene& scene,
                    const std::vector<bool>& textured, Rendering& rendering);

// Fragments and hits as few bytes (wire/binary.h), the bulk of a rendering.
//
// Neighbouring pixels with equal values, as of a primitive of one colour, are sent as a run. A GL's
// values are float32 and are sent as such; if one of them is not, all are sent as doubles.

// Writes all fragments, then their details. A detail without any value is not sent.
void write_fragments(Writer& io, const Rendering& rendering);

// The inverse, into a rendering of known size and samples. -0 becomes 0, because the lines of
// recordings have no sign of zero and recorded values must equal the observed ones. Throws a
// Refusal for fragments that lie outside the target, belong to no primitive of the scene, cover
// none of its samples or have a detail that was not requested, and for more than kMostFragments.
void read_fragments(Reader& io, const Scene& scene, Rendering& rendering);

// Replaces -0 by 0.
template <class Numbers>
void drop_signs_of_zero(Numbers& numbers) {
  for (double& number : numbers) number += 0.0;
}

// Hits that equal the number of fragments, as they do unless a test discards some, are not sent but
// counted again.
void write_hits(Writer& io, const Rendering& rendering);

// Reads into a rendering that has its fragments; throws a Refusal if those lie outside the target.
void read_hits(Reader& io, Rendering& rendering);

}  // namespace edgecase::wire

namespace edgecase {

// What every answer passes before it is compared, whether it came as a line, as bytes or from a
// recording: comparisons index by what it says, and trust that. Readers check earlier what they
// need for reading, and name the place. They throw a Refusal.

// Whether a fragment's detail has any value.
bool has_values(const FragmentDetail& detail);

// Refuses a detail that was not requested, or that only textured draws have.
void check_detail(const FragmentDetail& detail, Details asked, bool is_textured);

// Checks that a rendering of known size and samples may be one of the scene, with each pass of a
// supersampled one: sizes of planes, ranges of numbers, places, primitives, samples and details of
// fragments, and hit counts, which may not contradict the fragments.
void check_rendering(const Rendering& rendering, const Scene& scene);

// The same of an answer with coverage only: its fragments and hits.
void check_coverage(const Rendering& rendering, const Scene& scene);

// Checks what a renderer claims of itself.
constexpr int kMaxSubpixelBits = 32;
void check_claims(const RendererInfo& claims);

// Why an answer is refused if this was thrown while it was read: the Refusal's reason, too little
// memory, or a fault of ours.
WireError error_of_reading(const std::exception& thrown);

}  // namespace edgecase
