// SPDX-License-Identifier: MIT
#include <chrono>
#include <utility>

#include "reference/draw_state.h"
#include "reference/driver_limits.h"
#include "reference/scene_renderer.h"

namespace edgecase {

std::variant<DrawingTime, std::string> SceneRenderer::time_drawing(const Scene& scene,
                                                                   double seconds, bool by_draw) {
  using Clock = std::chrono::steady_clock;
  std::string problem = problem_.empty() ? limit_exceeded_by(scene, limits_) : problem_;
  if (!problem.empty()) return problem;
  const bool looks_up = is_textured(scene);
  const auto prepared = prepare(scene, looks_up);
  if (const auto* failure = std::get_if<Failure>(&prepared)) return failure->reason;
  const Surfaces& surfaces = std::get<Surfaces>(prepared);
  upload(scene);
  const Pass pass{.program = &Programs::timed, .looks_up = looks_up, .finishes = by_draw};
  DrawingTime time;
  Rendering last;
  last.width = scene.target.width;
  last.height = scene.target.height;
  // The first frame includes drivers' deferred work and is not timed.
  draw_pixels(scene, surfaces, last);
  gl_.Finish();
  const auto start = Clock::now();
  do {
    clear_for(scene, surfaces.color, scene.target.clear);
    draw_all(scene, pass);
    gl_.Finish();
    ++time.frames;
    time.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  } while (time.seconds < seconds);
  draw_pixels(scene, surfaces, last);
  time.pixels = std::move(last.pixels);
  if (auto failure = take_failure()) return failure->reason;
  return time;
}

}  // namespace edgecase
