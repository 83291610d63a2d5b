// SPDX-License-Identifier: MIT
#include "reference/fragment_state.h"

#include <algorithm>

#include "reference/gl_api.h"

namespace edgecase {

namespace {

GLenum to_gl(CompareFunction function) {
  switch (function) {
    case CompareFunction::never:
      return GL_NEVER;
    case CompareFunction::less:
      return GL_LESS;
    case CompareFunction::equal:
      return GL_EQUAL;
    case CompareFunction::lequal:
      return GL_LEQUAL;
    case CompareFunction::greater:
      return GL_GREATER;
    case CompareFunction::notequal:
      return GL_NOTEQUAL;
    case CompareFunction::gequal:
      return GL_GEQUAL;
    case CompareFunction::always:
      return GL_ALWAYS;
  }
  return GL_ALWAYS;
}

GLenum to_gl(StencilOperation operation) {
  switch (operation) {
    case StencilOperation::keep:
      return GL_KEEP;
    case StencilOperation::zero:
      return GL_ZERO;
    case StencilOperation::replace:
      return GL_REPLACE;
    case StencilOperation::incr:
      return GL_INCR;
    case StencilOperation::incr_wrap:
      return GL_INCR_WRAP;
    case StencilOperation::decr:
      return GL_DECR;
    case StencilOperation::decr_wrap:
      return GL_DECR_WRAP;
    case StencilOperation::invert:
      return GL_INVERT;
  }
  return GL_KEEP;
}

GLenum to_gl(BlendFactor factor) {
  switch (factor) {
    case BlendFactor::zero:
      return GL_ZERO;
    case BlendFactor::one:
      return GL_ONE;
    case BlendFactor::src_color:
      return GL_SRC_COLOR;
    case BlendFactor::one_minus_src_color:
      return GL_ONE_MINUS_SRC_COLOR;
    case BlendFactor::dst_color:
      return GL_DST_COLOR;
    case BlendFactor::one_minus_dst_color:
      return GL_ONE_MINUS_DST_COLOR;
    case BlendFactor::src_alpha:
      return GL_SRC_ALPHA;
    case BlendFactor::one_minus_src_alpha:
      return GL_ONE_MINUS_SRC_ALPHA;
    case BlendFactor::dst_alpha:
      return GL_DST_ALPHA;
    case BlendFactor::one_minus_dst_alpha:
      return GL_ONE_MINUS_DST_ALPHA;
    case BlendFactor::constant_color:
      return GL_CONSTANT_COLOR;
    case BlendFactor::one_minus_constant_color:
      return GL_ONE_MINUS_CONSTANT_COLOR;
    case BlendFactor::constant_alpha:
      return GL_CONSTANT_ALPHA;
    case BlendFactor::one_minus_constant_alpha:
      return GL_ONE_MINUS_CONSTANT_ALPHA;
    case BlendFactor::src_alpha_saturate:
      return GL_SRC_ALPHA_SATURATE;
  }
  return GL_ONE;
}

GLenum to_gl(BlendEquation equation) {
  switch (equation) {
    case BlendEquation::add:
      return GL_FUNC_ADD;
    case BlendEquation::subtract:
      return GL_FUNC_SUBTRACT;
    case BlendEquation::reverse_subtract:
      return GL_FUNC_REVERSE_SUBTRACT;
    case BlendEquation::min:
      return GL_MIN;
    case BlendEquation::max:
      return GL_MAX;
  }
  return GL_FUNC_ADD;
}

void enable(const GladGLContext& gl, GLenum name, bool on) {
  on ? gl.Enable(name) : gl.Disable(name);
}

void set_stencil_face(const GladGLContext& gl, GLenum which, const StencilFace& face) {
  gl.StencilFuncSeparate(which, to_gl(face.function), face.reference, face.read_mask);
  gl.StencilOpSeparate(which, to_gl(face.fail), to_gl(face.depth_fail), to_gl(face.pass));
  gl.StencilMaskSeparate(which, face.write_mask);
}

// What a draw leaves off is set to its default, too: clears heed masks.

void set_stencil(const GladGLContext& gl, const std::optional<StencilTest>& test) {
  enable(gl, GL_STENCIL_TEST, test.has_value());
  const StencilTest own = test.value_or(StencilTest());
  set_stencil_face(gl, GL_FRONT, own.front);
  set_stencil_face(gl, GL_BACK, own.back);
}

// Without a buffer, the test stays off.
void set_depth_test(const GladGLContext& gl, const DepthTest& test, DepthFormat format) {
  enable(gl, GL_DEPTH_TEST, format != DepthFormat::none);
  gl.DepthFunc(to_gl(test.function));
  gl.DepthMask(test.write ? GL_TRUE : GL_FALSE);
}

void set_blending(const GladGLContext& gl, const std::optional<Blending>& blending) {
  enable(gl, GL_BLEND, blending.has_value());
  const auto& [color, alpha, constant] = blending.value_or(Blending());
  gl.BlendEquationSeparate(to_gl(color.equation), to_gl(alpha.equation));
  gl.BlendFuncSeparate(to_gl(color.source), to_gl(color.destination), to_gl(alpha.source),
                       to_gl(alpha.destination));
  gl.BlendColor(constant[0], constant[1], constant[2], constant[3]);
}

void set_culling(const GladGLContext& gl, const Draw& draw) {
  gl.FrontFace(draw.front_face == FrontFace::ccw ? GL_CCW : GL_CW);
  enable(gl, GL_CULL_FACE, draw.cull != CullMode::none);
  switch (draw.cull) {
    case CullMode::none:
      return;
    case CullMode::front:
      return gl.CullFace(GL_FRONT);
    case CullMode::back:
      return gl.CullFace(GL_BACK);
    case CullMode::front_and_back:
      return gl.CullFace(GL_FRONT_AND_BACK);
  }
}

void set_polygon_offset(const GladGLContext& gl, const std::optional<PolygonOffset>& offset) {
  enable(gl, GL_POLYGON_OFFSET_FILL, offset.has_value());
  const auto [factor, units, clamp] = offset.value_or(PolygonOffset());
  // The clamp persists until the next call of either function.
  if (clamp == 0) return gl.PolygonOffset(factor, units);
  if (gl.PolygonOffsetClamp != nullptr)
    gl.PolygonOffsetClamp(factor, units, clamp);
  else
    gl.PolygonOffsetClampEXT(factor, units, clamp);
}

}  // namespace

bool uses_fragment_state(const Scene& scene) {
  return has_fragment_operations(scene) || scene.depth_range != DepthRange() ||
         std::any_of(scene.draws.begin(), scene.draws.end(), [](const Draw& draw) {
           return draw.front_face != FrontFace::ccw || draw.cull != CullMode::none ||
                  draw.polygon_offset;
         });
}

void set_fragment_state(const GladGLContext& gl, const Scene& scene, const Draw& draw,
                        PassKind kind) {
  set_culling(gl, draw);
  set_polygon_offset(gl, draw.polygon_offset);
  set_depth_range(gl, scene.depth_range.near, scene.depth_range.far);
  const bool captures = kind == PassKind::capture;
  const FragmentOperations& operations = draw.operations;
  set_depth_test(gl, captures ? DepthTest{CompareFunction::always, false} : operations.depth,
                 scene.target.depth);
  set_stencil(gl, captures ? std::nullopt : operations.stencil);
  if (kind == PassKind::hits) return;
  set_blending(gl, captures ? std::nullopt : operations.blending);
  if (captures) return;
  const auto mask = [&](std::size_t i) -> GLboolean { return operations.color_mask[i] ? 1 : 0; };
  gl.ColorMask(mask(0), mask(1), mask(2), mask(3));
}

void reset_fragment_state(const GladGLContext& gl) {
  set_fragment_state(gl, Scene(), Draw(), PassKind::pixels);
}

}  // namespace edgecase
