// SPDX-License-Identifier: MIT
#include "profile/asked_scenes.h"

#include <map>
#include <mutex>
#include <utility>

#include "raster/rasterizer.h"
#include "rules/choices.h"

namespace edgecase {
namespace {

// Keeps what it is asked, from all threads. Of scenes with one id the first is kept.
struct Asked {
  std::mutex guard;
  std::map<std::string, Scene> scenes;
};

class AskedRenderer final : public Renderer {
 public:
  explicit AskedRenderer(Asked& asked) : asked_(asked), policy_(Policy()) {}

  const RendererInfo& info() const override {
    static const RendererInfo info{"exact", "", "", "exact", 8, {}};
    return info;
  }
  void render(std::span<const Task> tasks, const OutcomeSink& sink) override {
    {
      const std::lock_guard lock(asked_.guard);
      for (const Task& task : tasks) asked_.scenes.emplace(task.id, *task.scene);
    }
    for (std::size_t i = 0; i < tasks.size(); ++i) sink(i, rasterize(*tasks[i].scene, policy_));
  }

 private:
  Asked& asked_;
  ResolvedPolicy policy_;
};

}  // namespace

MeasureOptions options_of_pages() {
  MeasureOptions options;
  options.surfaces = {Surface::fbo};
  options.searched_scenes = options.scenes_per_kind;
  return options;
}

std::vector<AskedScene> asked_scenes(MeasureOptions options) {
  Asked asked;
  measure([&] { return std::make_unique<AskedRenderer>(asked); }, options);
  std::vector<AskedScene> scenes;
  for (auto& [id, scene] : asked.scenes) scenes.push_back({id, std::move(scene)});
  return scenes;
}

}  // namespace edgecase
