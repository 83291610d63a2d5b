// SPDX-License-Identifier: MIT
//
// SceneRenderer: a Scene drawn by an OpenGL context, as a Rendering.
//
// Three passes draw the same primitives with the same state: pixels (colours into RGBA8), hit
// counts (added up by blending, reference/targets.h) and the capture (a record per fragment shader
// invocation, reference/capture.h). Pixels and hit counts go through the fixed-function end of the
// pipeline and the capture does not, so that they check each other: whoever reads the answer
// refuses it where they differ. Where the target has a depth buffer, all three write it, and it is
// read after the first.
//
// It does not transform, clip or judge anything: scenes carry clip coordinates, or window ones of
// which the loader has made sure that their clip coordinates are exact in float32.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "model/renderer.h"
#include "reference/capture.h"
#include "reference/gl_context.h"
#include "reference/gl_objects.h"
#include "reference/programs.h"
#include "reference/targets.h"

namespace edgecase {

class SceneRenderer {
 public:
  // `context` must be current, stay so, and outlive the renderer. A context that lacks what drawing
  // needs still makes a renderer: it answers every scene with the reason.
  explicit SceneRenderer(GlContext& context);

  // What the context says of itself; the name is left empty.
  const RendererInfo& info() const { return info_; }

  // A Rendering with hit counts, or a Failure: `unsupported` with the reason, or `crashed` when the
  // context is lost and the process must start again. With `coverage_only` the pass for pixels is
  // left out, and the rendering has none, nor depths and details; fragments are captured, and hits
  // counted, as ever.
  Outcome render(const Scene& scene, bool coverage_only = false);

 private:
  // GL objects, in the order in which they may be made. Only there where `problem_` is empty.
  struct Objects {
    Objects(const GladGLContext& gl, GlContext& context, Programs made);
    Programs programs;
    Capture capture;
    Capture detailed_capture;
    Targets targets;
    GlBuffer vertices;
    GlVertexArray vertex_array;
  };

  void describe(const GlContext& context);
  // Draws to find out which conventions for provoking vertices have an effect.
  void probe_provoking_vertices();
  // What this driver cannot draw, as a sentence; empty: it can.
  std::string limit_exceeded_by(const Scene& scene) const;
  std::string limit_exceeded_by(const Draw& draw) const;
  void upload(const Scene& scene);
  void draw_all(const Scene& scene, const GlProgram& program);
  void clear_for(const Scene& scene, GLuint framebuffer, const Color& color);
  void draw_pixels(const Scene& scene, const Surfaces& surfaces, Rendering& rendering);
  void count_hits(const Scene& scene, const Surfaces& surfaces, Rendering& rendering);
  std::optional<std::string> capture_fragments(const Scene& scene, const Surfaces& surfaces,
                                               bool detailed, Rendering& rendering);
  // Takes away what the scene does not ask for, and what this driver's GLSL does not have.
  void drop_details(Details asked, Rendering& rendering) const;

  // Why a rendering is not to be relied upon, as a sentence; empty: nothing speaks against it.
  std::string doubt_of(const Rendering& rendering, const Surfaces& surfaces) const;

  GladGLContext gl_{};
  RendererInfo info_;
  std::string problem_;  // why nothing can be drawn; empty: all is there
  int max_size_ = 0;
  int max_viewport_[2] = {0, 0};
  std::array<bool, 2> provoking_{true, true};  // by ProvokingVertex: it has its effect
  std::array<float, 2> line_widths_{1, 1};     // smallest and largest, pixels
  std::array<float, 2> point_sizes_{1, 1};
  std::optional<Objects> objects_;
};

}  // namespace edgecase
