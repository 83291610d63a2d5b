// SPDX-License-Identifier: MIT
//
// SceneDrawing: draws the scenes of a part of the measurement, and counts them.
#pragma once

#include <atomic>
#include <cstddef>
#include <string>
#include <vector>

#include "model/renderer.h"
#include "profile/observation.h"

namespace edgecase {

struct DrawnScene {
  Scene scene;
  Rendering rendering;
};

struct DrawnCounts {
  std::size_t scenes = 0;  // that were drawn
  std::size_t not_drawn = 0;
  std::string first_failure;  // of those not drawn
};

class SceneDrawing {
 public:
  // `expected`: of how many scenes progress is told.
  SceneDrawing(Renderer& renderer, const ObservationProgress& progress,
               const std::atomic<bool>* stop, std::size_t expected)
      : renderer_(renderer), progress_(progress), stop_(stop), left_(expected) {}

  // Scenes with what was covered.
  std::vector<Observation> seen(const std::string& family, std::vector<Scene> scenes);
  // Scenes with their whole renderings, of those that were drawn.
  std::vector<DrawnScene> told(const std::string& family, std::vector<Scene> scenes);
  // Why the renderer does not draw a scene; empty: it does. A refusal counts as no failure.
  std::string refusal_of(const Scene& scene);
  // What is left of the expected scenes is not going to be drawn.
  void finish();

  const DrawnCounts& counts() const { return counts_; }

 private:
  void count(std::size_t scenes);
  void note(const std::string& failure);

  Renderer& renderer_;
  const ObservationProgress& progress_;
  const std::atomic<bool>* stop_;
  std::size_t left_;
  DrawnCounts counts_;
};

}  // namespace edgecase
