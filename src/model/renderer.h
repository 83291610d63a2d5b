// SPDX-License-Identifier: MIT
//
// Renderer: anything that turns scenes into renderings, and the kinds of failure to do so.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "model/names.h"
#include "model/rendering.h"
#include "model/scene.h"

namespace edgecase {

// What a renderer claims about itself. Claims may be false: `edgecase backends` renders probes to
// check them.
struct RendererInfo {
  std::string name;     // on the command line: "osmesa:llvmpipe"
  std::string vendor;   // GL_VENDOR, or what the program reports
  std::string version;  // GL_VERSION, or what the program reports
  std::string device;   // GL_RENDERER, or what the program reports
  int subpixel_bits =
      4;  // GL_SUBPIXEL_BITS; 4, the least that OpenGL allows, where nothing is said
  std::map<std::string, std::string> traits;  // further claims, by name
};

// A scene to render, with the id of its case, which renderers use only in messages.
struct Task {
  std::string id;
  const Scene* scene = nullptr;
  // Only coverage is needed: the renderer may omit pixels, depths and colours. `pixels` is then
  // empty, and fragments have neither depth nor colour. It may also report everything.
  bool coverage_only = false;
  // Its images are to be drawn, too (run/invariant_renderer.h).
  bool with_images = false;
};

enum class FailureKind {
  unsupported,  // the renderer reports that it lacks a feature
  crashed,      // its process ended
  timed_out,    // no answer in time
  garbage,      // the answer is no rendering of this scene
  unavailable,  // it could not be started
  internal,     // edgecase itself failed, in drawing or comparing: no fault of the renderer
};
template <>
inline constexpr auto kNames<FailureKind> =
    std::to_array<Named<FailureKind>>({{FailureKind::unsupported, "unsupported"},
                                       {FailureKind::crashed, "crashed"},
                                       {FailureKind::timed_out, "timed-out"},
                                       {FailureKind::garbage, "garbage"},
                                       {FailureKind::unavailable, "unavailable"},
                                       {FailureKind::internal, "internal"}});

// Why a scene has no rendering: one sentence for people.
struct Failure {
  FailureKind kind = FailureKind::unsupported;
  std::string reason;
};

// A fault of this program, in a case of this id: what was thrown, and the wish that it be reported.
Failure internal_failure(const std::string& id, const std::exception& thrown);

using Outcome = std::variant<Rendering, Failure>;

// Receives the outcome of tasks[index]; called once for every task, in order, on the thread that
// called render.
using OutcomeSink = std::function<void(std::size_t index, Outcome)>;

class Renderer {
 public:
  virtual ~Renderer() = default;
  // Complete only after the first rendering, since a process identifies itself in its answer.
  virtual const RendererInfo& info() const = 0;
  // Renders every task. A renderer's misbehaviour is a Failure, never an exception. It returns
  // early, with tasks left over, only if `sink` throws.
  virtual void render(std::span<const Task> tasks, const OutcomeSink& sink) = 0;
  // A digest of the outcome that `sink` is receiving and of the request for it; 0: unknown.
  virtual std::uint64_t outcome_digest() const { return 0; }
};

// Renderers with a name of their own: mine=exec:./r is exec:./r, and is called mine in all output.

// Whether this is such a name: at most 64 letters, digits, '.', '-' and '_', a letter or digit
// first. "exact" is taken.
bool is_own_name(std::string_view name);

// The trait by which such a renderer reports its address, "exec:./r". Ignored of others.
constexpr const char* kAddressTrait = "address";

// Without a name of its own, a renderer's name is its address.
const std::string& address_of(const RendererInfo& info);

// As the command line names it: "mine=exec:./r", "exec:./r".
std::string asked_as(const RendererInfo& info);

// Whether the renderer of this address is an OpenGL.
bool is_opengl(std::string_view address);

// Renderers that replay a recording. Their results are their own, but known faults of the recorded
// renderer apply to them.

// Names of such renderers begin with this prefix, followed by the path of a file.
constexpr std::string_view kRecordingPrefix = "recording:";

// Their trait with the name of the recorded renderer.
constexpr const char* kRecordedTrait = "recorded";

// The name by which known faults and profiles identify a renderer: an OpenGL's address, whatever it
// is called, since a driver has its faults under any name; else its own name or, for a recording
// without one, that of the recorded renderer. Other renderers' trait is ignored.
const std::string& known_as(const RendererInfo& info);

}  // namespace edgecase
