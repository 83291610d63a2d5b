// SPDX-License-Identifier: MIT
//
// Requests and answers as bytes, between the program and our own workers: what PROTOCOL.md has as
// lines of JSON (request_line.h, answer_line.h), for two programs that were built together. An
// answer that crosses as bytes is the same Rendering as one that crosses as JSON.
//
// A worker may be wrong as any renderer may, by a driver's fault: what it draws is checked as
// strictly as an answer's line is.
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

// A request as it is sent. The digest is of its bytes, and is repeated by the answer.
struct OutgoingRequest {
  std::string bytes;
  std::uint64_t digest = 0;
};
OutgoingRequest request_message(const std::string& id, const Scene& scene, bool coverage_only);

// A request as it is received.
struct IncomingRequest {
  std::uint64_t digest = 0;
  std::string id;  // of the case, for messages
  bool coverage_only = false;
  Scene scene;
};
// Refuses what was cut or changed on its way.
std::variant<IncomingRequest, WireError> parse_request_message(std::string_view bytes);

// Answers with a rendering, with coverage alone, or with a refusal; `claims` may be null.
std::string answer_message(std::uint64_t digest, const Outcome& outcome, bool coverage_only,
                           const RendererInfo* claims);

// Reads the answer to the request that has this digest, as parse_answer reads a line.
std::variant<Answer, WireError> parse_answer_message(std::string_view bytes, std::uint64_t digest,
                                                     const Scene& scene, bool coverage_only);

// What `edgecase bench` asks a worker that was started with --bench: how long it takes with scenes.
// Bytes between two programs that were built together, as above.
enum class BenchTask : std::uint8_t {
  draw,          // clear, draw, finish: one scene, over and over
  draw_by_draw,  // the same, finished after each draw
  render,        // draw, count hits, capture and read back: all scenes, over and over
};

struct BenchRequest {
  BenchTask task = BenchTask::draw;
  double seconds = 0;  // go on until they have passed; one round at least
  std::vector<Scene> scenes;
};

struct BenchAnswer {
  std::string problem;               // why nothing was timed; empty: the rest holds
  std::uint64_t rounds = 0;          // over all scenes
  double seconds = 0;                // that they took
  std::vector<std::uint8_t> pixels;  // of the last frame or scene: RGBA8, bottom row first
};

std::string bench_request_message(const BenchRequest& request);
std::variant<BenchRequest, WireError> parse_bench_request(std::string_view bytes);
std::string bench_answer_message(const BenchAnswer& answer);
std::variant<BenchAnswer, WireError> parse_bench_answer(std::string_view bytes);

}  // namespace edgecase
