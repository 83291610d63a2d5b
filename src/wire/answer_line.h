// SPDX-License-Identifier: MIT
//
// The line in which another process answers: a rendering as JSON, or why there is none. See
// reference/PROTOCOL.md.
//
// Whoever answers may be wrong in every way, and what is read here is judged by others, so reading
// is strict: an answer to another scene, an array of the wrong size, a fragment outside the target
// and hit counts that contradict the fragments are all refused, with a sentence that says where.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "model/renderer.h"
#include "wire/request_line.h"

namespace edgecase {

struct Answer {
  Outcome outcome;                     // a Rendering, or a Failure of kind `unsupported`
  std::optional<RendererInfo> claims;  // who answered, where the line says it; without a name
};

// The line that answers with a rendering, without the line break at its end. `claims` may be null.
std::string answer_line(const std::string& digest, const Rendering& rendering,
                        const RendererInfo* claims);

// The line that answers with coverage alone, for a request that asked for no more: pixels, depths,
// stencils, colours and mip chains are left out, and so are hit counts that agree with the
// fragments. Those that differ are told, so that the reader judges them as it would those of a
// whole answer.
std::string coverage_line(const std::string& digest, const Rendering& rendering,
                          const RendererInfo* claims);

// The line that refuses a scene, for a reason that is one sentence for people.
std::string refusal_line(const std::string& digest, const std::string& reason,
                         const RendererInfo* claims);

// Reads the answer to the scene that has this digest. Fragments come back sorted. Coverage alone is
// an answer only where `coverage_only` was asked for; a whole answer always is.
std::variant<Answer, WireError> parse_answer(std::string_view line, const std::string& digest,
                                             const Scene& scene, bool coverage_only = false);

// How the hit counts of a rendering contradict its fragments, naming the first pixel (bottom row
// first) where they do; nothing when they agree, when the rendering has no hit counts, or when its
// target has several samples: which of those are written is decided after the shader.
std::optional<std::string> contradiction_of_hits(const Rendering& rendering);

// The same where fragments meet tests (has_fragment_operations): a pixel, or a sample of one, may
// have fewer hits than the pixel has fragments, and never more.
std::optional<std::string> excess_of_hits(const Rendering& rendering);

}  // namespace edgecase
