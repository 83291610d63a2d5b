// SPDX-License-Identifier: MIT
//
// Times of scenes: exact and each renderer, frame by frame.
#include <memory>
#include <utility>
#include <variant>

#include "diff/compare.h"
#include "raster/rasterizer.h"
#include "tools/edgecase/bench/rates.h"
#include "tools/edgecase/bench/scenes.h"
#include "tools/edgecase/bench/worker.h"

namespace edgecase {
namespace {

// A worker for all scenes, or why there is none.
struct Rival {
  std::string renderer;
  std::unique_ptr<BenchWorker> worker;
  std::string problem;
};

std::vector<Rival> rivals_of(const BenchPlan& plan) {
  std::vector<Rival> rivals;
  for (const std::string& renderer : plan.renderers) {
    auto started = BenchWorker::start(renderer);
    Rival rival{renderer, nullptr, ""};
    if (auto* worker = std::get_if<std::unique_ptr<BenchWorker>>(&started))
      rival.worker = std::move(*worker);
    else
      rival.problem = std::get<std::string>(std::move(started));
    rivals.push_back(std::move(rival));
  }
  return rivals;
}

bool is_captured(const BenchScene& scene) {
  return scene.layers.front().details.any();
}

// Exact's side of a scene: pixels alone, or all of its Rendering.
class ExactSide {
 public:
  ExactSide(const BenchScene& scene, const Policy& policy)
      : scene_(scene), policy_(policy), drawing_(scene.layers, policy) {}

  void draw() {
    if (is_captured(scene_))
      rendering_ = rasterize(scene_.layers.front(), policy_);
    else
      drawing_.draw();
  }
  std::vector<std::uint8_t> pixels() const {
    return is_captured(scene_) ? rendering_.pixels : drawing_.pixels();
  }

 private:
  const BenchScene& scene_;
  const Policy& policy_;
  ExactDrawing drawing_;
  Rendering rendering_;
};

// The average time of a frame, and its pixels.
BenchAnswer ask(Rival& rival, const BenchScene& scene, double seconds) {
  if (rival.worker == nullptr) return {rival.problem, 0, 0, {}};
  const BenchTask task = is_captured(scene)        ? BenchTask::render
                         : scene.layers.size() > 1 ? BenchTask::draw_by_draw
                                                   : BenchTask::draw;
  return rival.worker->ask({task, seconds, {whole_scene(scene)}});
}

SceneTimes time_scene(const BenchScene& scene, const BenchPlan& plan, std::vector<Rival>& rivals) {
  SceneTimes times{scene.name, scene.unit, scene.items, plan.side, {}, {}};
  const Policy policy;
  ExactSide exact(scene, policy);
  for (const Rival& rival : rivals) times.renderers.push_back({rival.renderer, "", {}, 0});
  for (int round = 0; round < plan.rounds; ++round) {
    times.exact.push_back(time_of(plan.seconds, [&] { exact.draw(); }));
    for (std::size_t r = 0; r < rivals.size(); ++r) {
      RendererTimes& own = times.renderers[r];
      if (!own.problem.empty()) continue;
      BenchAnswer answer = ask(rivals[r], scene, plan.seconds);
      own.problem = std::move(answer.problem);
      if (!own.problem.empty()) continue;
      own.seconds.push_back(answer.seconds / static_cast<double>(answer.rounds));
      own.same_pixels = count_same_pixels(exact.pixels(), answer.pixels);
    }
  }
  return times;
}

}  // namespace

std::vector<SceneTimes> time_scenes(const BenchPlan& plan) {
  std::vector<Rival> rivals = rivals_of(plan);
  std::vector<SceneTimes> times;
  for (const BenchScene& scene : bench_scenes(plan.side))
    times.push_back(time_scene(scene, plan, rivals));
  return times;
}

}  // namespace edgecase
