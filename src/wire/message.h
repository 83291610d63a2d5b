// SPDX-License-Identifier: MIT
//
// Requests and answers as bytes, between the program and our own workers, which are built together:
// the equivalent of PROTOCOL.md's lines of JSON (request_line.h, answer_line.h). An answer gives
// the same Rendering in either form.
//
// A worker may be wrong like any renderer, through a driver's fault, so its answer is checked as
// strictly as an answer line.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "model/scene.h"
#include "wire/answer_line.h"
#include "wire/request_line.h"

namespace edgecase {

// A request as sent. The digest is that of its bytes, and the answer repeats it.
struct OutgoingRequest {
  std::string bytes;
  std::uint64_t digest = 0;
};
OutgoingRequest request_message(const std::string& id, const Scene& scene, bool coverage_only);

// A request as received.
struct IncomingRequest {
  std::uint64_t digest = 0;
  std::string id;  // of the case, for messages
  bool coverage_only = false;
  Scene scene;
};
// Refuses a request that was truncated or altered on its way.
std::variant<IncomingRequest, WireError> parse_request_message(std::string_view bytes);

// Answers with a rendering, with coverage only, or with a refusal; `claims` may be null.
std::string answer_message(std::uint64_t digest, const Outcome& outcome, bool coverage_only,
                           const RendererInfo* claims);

// Reads the answer to the request with this digest, as strictly as parse_answer reads a line.
std::variant<Answer, WireError> parse_answer_message(std::string_view bytes, std::uint64_t digest,
                                                     const Scene& scene, bool coverage_only);

// A digest of a scene and of an answer to it: of all that a message would carry of them.
std::uint64_t digest_of_answer(const Scene& scene, const Rendering& rendering);

// The messages between `edgecase bench` and a worker started with --bench: how long scenes take.
// They are bytes between two programs built together, as above.
enum class BenchTask : std::uint8_t {
  draw,          // clear, draw, finish: one scene, repeatedly
  draw_by_draw,  // the same, finished after each draw
  render,        // draw, count hits, capture and read back: all scenes, repeatedly
};

struct BenchRequest {
  BenchTask task = BenchTask::draw;
  double seconds = 0;  // minimum duration; at least one round is done
  std::vector<Scene> scenes;
};

struct BenchAnswer {
  std::string problem;               // why nothing was timed; if empty, the rest is valid
  std::uint64_t rounds = 0;          // of all scenes
  double seconds = 0;                // duration of the rounds
  std::vector<std::uint8_t> pixels;  // of the last frame or scene: RGBA8, bottom row first
};

std::string bench_request_message(const BenchRequest& request);
std::variant<BenchRequest, WireError> parse_bench_request(std::string_view bytes);
std::string bench_answer_message(const BenchAnswer& answer);
std::variant<BenchAnswer, WireError> parse_bench_answer(std::string_view bytes);

}  // namespace edgecase
