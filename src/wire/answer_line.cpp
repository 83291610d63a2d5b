// SPDX-License-Identifier: MIT
#include "wire/answer_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "wire/coverage_runs.h"
#include "wire/reading.h"
#include "wire/rendering_json.h"
#include "wire/texture_values.h"

namespace edgecase {

using nlohmann::json;
using wire::Path;
using wire::Refusal;

namespace {

constexpr int kMaxSubpixelBits = 32;

std::string text_of(const json& value) {
  return value.dump(-1, ' ', true, json::error_handler_t::replace);
}

std::string claims_json(const RendererInfo& claims) {
  return text_of({{"vendor", claims.vendor},
                  {"version", claims.version},
                  {"device", claims.device},
                  {"subpixel_bits", claims.subpixel_bits},
                  {"traits", claims.traits}});
}

std::string claims_member(const RendererInfo* claims) {
  return claims == nullptr ? "" : ",\"renderer\":" + claims_json(*claims);
}

std::string hits_member(const Rendering& rendering) {
  if (rendering.hits.empty()) return "";
  return fmt::format(",\"hits\":[{}]", fmt::join(rendering.hits, ","));
}

std::string depths_member(const Rendering& rendering) {
  return rendering.depths.empty() ? "" : ",\"depths\":" + depths_json(rendering);
}

std::string mip_chains_member(const Rendering& rendering) {
  return rendering.mip_chains.empty() ? "" : ",\"mip_chains\":" + mip_chains_json(rendering);
}

RendererInfo read_claims(const json& value, const Path& path) {
  wire::require_object(value, path, {"vendor", "version", "device", "subpixel_bits", "traits"});
  RendererInfo claims;
  const auto read_text = [&](const char* key, std::string& text) {
    if (const json* found = wire::optional_member(value, key))
      text = wire::read_string(*found, {path, key});
  };
  read_text("vendor", claims.vendor);
  read_text("version", claims.version);
  read_text("device", claims.device);
  if (const json* bits = wire::optional_member(value, "subpixel_bits"))
    claims.subpixel_bits =
        static_cast<int>(wire::read_integer(*bits, {path, "subpixel_bits"}, 0, kMaxSubpixelBits));
  if (const json* traits = wire::optional_member(value, "traits")) {
    const Path at(path, "traits");
    if (!traits->is_object()) throw Refusal(at.text() + " must be an object of strings");
    for (const auto& [key, trait] : traits->items())
      claims.traits[key] = wire::read_string(trait, {at, key.c_str()});
  }
  return claims;
}

// What the fragments of one scene must keep to.
struct Bounds {
  int width;
  int height;
  int samples;
  std::vector<bool> textured;  // by primitive: is its draw?
  Details details;             // what was asked for
};

template <std::size_t N>
void read_numbers(const json& value, const Path& path, std::array<double, N>& numbers) {
  wire::require_array(value, path, N);
  for (std::size_t i = 0; i < N; ++i) numbers[i] = wire::read_number(value[i], {path, i});
}

void read_derivatives(const json& value, const Path& path, FragmentDetail& detail) {
  wire::require_object(value, path,
                       {kDerivativeNames[0], kDerivativeNames[1], kDerivativeNames[2],
                        kDerivativeNames[3], kDerivativeNames[4], kDerivativeNames[5]});
  for (std::size_t i = 0; i < kDerivatives; ++i) {
    const json* four = wire::optional_member(value, kDerivativeNames[i]);
    if (four == nullptr) continue;
    read_numbers(*four, {path, kDerivativeNames[i]}, detail.derivatives[i]);
    detail.has_derivative[i] = true;
  }
}

// What a fragment tells beside colour and depth; none where it tells nothing of the kind.
std::optional<FragmentDetail> read_detail(const json& value, const Path& path, Details asked,
                                          bool is_textured) {
  const auto find = [&](const char* key, bool is_asked, bool is_there = true) {
    const json* found = wire::optional_member(value, key);
    if (found != nullptr && !is_asked)
      throw Refusal(
          fmt::format("{} has \"{}\", which the request does not ask for", path.text(), key));
    if (found != nullptr && !is_there)
      throw Refusal(fmt::format("{} has \"{}\", but its draw has no texture", path.text(), key));
    return found;
  };
  const json* coordinates = find("coordinates", asked.coordinates);
  const json* derivatives = find("derivatives", asked.derivatives);
  const json* texture = find("texture_coordinates", asked.texture, is_textured);
  const json* level = find("level_of_detail", asked.texture, is_textured);
  if (coordinates == nullptr && derivatives == nullptr && texture == nullptr && level == nullptr)
    return std::nullopt;
  FragmentDetail detail;
  const auto read = [&](const json* found, const char* key, auto& numbers) {
    if (found != nullptr) read_numbers(*found, {path, key}, numbers);
    return found != nullptr;
  };
  detail.has_coordinates = read(coordinates, "coordinates", detail.coordinates);
  detail.has_texture_coordinates = read(texture, "texture_coordinates", detail.texture_coordinates);
  detail.has_level_of_detail = read(level, "level_of_detail", detail.level_of_detail);
  if (derivatives != nullptr) read_derivatives(*derivatives, {path, "derivatives"}, detail);
  return detail;
}

Fragment read_fragment(const json& value, const Path& path, const Bounds& bounds) {
  wire::require_object(value, path,
                       {"x", "y", "primitive", "coverage", "depth", "color", "coordinates",
                        "derivatives", "texture_coordinates", "level_of_detail"});
  const auto read_index = [&](const char* key, int count) {
    return static_cast<int>(
        wire::read_integer(wire::member(value, path, key), {path, key}, 0, count - 1));
  };
  Fragment fragment;
  fragment.x = read_index("x", bounds.width);
  fragment.y = read_index("y", bounds.height);
  fragment.primitive = read_index("primitive", static_cast<int>(bounds.textured.size()));
  if (const json* coverage = wire::optional_member(value, "coverage"))
    fragment.coverage = static_cast<std::uint32_t>(wire::read_integer(
        *coverage, {path, "coverage"}, 1, (std::int64_t{1} << bounds.samples) - 1));
  const json* depth = wire::optional_member(value, "depth");
  fragment.has_depth = depth != nullptr;
  if (depth != nullptr) fragment.depth = wire::read_number(*depth, {path, "depth"});
  const json* color = wire::optional_member(value, "color");
  fragment.has_color = color != nullptr;
  if (color != nullptr) read_numbers(*color, {path, "color"}, fragment.color);
  return fragment;
}

template <class Integer>
std::vector<Integer> read_integers(const json& value, const Path& path, std::size_t size) {
  wire::require_array(value, path, size);
  std::vector<Integer> result;
  result.reserve(size);
  for (std::size_t i = 0; i < size; ++i)
    result.push_back(static_cast<Integer>(
        wire::read_integer(value[i], {path, i}, 0, std::numeric_limits<Integer>::max())));
  return result;
}

std::vector<bool> textured_primitives(const Scene& scene) {
  std::vector<bool> textured;
  for (const ScenePrimitive& primitive : primitives_of(scene))
    textured.push_back(primitive.state->texture.has_value());
  return textured;
}

void read_fragments(const json& value, const Path& path, const Bounds& bounds,
                    Rendering& rendering) {
  wire::require_array(value, path, value.size());
  rendering.fragments.reserve(value.size());
  for (std::size_t i = 0; i < value.size(); ++i) {
    const Path at(path, i);
    Fragment fragment = read_fragment(value[i], at, bounds);
    const bool is_textured = bounds.textured[static_cast<std::size_t>(fragment.primitive)];
    if (const auto detail = read_detail(value[i], at, bounds.details, is_textured)) {
      fragment.detail = static_cast<int>(rendering.details.size());
      rendering.details.push_back(*detail);
    }
    rendering.fragments.push_back(fragment);
  }
}

// A float32 buffer may hold a depth that rounding took beyond 0 or 1; an unsigned one cannot.
std::vector<double> read_depths(const json& value, const Path& path, std::size_t size,
                                DepthFormat format) {
  wire::require_array(value, path, size);
  std::vector<double> depths;
  depths.reserve(size);
  for (std::size_t i = 0; i < size; ++i) {
    const Path at(path, i);
    depths.push_back(wire::read_finite(value[i], at));
    const bool inside = depths.back() >= 0 && depths.back() <= 1;
    if (!inside && format != DepthFormat::depth32f)
      throw Refusal(fmt::format("{} is {}, but it must be 0 to 1", at.text(), value[i].dump()));
  }
  return depths;
}

// Either the key "coverage", or "pixels" and "fragments".
void read_drawn(const json& document, const Path& root, const Scene& scene, Rendering& rendering) {
  const std::vector<bool> textured = textured_primitives(scene);
  const json* coverage = wire::optional_member(document, "coverage");
  const char* key = coverage != nullptr ? "coverage" : "fragments";
  const json& list = coverage != nullptr ? *coverage : wire::member(document, root, key);
  if (!list.empty() && textured.empty())
    throw Refusal(fmt::format("/{} has elements, but the scene draws nothing", key));
  const Path at(root, key);
  if (coverage != nullptr)
    rendering.fragments = wire::read_coverage_runs(
        list, at, {rendering.width, rendering.height, static_cast<int>(textured.size())});
  else
    read_fragments(list, at,
                   {rendering.width, rendering.height, rendering.samples, textured, scene.details},
                   rendering);
}

Rendering read_rendering(const json& document, const Path& root, const Scene& scene) {
  Rendering rendering;
  rendering.width = scene.target.width;
  rendering.height = scene.target.height;
  rendering.samples = scene.target.samples;
  const std::size_t area =
      static_cast<std::size_t>(rendering.width) * static_cast<std::size_t>(rendering.height);
  if (!document.contains("coverage")) {
    rendering.pixels = read_integers<std::uint8_t>(wire::member(document, root, "pixels"),
                                                   {root, "pixels"}, 4 * area);
    if (scene.target.depth != DepthFormat::none)
      rendering.depths = read_depths(wire::member(document, root, "depths"), {root, "depths"}, area,
                                     scene.target.depth);
  }
  if (const json* hits = wire::optional_member(document, "hits"))
    rendering.hits = read_integers<std::uint32_t>(*hits, {root, "hits"}, area);
  if (const json* chains = wire::optional_member(document, "mip_chains"))
    rendering.mip_chains = wire::read_mip_chains(*chains, {root, "mip_chains"}, scene);
  read_drawn(document, root, scene, rendering);
  sort_fragments(rendering);
  if (auto contradiction = contradiction_of_hits(rendering)) throw Refusal(*contradiction);
  return rendering;
}

// Keys that exclude each other, and an answer in a form that was not asked for.
void check_form(const json& document, const Scene& scene, bool coverage_only) {
  const auto refuse_beside = [&](const char* first, std::initializer_list<const char*> others) {
    if (!document.contains(first)) return;
    for (const char* key : others)
      if (document.contains(key))
        throw Refusal(fmt::format("the line has both \"{}\" and \"{}\"", first, key));
  };
  refuse_beside("not_run", {"pixels", "fragments", "coverage", "depths", "mip_chains", "hits"});
  refuse_beside("coverage", {"pixels", "fragments", "depths", "mip_chains"});
  if (document.contains("depths") && scene.target.depth == DepthFormat::none)
    throw Refusal("the line has \"depths\", but the target has no depth buffer");
  if (!document.contains("coverage")) return;
  if (!coverage_only)
    throw Refusal("the line has \"coverage\", but the request asked for a whole answer");
  if (scene.target.samples != 1)
    throw Refusal("the line has \"coverage\", which cannot tell which samples are covered");
}

Answer read_answer(const json& document, const std::string& digest, const Scene& scene,
                   bool coverage_only) {
  const Path root;
  wire::require_object(document, root,
                       {"digest", "pixels", "fragments", "coverage", "depths", "mip_chains", "hits",
                        "renderer", "not_run"});
  const std::string& given =
      wire::read_string(wire::member(document, root, "digest"), {root, "digest"});
  if (given != digest)
    throw Refusal(fmt::format("/digest is \"{}\", an answer to another scene than \"{}\"",
                              wire::excerpt(given, 40), digest));
  check_form(document, scene, coverage_only);
  Answer answer;
  if (const json* claims = wire::optional_member(document, "renderer"))
    answer.claims = read_claims(*claims, {root, "renderer"});
  if (const json* reason = wire::optional_member(document, "not_run"))
    answer.outcome =
        Failure{FailureKind::unsupported, wire::read_string(*reason, {root, "not_run"})};
  else
    answer.outcome = read_rendering(document, root, scene);
  return answer;
}

}  // namespace

std::string answer_line(const std::string& digest, const Rendering& rendering,
                        const RendererInfo* claims) {
  return fmt::format(R"({{"digest":{},"pixels":{},"fragments":{}{}{}{}{}}})", text_of(digest),
                     pixels_json(rendering), fragments_json(rendering), depths_member(rendering),
                     mip_chains_member(rendering), hits_member(rendering), claims_member(claims));
}

std::string coverage_line(const std::string& digest, const Rendering& rendering,
                          const RendererInfo* claims) {
  const std::string hits = contradiction_of_hits(rendering) ? hits_member(rendering) : "";
  return fmt::format(R"({{"digest":{},"coverage":{}{}{}}})", text_of(digest),
                     wire::coverage_runs_json(rendering), hits, claims_member(claims));
}

std::string refusal_line(const std::string& digest, const std::string& reason,
                         const RendererInfo* claims) {
  return fmt::format(R"({{"digest":{},"not_run":{}{}}})", text_of(digest), text_of(reason),
                     claims_member(claims));
}

std::variant<Answer, WireError> parse_answer(std::string_view line, const std::string& digest,
                                             const Scene& scene, bool coverage_only) {
  try {
    return read_answer(wire::parse_text(line), digest, scene, coverage_only);
  } catch (const Refusal& refusal) {
    return WireError{refusal.what()};
  }
}

std::optional<std::string> contradiction_of_hits(const Rendering& rendering) {
  if (rendering.hits.empty()) return std::nullopt;
  std::vector<std::uint32_t> captured(rendering.hits.size());
  for (const Fragment& fragment : rendering.fragments)
    ++captured[rendering.pixel_index(fragment.x, fragment.y)];
  const auto [hit, fragment] =
      std::mismatch(rendering.hits.begin(), rendering.hits.end(), captured.begin());
  if (hit == rendering.hits.end()) return std::nullopt;
  const auto index = static_cast<int>(hit - rendering.hits.begin());
  return fmt::format(
      "hit counts and fragments contradict each other at pixel ({}, {}): {} against {}",
      index % rendering.width, index / rendering.width, *hit, *fragment);
}

}  // namespace edgecase
