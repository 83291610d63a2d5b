// SPDX-License-Identifier: MIT
//
// The fields of a scene, each defined once: its key in request lines and case files, its member,
// and its range. The wire formats, and the reader and writer of case files, walk over these lists,
// so a new field is a member, a row here, and the code that draws it.
//
// A list's order is that of the keys in a request line, from which a scene's digest is made. Add
// new rows so that lines without them stay unchanged.
#pragma once

#include <functional>
#include <limits>
#include <tuple>
#include <type_traits>
#include <utility>

#include "model/scene.h"

namespace edgecase {

// The range of a field, both ends inclusive, except the lower limit of a width or size.
struct Limits {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
};

template <class Noun, class Value>
struct Field {
  using Type = Value;

  const char* key;  // null: the value's own fields replace it
  Value Noun::*member;
  Limits limits;
  // A request line omits the field if it equals that of a default-constructed noun. Absent values
  // and empty lists are always omitted then.
  bool is_left_out = false;
  // Case files have a special form for it.
  bool is_by_hand = false;
  // Key and readable name in case files, if they differ from `key`.
  const char* case_key = key;
  const char* title = case_key;
  // Title and description in the schema of case files; null if code beside the noun has them.
  // "{low}" and "{high}" in the description stand for the limits.
  const char* label = nullptr;
  const char* description = nullptr;
  bool is_required = false;  // in case files
  // How scene_text tells a value other than the default, which stands for "{}"; null: by its key.
  const char* words = nullptr;

  constexpr Field left_out() const {
    Field other = *this;
    other.is_left_out = true;
    return other;
  }
  constexpr Field by_hand() const {
    Field other = *this;
    other.is_by_hand = true;
    return other;
  }
  constexpr Field called(const char* name) const {
    Field other = *this;
    other.title = name;
    return other;
  }
  constexpr Field about(const char* its_label, const char* its_description) const {
    Field other = *this;
    other.label = its_label;
    other.description = its_description;
    return other;
  }
  constexpr Field told(const char* its_words) const {
    Field other = *this;
    other.words = its_words;
    return other;
  }
  constexpr Field required() const {
    Field other = *this;
    other.is_required = true;
    return other;
  }
  constexpr Field in_cases(const char* name) const {
    Field other = *this;
    other.case_key = other.title = name;
    return other;
  }
};

template <class Noun, class Value>
constexpr Field<Noun, Value> field(const char* key, Value Noun::*member, Limits limits = {}) {
  return {key, member, limits};
}
// Stands for the fields of a member, which replace it.
template <class Noun, class Value>
struct FieldsIn : Field<Noun, Value> {};
template <class Noun, class Value>
constexpr FieldsIn<Noun, Value> fields_in(Value Noun::*member) {
  return {{nullptr, member, {}}};
}

// The primary template, for types without fields.
template <class Noun>
inline constexpr int kFields = 0;

template <class Noun>
concept HasFields = !std::is_same_v<std::remove_cv_t<decltype(kFields<Noun>)>, int>;

// Calls `visit` with each field of a noun, in order.
template <HasFields Noun, class Visit>
constexpr void for_each_field(Visit&& visit) {
  std::apply([&](const auto&... fields) { (visit(fields), ...); }, kFields<Noun>);
}

// Calls `visit(field, part)` with each field of a noun's object, in order: those of a member whose
// fields replace it stand in its place. `part(noun).*field.member` is the value.
template <HasFields Noun, class Visit, class Part = std::identity>
constexpr void for_each_row(Visit&& visit, Part part = {}) {
  for_each_field<Noun>([&](const auto& field) {
    using Own = std::remove_cvref_t<decltype(field)>;
    using Value = typename Own::Type;
    if constexpr (std::is_same_v<Own, FieldsIn<Noun, Value>>)
      for_each_row<Value>(
          visit,
          [ part, member = field.member ](auto& noun) -> auto& { return part(noun).*member; });
    else
      visit(field, part);
  });
}

constexpr int kMaxViewportOnWire = 32768;  // pixels: a side; a corner from the origin
constexpr double kMaxThickness = 64;       // pixels: a line's width, a point's size
constexpr float kMaxLod = 1000;            // largest magnitude of a level of detail
constexpr int kMostLevel = 1000;           // largest base_level and max_level
// 2^24 units span the whole range of a 24-bit depth buffer.
constexpr double kMaxOffset = 16777216;
constexpr Limits kUnitInterval{0, 1};
constexpr Limits kByte{0, 255};

template <>
inline constexpr auto kFields<ClipPosition> =
    std::tuple{field("x", &ClipPosition::x), field("y", &ClipPosition::y),
               field("z", &ClipPosition::z), field("w", &ClipPosition::w)};

template <>
inline constexpr auto kFields<Vertex> =
    std::tuple{field("position", &Vertex::position),
               field("z", &Vertex::z),
               field("color", &Vertex::color),
               field("w", &Vertex::w),
               field("texture_coordinates", &Vertex::texture_coordinates),
               field("clip", &Vertex::clip)};

template <>
inline constexpr auto kFields<DepthRange> = std::tuple{
    field("near", &DepthRange::near, kUnitInterval), field("far", &DepthRange::far, kUnitInterval)};

template <>
inline constexpr auto kFields<Viewport> =
    std::tuple{field("x", &Viewport::x), field("y", &Viewport::y), field("width", &Viewport::width),
               field("height", &Viewport::height)};

template <>
inline constexpr auto kFields<Target> = std::tuple{
    field("width", &Target::width, {1, kMaxTargetSize})
        .required()
        .about("Width", "In pixels, {low} to {high}. Small is good: a person has to read the "
                        "picture."),
    field("height", &Target::height, {1, kMaxTargetSize})
        .required()
        .about("Height", "In pixels, {low} to {high}."),
    field("samples", &Target::samples, {1, kMaxSamples})
        .by_hand()
        .about("Samples", "Samples per pixel, {low} to {high}. With several, the target is "
                          "multisampled: it is a framebuffer object, and textures and derivatives "
                          "are not supported yet."),
    field("sample_positions", &Target::sample_positions),
    field("color", &Target::color)
        .called("a colour format")
        .about("Colour format", "Format of the pixels."),
    field("depth", &Target::depth)
        .left_out()
        .by_hand()
        .called("a depth format")
        .about("Depth format",
               "Format of the depth buffer. Every fragment is written into it unless a "
               "draw's \"depth\" says otherwise."),
    field("stencil", &Target::stencil)
        .left_out()
        .by_hand()
        .called("a stencil format")
        .about("Stencil format", "Format of the stencil buffer. OpenGL has none of \"depth16\" and "
                                 "\"stencil8\" together."),
    field("clear_depth", &Target::clear_depth, kUnitInterval)
        .left_out()
        .about("Clear depth", "What a depth buffer is cleared to: a float32 number from {low} to "
                              "{high}."),
    field("clear_stencil", &Target::clear_stencil, kByte)
        .left_out()
        .about("Clear stencil value", "What a stencil buffer is cleared to, {low} to {high}."),
    field("surface", &Target::surface)
        .called("a surface")
        .about("Surface", "Where pixels land: \"fbo\" is a framebuffer object, \"window\" the "
                          "window system's framebuffer (a pbuffer, or OSMesa's own buffer)."),
    field("clear", &Target::clear, kUnitInterval).called("a clear colour")};

template <>
inline constexpr auto kFields<Multisampling> =
    std::tuple{field("enabled", &Multisampling::enabled)
                   .in_cases("multisample")
                   .about("Multisampling",
                          "Of a target with several samples: false draws as if it had one "
                          "(GL_MULTISAMPLE disabled). The centre of a pixel decides for all its "
                          "samples, and lines are drawn by their diamonds."),
               field("location", &Multisampling::location)
                   .in_cases("attribute_location")
                   .about("Attribute location",
                          "Of a target with several samples, where colours are interpolated, as "
                          "the qualifiers of GLSL say: center, anywhere in the pixel; centroid, "
                          "anywhere in both the pixel and the primitive; sample, at each sample, "
                          "for which the shader then runs."),
               field("min_sample_shading", &Multisampling::min_sample_shading, kUnitInterval)
                   .about("Least share of samples to shade",
                          "Of a target with several samples: the share of them for which the "
                          "shader runs at least (glMinSampleShading), a float32 number from {low} "
                          "to {high}. Left out, GL_SAMPLE_SHADING is disabled."),
               field("mask", &Multisampling::mask).in_cases("sample_mask"),
               field("alpha_to_coverage", &Multisampling::alpha_to_coverage)
                   .about("Alpha to coverage",
                          "Of a target with several samples: the alpha of a fragment says how "
                          "many of its samples are written (GL_SAMPLE_ALPHA_TO_COVERAGE).")};

inline constexpr const char* kAboutFilter =
    "nearest: one texel; linear: the weighted mean of the nearest two along each axis.";

template <>
inline constexpr auto kFields<Sampler> = std::tuple{
    field("wrap", &Sampler::wrap),
    field("magnify", &Sampler::magnify).about("Magnification filter", kAboutFilter),
    field("minify", &Sampler::minify).about("Minification filter", kAboutFilter),
    field("mipmap", &Sampler::mipmap)
        .about("Mip filter", "Where it is minified: the base level alone, the nearest level, or a "
                             "weighted mean of the nearest two. nearest and linear need a whole "
                             "chain."),
    field("lod_bias", &Sampler::lod_bias, {-kMaxLodBias, kMaxLodBias})
        .about("Bias", "What is added to the level of detail: a float32 number from {low} to "
                       "{high}."),
    field("min_lod", &Sampler::min_lod, {-kMaxLod, kMaxLod})
        .about("Least level of detail", "A float32 number from {low} to {high}."),
    field("max_lod", &Sampler::max_lod, {-kMaxLod, kMaxLod})
        .about("Largest level of detail",
               "A float32 number from {low} to {high}, at least min_lod."),
    field("base_level", &Sampler::base_level, {0, kMostLevel})
        .about("Base level", "The level that is looked up as the largest: one of the texture's."),
    field("max_level", &Sampler::max_level, {0, kMostLevel})
        .about("Last level", "At least base_level."),
    field("border", &Sampler::border),
    field("max_anisotropy", &Sampler::max_anisotropy, {1, kMaxAnisotropy})
        .about("Largest anisotropy", "A float32 number from {low} to {high}.")};

template <>
inline constexpr auto kFields<Lookup> =
    std::tuple{field("kind", &Lookup::kind), field("value", &Lookup::value),
               field("dx", &Lookup::dx), field("dy", &Lookup::dy)};

template <>
inline constexpr auto kFields<TextureUse> =
    std::tuple{field("texture", &TextureUse::texture), fields_in(&TextureUse::sampler),
               field("lookup", &TextureUse::lookup)};

// A clamp of more than 1 would leave the depth buffer from any start.
template <>
inline constexpr auto kFields<PolygonOffset> = std::tuple{
    field("factor", &PolygonOffset::factor, {-kMaxOffset, kMaxOffset})
        .about("Factor", "Of the slope: a float32 number from {low} to {high}."),
    field("units", &PolygonOffset::units, {-kMaxOffset, kMaxOffset})
        .about("Units", "Of the least difference: a float32 number from {low} to {high}."),
    field("clamp", &PolygonOffset::clamp, {-1, 1})
        .about("Clamp", "A float32 number from {low} to {high}; 0 is none.")};

template <>
inline constexpr auto kFields<StencilFace> = std::tuple{
    field("test", &StencilFace::function)
        .called("a stencil test")
        .about("Test", "How the reference must compare with the stored value."),
    field("reference", &StencilFace::reference, kByte)
        .about("Reference", "What is compared, and what \"replace\" stores: {low} to {high}."),
    field("read_mask", &StencilFace::read_mask, kByte)
        .about("Read mask", "Which bits are compared, {low} to {high}."),
    field("write_mask", &StencilFace::write_mask, kByte)
        .about("Write mask", "Which bits may change (glStencilMask), {low} to {high}."),
    field("fail", &StencilFace::fail)
        .about("Operation after failure",
               "Where the stencil test fails. incr and decr stop at the largest value "
               "and at 0, the others wrap."),
    field("depth_fail", &StencilFace::depth_fail)
        .about("Operation after failure of the depth test",
               "Where the stencil test passes, and the depth test fails."),
    field("pass", &StencilFace::pass).about("Operation after success", "Where both tests pass.")};

template <>
inline constexpr auto kFields<StencilTest> =
    std::tuple{field("front", &StencilTest::front), field("back", &StencilTest::back)};

template <>
inline constexpr auto kFields<DepthTest> = std::tuple{
    field("test", &DepthTest::function)
        .called("a depth test")
        .about("Test", "How a fragment's depth must compare with the stored one."),
    field("write", &DepthTest::write)
        .about("Write",
               "Whether fragments that pass are written into the depth buffer (glDepthMask).")};

template <>
inline constexpr auto kFields<BlendTerm> =
    std::tuple{field("equation", &BlendTerm::equation)
                   .about("Equation", "How the two products are put together."),
               field("source", &BlendTerm::source)
                   .required()
                   .about("Source factor", "Of the fragment's colour."),
               field("destination", &BlendTerm::destination)
                   .required()
                   .about("Destination factor", "Of the stored colour.")};

template <>
inline constexpr auto kFields<Blending> =
    std::tuple{field("color", &Blending::color), field("alpha", &Blending::alpha),
               field("constant", &Blending::constant, kUnitInterval)};

template <>
inline constexpr auto kFields<FragmentOperations> = std::tuple{
    field("stencil", &FragmentOperations::stencil).told("stencil test").called("a stencil test"),
    field("depth", &FragmentOperations::depth).told("{}").left_out().called("a depth test"),
    field("blend", &FragmentOperations::blending).told("blended").called("a blending"),
    field("color_mask", &FragmentOperations::color_mask)
        .told("mask {}")
        .left_out()
        .called("a colour mask")
        .about("Colour mask", "Which components are written (glColorMask): letters of \"rgba\", in "
                              "this order.")};

template <>
inline constexpr auto kFields<Draw> = std::tuple{
    field("primitive", &Draw::primitive).by_hand().called("a primitive"),
    field("interpolation", &Draw::interpolation)
        .told("{}")
        .about("Interpolation",
               "flat: each primitive has the colour of its provoking vertex; smooth: "
               "colours are interpolated; noperspective: interpolated linearly in "
               "window coordinates. Of a draw with a texture the same of texture "
               "coordinates, and smooth where nothing is said."),
    field("provoking_vertex", &Draw::provoking_vertex)
        .told("{} vertex provokes")
        .called("the provoking vertex")
        .about("Provoking vertex", "Which vertex of a primitive gives it its flat colour."),
    field("line_width", &Draw::line_width, {0, kMaxThickness})
        .told("width {}")
        .about("Line width", "In pixels, above {low}, {high} at most."),
    field("point_size", &Draw::point_size, {0, kMaxThickness})
        .told("size {}")
        .about("Point size", "In pixels, above {low}, {high} at most."),
    field("scissor", &Draw::scissor, {0, kMaxViewportOnWire})
        .told("scissor {}")
        .called("a scissor")
        .about("Scissor",
               "Fragments outside this rectangle are dropped; a size of 0 drops all of them. Left "
               "out, none is dropped."),
    field("multisampling", &Draw::multisampling),
    field("texture", &Draw::texture).told("texture {}").by_hand(),
    field("front_face", &Draw::front_face)
        .told("front faces {}")
        .left_out()
        .called("the front face")
        .about("Front face", "Which way round the vertices of a front-facing polygon run in the "
                             "window, y up, whatever the target's \"y\" says."),
    field("cull", &Draw::cull)
        .told("culled {}")
        .left_out()
        .about("Culled faces", "Which triangles are dropped; lines and points never are."),
    field("polygon_offset", &Draw::polygon_offset)
        .told("offset")
        .called("a polygon offset")
        .about("Polygon offset",
               "Added to the depths of triangles (glPolygonOffsetClamp): factor m + units r, with "
               "m the depth's slope and r the least difference that the depth buffer keeps apart; "
               "where the clamp is not 0, no farther than it. Lines and points are left alone."),
    fields_in(&Draw::operations),
    field("vertices", &Draw::vertices)};

template <>
inline constexpr auto kFields<Details> = std::tuple{field("coordinates", &Details::coordinates),
                                                    field("derivatives", &Details::derivatives),
                                                    field("texture", &Details::texture).by_hand()};

template <>
inline constexpr auto kFields<TextureLevel> =
    std::tuple{field("width", &TextureLevel::width, {1, kMaxTextureSize}),
               field("height", &TextureLevel::height, {1, kMaxTextureSize}),
               field("texels", &TextureLevel::texels)};

template <>
inline constexpr auto kFields<Texture> =
    std::tuple{field("dimensions", &Texture::dimensions, {1, 2}), field("format", &Texture::format),
               field("levels", &Texture::levels), field("generated", &Texture::generated)};

template <>
inline constexpr auto kFields<ShadingPass> =
    std::tuple{field("at", &ShadingPass::at), field("weight", &ShadingPass::weight)};

template <>
inline constexpr auto kFields<Scene> =
    std::tuple{field("target", &Scene::target),
               field("viewport", &Scene::viewport, {1, kMaxViewportOnWire}),
               field("depth_range", &Scene::depth_range).left_out(),
               field("details", &Scene::details).left_out(),
               field("textures", &Scene::textures),
               field("draws", &Scene::draws),
               field("supersampling", &Scene::supersampling)};

}  // namespace edgecase
