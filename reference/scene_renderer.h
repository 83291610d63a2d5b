// SPDX-License-Identifier: MIT
//
// SceneRenderer: a Scene drawn by an OpenGL context, as a Rendering.
//
// Three passes draw the same primitives with the same state: pixels (colours into RGBA8), hit
// counts (added up by blending, reference/targets.h) and the capture (a record per fragment shader
// invocation, reference/capture.h). Pixels and hit counts go through the fixed-function end of the
// pipeline and the capture does not, so that they check each other: whoever reads the answer
// refuses it where they differ. Where the target has a depth or a stencil buffer, all three have
// it, and it is read after the first. With fragment operations, the first two have all tests and
// the capture none, so that it tells what fails them too (reference/fragment_state.h). A scene with
// a textured draw is drawn by programs that look up, but for its hit counts and for coverage alone,
// where colours do not matter.
//
// A multisampled target is drawn to by programs and with state of its own, which is put back after
// each pass, so that scenes without samples are drawn as if there were none. Its samples are
// fetched one by one, reference/sample_reader.h.
//
// A supersampled scene is drawn pass by pass, each as a scene of its own, and once more to be added
// to the others (reference/accumulator.h).
//
// It does not transform, clip or judge anything: scenes carry clip coordinates, or window ones of
// which the loader has made sure that their clip coordinates are exact in float32.
#pragma once

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
#include "reference/gl_context.h"
#include "reference/gl_objects.h"
#include "reference/program_cache.h"
#include "reference/targets.h"
#include "reference/textures.h"

namespace edgecase {

// Of frames that were drawn one after the other.
struct DrawingTime {
  std::size_t frames = 0;
  double seconds = 0;  // of all of them
  // What the last one shows, RGBA8, row by row from the bottom; of a multisampled target, resolved.
  std::vector<std::uint8_t> pixels;
};

class SceneRenderer {
 public:
  // `context` must be current, stay so, and outlive the renderer. A context that lacks what drawing
  // needs still makes a renderer: it answers every scene with the reason.
  explicit SceneRenderer(GlContext& context);

  // What the context says of itself; the name is left empty.
  const RendererInfo& info() const { return info_; }

  // A Rendering with hit counts, or a Failure: `unsupported` with the reason, or `crashed` when the
  // context is lost and the process must start again. With `coverage_only` the pass for pixels is
  // left out, and the rendering has none, nor depths, details and mip chains; fragments are
  // captured, and hits counted, as ever. Supersampled scenes are always drawn in whole.
  Outcome render(const Scene& scene, bool coverage_only = false);

  // How long drawing a scene takes, and nothing else: its vertices are where they need to be, and
  // nothing is read. Clears, draws and finishes until `seconds` have passed, once at least; with
  // `by_draw` it finishes after each draw. A sentence where it cannot be drawn.
  std::variant<DrawingTime, std::string> time_drawing(const Scene& scene, double seconds,
                                                      bool by_draw);

 private:
  // GL objects, in the order in which they may be made. Only there where `problem_` is empty.
  struct Objects {
    Objects(const GladGLContext& gl, GlContext& context, Programs made);
    ProgramCache programs;
    Capture capture;
    Capture detailed_capture;
    Capture textured_capture;
    Targets targets;
    Textures textures;
    Accumulator accumulator;
    GlBuffer vertices;
    GlVertexArray vertex_array;
  };

  // What differs between the passes over a scene.
  struct Pass {
    GlProgram Programs::*program = nullptr;
    bool looks_up = false;       // by the programs for textures
    Capture* capture = nullptr;  // of the passes that capture
    float step = 1;              // of the one that counts hits
    bool finishes = false;       // after each draw
  };

  // Makes programs and framebuffers that a scene needs, or says why there are none.
  std::variant<Surfaces, Failure> prepare(const Scene& scene, bool looks_up);
  // Each pass as a scene of its own, and once more into the accumulator.
  Outcome render_passes(const Scene& scene);
  // What the GL complains of, if anything; it is then forgotten.
  std::optional<Failure> take_failure() const;
  void describe(const GlContext& context);
  void describe_objects();
  // Draws to find out which conventions for provoking vertices have an effect.
  void probe_provoking_vertices();
  void upload(const Scene& scene);
  void set_lookup(const Scene& scene, const Draw& draw);
  void draw_all(const Scene& scene, const Pass& pass);
  void clear_for(const Scene& scene, GLuint framebuffer, const Color& color);
  void draw_pixels(const Scene& scene, const Surfaces& surfaces, Rendering& rendering);
  // Of a multisampled target: resolved, by sample, and its depths and stencils, which stay empty
  // where they are not those of their format.
  void read_samples(const MultisampleTarget& target, Rendering& rendering);
  // What the count's red channel holds.
  std::vector<float> read_sums(const Surfaces& surfaces, const Rendering& rendering);
  void count_hits(const Scene& scene, const Surfaces& surfaces, Rendering& rendering);
  std::optional<std::string> capture_fragments(const Scene& scene, const Surfaces& surfaces,
                                               bool coverage_only, Rendering& rendering);
  // Takes away what the scene does not ask for, and what this driver's GLSL does not have.
  void drop_details(const Scene& scene, Rendering& rendering) const;
  // The levels that the driver made of the scene's textures.
  void tell_mip_chains(const Scene& scene, Rendering& rendering);

  GladGLContext gl_{};
  RendererInfo info_;
  std::string problem_;  // why nothing can be drawn; empty: all is there
  DriverLimits limits_;
  bool queries_level_of_detail_ = false;
  std::optional<Objects> objects_;
};

}  // namespace edgecase
