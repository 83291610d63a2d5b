// SPDX-License-Identifier: MIT
//
// SceneDrawing: has a renderer draw the scenes of a measurement, and counts them.
//
// Questions about coverage use observations: which pixels each primitive drew or, on multisampled
// targets, which samples. Questions about values use whole renderings.
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "diff/coverage/coverage_diff.h"
#include "model/renderer.h"
#include "model/scene.h"
#include "rules/choices.h"

namespace edgecase {

// A scene with the coverage of each of its primitives. It must not move: others point into `scene`.
struct Observation {
  std::string id;  // "triangle/000123", for counter-examples
  Scene scene;
  std::vector<std::vector<PixelPosition>> drawn;  // by primitive, sorted by row, with repetitions
  // For a multisampled target, instead of `drawn`: by primitive, the same for each sample.
  std::vector<SampleCoverage> samples;
  SamplePositions positions;  // as reported by the renderer
  std::string failure;        // why there is no rendering; otherwise empty
};

// Whether the observed coverage of a primitive equals the choice's. There must be no failure.
bool is_drawn_by(const CoverageChoice& choice, const ScenePrimitive& primitive,
                 const Observation& observation);

struct DrawnScene {
  Scene scene;
  Rendering rendering;
};

struct DrawnCounts {
  std::size_t scenes = 0;  // that were drawn
  std::size_t not_drawn = 0;
  std::string first_failure;  // of those not drawn; empty if all were

  DrawnCounts& operator+=(const DrawnCounts& more);
};

// Makes a renderer of the kind being measured: each surface uses its own.
using MakeRenderer = std::function<std::unique_ptr<Renderer>()>;

// Called with the number of scenes drawn since the last call; from any thread.
using ObservationProgress = std::function<void(std::size_t)>;

// Thrown once `stop` is true.
struct MeasurementStopped {};

// "crashed: signal 11"
std::string text_of(const Failure& failure);

// "triangle/00042"
std::string scene_id(const std::string& family, std::size_t index);

// A task for each scene, for its whole rendering. The scenes must outlive the tasks.
std::vector<Task> tasks_of(const std::string& family, std::span<const Scene> scenes);

// The scene with only one of its primitives.
Scene only_primitive(const Scene& scene, int primitive);

// How scenes are counted.
enum class Counted {
  scenes,    // by result, and as progress
  progress,  // only as progress
  nothing,
};

class SceneDrawing {
 public:
  // `expected`: the number of scenes for which progress is reported.
  SceneDrawing(Renderer& renderer, const ObservationProgress& progress,
               const std::atomic<bool>* stop, std::size_t expected)
      : renderer_(renderer), progress_(progress), stop_(stop), left_(expected) {}

  // Draws scenes, grouped by size, since changes of size are slow in some window systems. `visit`
  // gets each outcome with the index of its task.
  using Visit = std::function<void(std::size_t index, Outcome outcome)>;
  void draw(std::span<const Task> tasks, const Visit& visit, Counted counted = Counted::scenes);
  // The same, only with the scenes that were drawn.
  using VisitRendering = std::function<void(std::size_t index, Rendering rendering)>;
  void draw(const std::string& family, std::span<const Scene> scenes, const VisitRendering& visit,
            Counted counted = Counted::scenes);

  // Fills in the coverage of each scene, or the reason why there is none.
  void observe(std::span<Observation> observations);
  std::vector<Observation> observed(const std::string& family, std::vector<Scene> scenes);
  // The scenes that were drawn, with their whole renderings.
  std::vector<DrawnScene> drawn(const std::string& family, std::vector<Scene> scenes);
  // Why the renderer does not draw a scene; empty if it does. A refusal is no failure.
  std::string refusal_of(const Scene& scene);
  // Reports the remaining expected scenes as progress, since they will not be drawn.
  void finish() { report(left_); }

  const DrawnCounts& counts() const { return counts_; }
  // The sub-pixel bits that ruling 4 grants, by the renderer's report; known once it has drawn.
  int latitude_bits() const;

 private:
  void report(std::size_t scenes);
  void note(const std::string& failure);

  Renderer& renderer_;
  const ObservationProgress& progress_;
  const std::atomic<bool>* stop_;
  std::size_t left_;
  DrawnCounts counts_;
};

}  // namespace edgecase
