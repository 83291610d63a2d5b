// SPDX-License-Identifier: MIT
#include "reference/bench_service.h"

#include <chrono>
#include <utility>
#include <variant>

namespace edgecase {

namespace {

BenchAnswer time_drawing(SceneRenderer& renderer, const BenchRequest& request) {
  if (request.scenes.size() != 1) return {"there is one scene to draw, or none is timed", 0, 0, {}};
  auto timed = renderer.time_drawing(request.scenes.front(), request.seconds,
                                     request.task == BenchTask::draw_by_draw);
  if (auto* problem = std::get_if<std::string>(&timed)) return {std::move(*problem), 0, 0, {}};
  DrawingTime& time = std::get<DrawingTime>(timed);
  return {"", time.frames, time.seconds, std::move(time.pixels)};
}

BenchAnswer time_rendering(SceneRenderer& renderer, const BenchRequest& request) {
  using Clock = std::chrono::steady_clock;
  BenchAnswer answer;
  const auto start = Clock::now();
  do {
    for (const Scene& scene : request.scenes) {
      Outcome outcome = renderer.render(scene);
      if (const auto* failure = std::get_if<Failure>(&outcome)) return {failure->reason, 0, 0, {}};
      answer.pixels = std::move(std::get<Rendering>(outcome).pixels);
    }
    ++answer.rounds;
    answer.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  } while (answer.seconds < request.seconds);
  return answer;
}

}  // namespace

BenchAnswer time_scenes(SceneRenderer& renderer, const BenchRequest& request) {
  return request.task == BenchTask::render ? time_rendering(renderer, request)
                                           : time_drawing(renderer, request);
}

}  // namespace edgecase
