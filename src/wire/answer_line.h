// SPDX-License-Identifier: MIT
//
// The line in which another process answers: a rendering as JSON, or the reason why there is none.
// See reference/PROTOCOL.md.
//
// An answer may be wrong in every way, and its content is judged later, so reading is strict: an
// answer to another scene, an array of the wrong size, a fragment outside the target, or hit counts
// that contradict the fragments are refused, with a sentence that says where.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "model/renderer.h"
#include "wire/request_line.h"

namespace edgecase {

struct Answer {
  Outcome outcome;                     // a Rendering, or a Failure of kind `unsupported`
  std::optional<RendererInfo> claims;  // the renderer's identity if the line has it, without a name
  // Of the request and of all that answers it, but for the claims, as bytes (wire/message.h); 0: it
  // came as a line.
  std::uint64_t digest = 0;
};

// What programs say of themselves is told in every report, so it is bounded where it is read: a
// longer text is cut, with the number of bytes that are left out.
constexpr std::size_t kLongestText = 1000;     // bytes, before the mark
constexpr std::size_t kMostTraits = 256;       // of a renderer
constexpr std::size_t kLongestTraitName = 64;  // bytes
std::string bounded_text(std::string text);
// The same for all texts of claims. Throws a wire::Refusal for more traits, or longer names.
RendererInfo bounded_claims(RendererInfo claims);

// The line for a rendering, without a line break at its end. `claims` may be null.
std::string answer_line(const std::string& digest, const Rendering& rendering,
                        const RendererInfo* claims);

// The line for a request of coverage only. Pixels, depths, stencils, colours and mip chains are
// left out, and so are hit counts that agree with the fragments; others are included, so that the
// reader judges them as in a whole answer.
std::string coverage_line(const std::string& digest, const Rendering& rendering,
                          const RendererInfo* claims);

// The line that refuses a scene; `reason` is one sentence for people.
std::string refusal_line(const std::string& digest, const std::string& reason,
                         const RendererInfo* claims);

// Reads the answer to the scene with this digest. Fragments come back sorted. An answer with
// coverage only is accepted if `coverage_only` is set; a whole answer always is.
std::variant<Answer, WireError> parse_answer(std::string_view line, const std::string& digest,
                                             const Scene& scene, bool coverage_only = false);

// How the hit counts of a rendering contradict its fragments, naming the first pixel (bottom row
// first). Nothing if they agree, if there are no hit counts, or if the target has several samples:
// which of those are written is decided after the shader.
std::optional<std::string> contradiction_of_hits(const Rendering& rendering);

// The same if fragments undergo tests (has_fragment_operations): a pixel or sample may have fewer
// hits than the pixel has fragments, but never more.
std::optional<std::string> excess_of_hits(const Rendering& rendering);

}  // namespace edgecase
