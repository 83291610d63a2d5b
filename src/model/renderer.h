// SPDX-License-Identifier: MIT
//
// Renderer: anything that turns scenes into renderings, and the two ways in which it may not.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "model/rendering.h"
#include "model/scene.h"

namespace edgecase {

// Who a renderer is and what it claims of itself. Claims are not facts: `edgecase backends` renders
// probes to find out.
struct RendererInfo {
  std::string name;     // as the command line names it: "osmesa:llvmpipe"
  std::string vendor;   // GL_VENDOR, or what the program says
  std::string version;  // GL_VERSION, or what the program says
  std::string device;   // GL_RENDERER, or what the program says
  int subpixel_bits =
      4;  // GL_SUBPIXEL_BITS; 4, the least that OpenGL allows, where nothing is said
  std::map<std::string, std::string> traits;  // further claims, by name
};

// A scene to render, with the id of its case: renderers use the id in messages only.
struct Task {
  std::string id;
  const Scene* scene = nullptr;
  // The caller looks at coverage alone: a renderer may leave pixels, depths and colours out. Then
  // `pixels` is empty, and fragments have neither depth nor colour. It may also tell everything.
  bool coverage_only = false;
};

enum class FailureKind {
  unsupported,  // the renderer says that it does not do this
  crashed,      // its process ended
  timed_out,    // no answer in time
  garbage,      // the answer is no rendering of this scene
  unavailable,  // it could not be started at all
};

const char* name_of(FailureKind);

// Why a scene has no rendering: one sentence, for people.
struct Failure {
  FailureKind kind = FailureKind::unsupported;
  std::string reason;
};

using Outcome = std::variant<Rendering, Failure>;

// Receives the outcome of tasks[index]; called once for every task, in order, on the thread that
// called render.
using OutcomeSink = std::function<void(std::size_t index, Outcome)>;

class Renderer {
 public:
  virtual ~Renderer() = default;
  // Known in full only after the first rendering, since a process tells who it is as it answers.
  virtual const RendererInfo& info() const = 0;
  // Renders every task. Never throws for what a renderer does: that is a Failure. Returns early,
  // leaving tasks without an outcome, only when `sink` asked for it by throwing.
  virtual void render(std::span<const Task> tasks, const OutcomeSink& sink) = 0;
};

// Renderers with a name of their own: mine=exec:./r is exec:./r, and is called mine wherever
// something is told of it.

// Is it such a name? At most 64 letters, digits, '.', '-' and '_', a letter or digit first; "exact"
// is taken.
bool is_own_name(std::string_view name);

// The trait by which such a renderer tells its address, "exec:./r". Of others it means nothing.
constexpr const char* kAddressTrait = "address";

// Without a name of its own, a renderer's name is its address.
const std::string& address_of(const RendererInfo& info);

// As the command line asks for it: "mine=exec:./r", "exec:./r".
std::string asked_as(const RendererInfo& info);

// Is the renderer of this address an OpenGL?
bool is_opengl(std::string_view address);

// Renderers that replay a recording, and who they stand for: their results are their own, but what
// is known of the renderer that was recorded holds for them.

// What names of such renderers begin with; the path of a file follows.
constexpr std::string_view kRecordingPrefix = "recording:";

// The trait by which they tell the name of the renderer that was recorded.
constexpr const char* kRecordedTrait = "recorded";

// The name under which known faults and profiles know a renderer: an OpenGL's address, whoever
// named it, since a driver has its faults under any name; else its name, or that of the renderer
// which was recorded, where the recording has no name of its own. Of others than recordings, the
// trait means nothing.
const std::string& known_as(const RendererInfo& info);

}  // namespace edgecase
