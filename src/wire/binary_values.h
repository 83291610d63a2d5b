// SPDX-License-Identifier: MIT
//
// Scenes and renderings as bytes (wire/binary.h): what their members are, in which order. For
// src/wire alone.
#pragma once

#include <memory>

#include "model/renderer.h"
#include "wire/binary.h"

namespace edgecase::wire {

inline void carry(Writer& io, const Fixed& value) {
  const std::int64_t raw = value.raw();
  carry(io, raw);
}
inline void carry(Reader& io, Fixed& value) {
  std::int64_t raw = 0;
  carry(io, raw);
  value = Fixed::from_raw(raw);
}

template <class Io, Of<Point> T>
void carry(Io& io, T& point) {
  carry_all(io, point.x, point.y);
}

template <class Io, Of<ClipPosition> T>
void carry(Io& io, T& clip) {
  carry_all(io, clip.x, clip.y, clip.z, clip.w);
}

template <class Io, Of<Vertex> T>
void carry(Io& io, T& vertex) {
  carry_all(io, vertex.position, vertex.z, vertex.color, vertex.w, vertex.texture_coordinates,
            vertex.clip);
}

template <class Io, Of<DepthRange> T>
void carry(Io& io, T& range) {
  carry_all(io, range.near, range.far);
}

template <class Io, Of<Viewport> T>
void carry(Io& io, T& box) {
  carry_all(io, box.x, box.y, box.width, box.height);
}

template <class Io, Of<Target> T>
void carry(Io& io, T& target) {
  carry_all(io, target.width, target.height, target.samples, target.sample_positions, target.color,
            target.depth, target.stencil, target.surface, target.clear, target.clear_depth,
            target.clear_stencil);
}

template <class Io, Of<Multisampling> T>
void carry(Io& io, T& use) {
  carry_all(io, use.enabled, use.location, use.min_sample_shading, use.mask, use.alpha_to_coverage);
}

template <class Io, Of<Sampler> T>
void carry(Io& io, T& sampler) {
  carry_all(io, sampler.wrap, sampler.magnify, sampler.minify, sampler.mipmap, sampler.lod_bias,
            sampler.min_lod, sampler.max_lod, sampler.base_level, sampler.max_level, sampler.border,
            sampler.max_anisotropy);
}

template <class Io, Of<Lookup> T>
void carry(Io& io, T& lookup) {
  carry_all(io, lookup.kind, lookup.value, lookup.dx, lookup.dy);
}

template <class Io, Of<TextureUse> T>
void carry(Io& io, T& use) {
  carry_all(io, use.texture, use.sampler, use.lookup);
}

template <class Io, Of<PolygonOffset> T>
void carry(Io& io, T& offset) {
  carry_all(io, offset.factor, offset.units, offset.clamp);
}

template <class Io, Of<StencilFace> T>
void carry(Io& io, T& face) {
  carry_all(io, face.function, face.reference, face.read_mask, face.write_mask, face.fail,
            face.depth_fail, face.pass);
}

template <class Io, Of<StencilTest> T>
void carry(Io& io, T& test) {
  carry_all(io, test.front, test.back);
}

template <class Io, Of<DepthTest> T>
void carry(Io& io, T& test) {
  carry_all(io, test.function, test.write);
}

template <class Io, Of<BlendTerm> T>
void carry(Io& io, T& term) {
  carry_all(io, term.equation, term.source, term.destination);
}

template <class Io, Of<Blending> T>
void carry(Io& io, T& blending) {
  carry_all(io, blending.color, blending.alpha, blending.constant);
}

template <class Io, Of<FragmentOperations> T>
void carry(Io& io, T& operations) {
  carry_all(io, operations.stencil, operations.depth, operations.blending, operations.color_mask);
}

template <class Io, Of<Draw> T>
void carry(Io& io, T& draw) {
  carry_all(io, draw.primitive, draw.interpolation, draw.provoking_vertex, draw.line_width,
            draw.point_size, draw.scissor, draw.multisampling, draw.texture, draw.front_face,
            draw.cull, draw.polygon_offset, draw.operations, draw.vertices);
}

template <class Io, Of<Details> T>
void carry(Io& io, T& details) {
  carry_all(io, details.coordinates, details.derivatives, details.texture);
}

template <class Io, Of<TextureLevel> T>
void carry(Io& io, T& level) {
  carry_all(io, level.width, level.height, level.texels);
}

template <class Io, Of<Texture> T>
void carry(Io& io, T& texture) {
  carry_all(io, texture.dimensions, texture.format, texture.levels, texture.generated);
}

inline void carry(Writer& io, const std::shared_ptr<const Texture>& texture) {
  carry(io, *texture);
}
inline void carry(Reader& io, std::shared_ptr<const Texture>& texture) {
  auto read = std::make_shared<Texture>();
  carry(io, *read);
  texture = std::move(read);
}

template <class Io, Of<ShadingPass> T>
void carry(Io& io, T& pass) {
  carry_all(io, pass.at, pass.weight);
}

template <class Io, Of<Scene> T>
void carry(Io& io, T& scene) {
  carry_all(io, scene.target, scene.viewport, scene.depth_range, scene.details, scene.textures,
            scene.draws, scene.supersampling);
}

template <class Io, Of<RendererInfo> T>
void carry(Io& io, T& info) {
  carry_all(io, info.vendor, info.version, info.device, info.subpixel_bits, info.traits);
}

template <class Io, Of<FragmentDetail> T>
void carry(Io& io, T& detail) {
  const auto carry_told = [&](auto& is_told, auto& numbers) {
    carry(io, is_told);
    if (is_told) carry(io, numbers);
  };
  carry_told(detail.has_coordinates, detail.coordinates);
  for (std::size_t i = 0; i < kDerivatives; ++i)
    carry_told(detail.has_derivative[i], detail.derivatives[i]);
  carry_told(detail.has_texture_coordinates, detail.texture_coordinates);
  carry_told(detail.has_level_of_detail, detail.level_of_detail);
}

}  // namespace edgecase::wire
