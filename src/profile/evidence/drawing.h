// SPDX-License-Identifier: MIT
//
// SceneDrawing: has a renderer draw the scenes of a measurement, and counts them.
//
// A question about coverage gets observations: which pixels each primitive drew, or on multisampled
// targets which samples. A question about values gets whole renderings.
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

// A scene with what was drawn of each of its primitives. Does not move: others point into `scene`.
struct Observation {
  std::string id;  // "triangle/000123", for counter-examples
  Scene scene;
  std::vector<std::vector<PixelPosition>> drawn;  // by primitive, row first, as often as it came
  // Of a multisampled target, instead of `drawn`: by primitive, the same of each sample.
  std::vector<SampleCoverage> samples;
  SamplePositions positions;  // where the renderer says that they lie
  std::string failure;        // why there is no rendering; empty: there is one
};

// Is the observed coverage of a primitive what the choice draws? There must be no failure.
bool is_drawn_by(const CoverageChoice& choice, const ScenePrimitive& primitive,
                 const Observation& observation);

struct DrawnScene {
  Scene scene;
  Rendering rendering;
};

struct DrawnCounts {
  std::size_t scenes = 0;  // that were drawn
  std::size_t not_drawn = 0;
  std::string first_failure;  // of those not drawn; empty: all were

  DrawnCounts& operator+=(const DrawnCounts& more);
};

// A new renderer of the one that is measured: each surface is measured with its own.
using MakeRenderer = std::function<std::unique_ptr<Renderer>()>;

// Called with the number of scenes that were drawn since the last call; from any thread.
using ObservationProgress = std::function<void(std::size_t)>;

// Thrown when `stop` became true.
struct MeasurementStopped {};

// "crashed: signal 11"
std::string text_of(const Failure& failure);

// "triangle/00042"
std::string scene_id(const std::string& family, std::size_t index);

// A task for each scene, all of its rendering asked for. The scenes must outlive the tasks.
std::vector<Task> tasks_of(const std::string& family, std::span<const Scene> scenes);

// The scene with one of its primitives alone.
Scene only_primitive(const Scene& scene, int primitive);

// How scenes are counted.
enum class Counted {
  scenes,    // by result, and as progress
  progress,  // as progress alone
  nothing,
};

class SceneDrawing {
 public:
  // `expected`: the number of scenes that progress is reported of.
  SceneDrawing(Renderer& renderer, const ObservationProgress& progress,
               const std::atomic<bool>* stop, std::size_t expected)
      : renderer_(renderer), progress_(progress), stop_(stop), left_(expected) {}

  // Draws scenes, those of one size together, since some window systems pay for every change of
  // size. `visit` gets each outcome with the index of its task.
  using Visit = std::function<void(std::size_t index, Outcome outcome)>;
  void draw(std::span<const Task> tasks, const Visit& visit, Counted counted = Counted::scenes);
  // The same, of the scenes that were drawn.
  using VisitRendering = std::function<void(std::size_t index, Rendering rendering)>;
  void draw(const std::string& family, std::span<const Scene> scenes, const VisitRendering& visit,
            Counted counted = Counted::scenes);

  // Fills in what was drawn of each scene, or why nothing was.
  void observe(std::span<Observation> observations);
  std::vector<Observation> observed(const std::string& family, std::vector<Scene> scenes);
  // Scenes with their whole renderings, of those that were drawn.
  std::vector<DrawnScene> drawn(const std::string& family, std::vector<Scene> scenes);
  // Why the renderer does not draw a scene; empty: it does. A refusal counts as no failure.
  std::string refusal_of(const Scene& scene);
  // Reports what is left of the expected scenes as progress: they are not going to be drawn.
  void finish() { report(left_); }

  const DrawnCounts& counts() const { return counts_; }
  // The sub-pixel bits that ruling 4 grants, by what the renderer reports once it has drawn.
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
