// SPDX-License-Identifier: MIT
//
// SceneRenderer: draws a Scene with an OpenGL context and returns a Rendering.
//
// Three passes draw the same primitives with the same state: pixels (colours into RGBA8), hit
// counts (added up by blending, reference/targets.h) and the capture (a record per fragment shader
// invocation, reference/capture.h; where shaders cannot write to buffers it is drawn in parts,
// reference/word_capture.h). Pixels and hit counts go through the fixed-function end of the
// pipeline and the capture does not, so they check each other: the reader of the answer refuses it
// if they differ. If the target has a depth or a stencil buffer, all three passes have it, and it
// is read after the first. With fragment operations, the first two have all tests and the capture
// none, so that it includes fragments that fail them (reference/fragment_state.h). A scene with a
// textured draw uses programs that look up, except for hit counts and for coverage only, where
// colours do not matter.
//
// A multisampled target uses its own programs and state, which is reset after each pass, so that
// scenes without samples are drawn as if it did not exist. Its samples are fetched one by one,
// reference/sample_reader.h.
//
// A supersampled scene is drawn pass by pass, each as a separate scene, and once more to be added
// to the others (reference/accumulator.h).
//
// It does not transform, clip or judge anything: scenes have clip coordinates, or window
// coordinates for which the loader has ensured that their clip coordinates are exact in float32.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "model/renderer.h"
#include "reference/accumulator.h"
#include "reference/capture.h"
#include "reference/driver_limits.h"
#include "reference/fragment_state.h"
#include "reference/gl_context.h"
#include "reference/gl_objects.h"
#include "reference/program_cache.h"
#include "reference/targets.h"
#include "reference/textures.h"
#include "reference/word_capture.h"

namespace edgecase {

// The time of consecutive frames.
struct DrawingTime {
  std::size_t frames = 0;
  double seconds = 0;  // of all of them
  // The last frame, RGBA8, row by row from the bottom; resolved if the target is multisampled.
  std::vector<std::uint8_t> pixels;
};

class SceneRenderer {
 public:
  // `context` must be current, stay so, and outlive the renderer. A context that lacks required
  // features still makes a renderer: it answers every scene with the reason.
  explicit SceneRenderer(GlContext& context);

  // What the context reports about itself; the name is empty.
  const RendererInfo& info() const { return info_; }

  // A Rendering with hit counts, or a Failure: `unsupported` with the reason, or `crashed` if the
  // context is lost and the process must restart. With `coverage_only` the pass for pixels is
  // omitted, and the rendering has no pixels, depths, details and mip chains; fragments are
  // captured, and hits counted, as usual. Supersampled scenes are always drawn completely.
  Outcome render(const Scene& scene, bool coverage_only = false);

  // The time for drawing a scene, and nothing else: its vertices are already in place, and nothing
  // is read. Clears, draws and finishes until `seconds` have passed, at least once; with `by_draw`
  // it finishes after each draw. A sentence if the scene cannot be drawn.
  std::variant<DrawingTime, std::string> time_drawing(const Scene& scene, double seconds,
                                                      bool by_draw);

 private:
  // GL objects, in the order in which they may be made. They exist only if `problem_` is empty.
  struct Objects {
    Objects(const GladGLContext& gl, GlContext& context, Programs made);
    // By form; none without storage blocks.
    std::array<std::optional<Capture>, 3> captures;
    ProgramCache programs;
    WordCapture words;  // without storage blocks
    Targets targets;
    Textures textures;
    Accumulator accumulator;
    GlBuffer vertices;
    GlVertexArray vertex_array;
  };

  // The differences between the passes over a scene.
  struct Pass {
    GlProgram Programs::*program = nullptr;
    bool looks_up = false;  // with the programs for textures
    PassKind kind = PassKind::pixels;
    Capture* capture = nullptr;  // for a pass that captures into it
    int part = 0;                // of a record, for a pass that captures without
    float step = 1;              // for a pass that counts hits
    bool finishes = false;       // after each draw

    bool counts() const { return program == &Programs::count; }
    // Whether the target gets every fragment that reaches it, for a capture without storage blocks.
    bool writes_all() const { return kind == PassKind::capture && capture == nullptr; }
  };

  // Makes the programs and framebuffers for a scene, or returns why there are none.
  std::variant<Surfaces, Failure> prepare(const Scene& scene, bool looks_up);
  // Draws each pass as a separate scene, and once more into the accumulator.
  Outcome render_passes(const Scene& scene);
  // The GL's pending error, if any, which is thereby cleared.
  std::optional<Failure> take_failure() const;
  void describe(const GlContext& context);
  void describe_objects();
  // Finds by drawing which conventions for provoking vertices have an effect.
  void probe_provoking_vertices();
  void upload(const Scene& scene);
  void set_lookup(const Scene& scene, const Draw& draw, const GlProgram& program);
  void draw_all(const Scene& scene, const Pass& pass);
  void clear_for(const Scene& scene, GLuint framebuffer, const Color& color);
  void draw_pixels(const Scene& scene, const Surfaces& surfaces, Rendering& rendering);
  // Reads the colours of a multisampled target, resolved and by sample, and its depths and
  // stencils, which stay empty if they are not those of their format.
  void read_samples(const MultisampleTarget& target, Rendering& rendering);
  // The red channel of the count.
  std::vector<float> read_sums(const Surfaces& surfaces, const HitCounter& counter,
                               const Rendering& rendering);
  // The fragments must have been captured.
  const HitCounter& counter_of(const Surfaces& surfaces, const Rendering& rendering) const;
  // Counts the fragments that pass their tests or, as a capture, all of them.
  std::vector<std::uint32_t> count_hits(const Scene& scene, const Surfaces& surfaces, PassKind kind,
                                        const Rendering& rendering);
  std::optional<std::string> capture_fragments(const Scene& scene, const Surfaces& surfaces,
                                               bool coverage_only, Rendering& rendering);
  // The same without storage blocks.
  std::optional<std::string> capture_words(const Scene& scene, const Surfaces& surfaces, Pass pass,
                                           Capture::Form form, bool coverage_only,
                                           Rendering& rendering);
  // Whether there are more hits than fragments in words, as a sentence.
  std::optional<std::string> doubt_of_words(const Scene& scene, const Surfaces& surfaces,
                                            const Rendering& rendering);
  // What a pass draws of a part of the records: RGBA8, a plane per sample.
  std::vector<std::uint8_t> draw_part(const Scene& scene, const Surfaces& surfaces,
                                      const Pass& pass, const Rendering& rendering);
  // Removes what the scene does not request, and what this driver's GLSL lacks.
  void drop_details(const Scene& scene, Rendering& rendering) const;
  // Reports the levels that the driver made of the scene's textures.
  void report_mip_chains(const Scene& scene, Rendering& rendering);

  GladGLContext gl_{};
  RendererInfo info_;
  std::string problem_;  // why nothing can be drawn; empty if everything works
  DriverLimits limits_;
  std::optional<Objects> objects_;
};

}  // namespace edgecase
