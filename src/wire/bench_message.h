// SPDX-License-Identifier: MIT
//
// What `edgecase bench` asks a worker that was started with --bench: how long it takes with scenes.
// Bytes between two programs that were built together, as in wire/message.h.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "model/scene.h"
#include "wire/wire_error.h"

namespace edgecase {

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
