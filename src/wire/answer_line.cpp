// SPDX-License-Identifier: MIT
#include "wire/answer_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "wire/reading.h"
#include "wire/rendering_json.h"

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
  int primitives;
};

std::array<double, 4> read_color(const json& value, const Path& path) {
  wire::require_array(value, path, 4);
  std::array<double, 4> color{};
  for (std::size_t i = 0; i < 4; ++i) color[i] = wire::read_number(value[i], {path, i});
  return color;
}

Fragment read_fragment(const json& value, const Path& path, const Bounds& bounds) {
  wire::require_object(value, path, {"x", "y", "primitive", "coverage", "depth", "color"});
  const auto read_index = [&](const char* key, int count) {
    return static_cast<int>(
        wire::read_integer(wire::member(value, path, key), {path, key}, 0, count - 1));
  };
  Fragment fragment;
  fragment.x = read_index("x", bounds.width);
  fragment.y = read_index("y", bounds.height);
  fragment.primitive = read_index("primitive", bounds.primitives);
  if (const json* coverage = wire::optional_member(value, "coverage"))
    fragment.coverage = static_cast<std::uint32_t>(wire::read_integer(
        *coverage, {path, "coverage"}, 1, (std::int64_t{1} << bounds.samples) - 1));
  const json* depth = wire::optional_member(value, "depth");
  fragment.has_depth = depth != nullptr;
  if (depth != nullptr) fragment.depth = wire::read_number(*depth, {path, "depth"});
  const json* color = wire::optional_member(value, "color");
  fragment.has_color = color != nullptr;
  if (color != nullptr) fragment.color = read_color(*color, {path, "color"});
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

int count_primitives(const Scene& scene) {
  return static_cast<int>(primitives_of(scene).size());
}

Rendering read_rendering(const json& document, const Path& root, const Scene& scene) {
  Rendering rendering;
  rendering.width = scene.target.width;
  rendering.height = scene.target.height;
  rendering.samples = scene.target.samples;
  const std::size_t area =
      static_cast<std::size_t>(rendering.width) * static_cast<std::size_t>(rendering.height);
  rendering.pixels = read_integers<std::uint8_t>(wire::member(document, root, "pixels"),
                                                 {root, "pixels"}, 4 * area);
  if (const json* hits = wire::optional_member(document, "hits"))
    rendering.hits = read_integers<std::uint32_t>(*hits, {root, "hits"}, area);

  const json& fragments = wire::member(document, root, "fragments");
  const Path at(root, "fragments");
  wire::require_array(fragments, at, fragments.size());
  const Bounds bounds{rendering.width, rendering.height, rendering.samples,
                      count_primitives(scene)};
  if (!fragments.empty() && bounds.primitives == 0)
    throw Refusal("/fragments has elements, but the scene draws nothing");
  rendering.fragments.reserve(fragments.size());
  for (std::size_t i = 0; i < fragments.size(); ++i)
    rendering.fragments.push_back(read_fragment(fragments[i], {at, i}, bounds));
  sort_fragments(rendering);
  if (auto contradiction = contradiction_of_hits(rendering)) throw Refusal(*contradiction);
  return rendering;
}

Answer read_answer(const json& document, const std::string& digest, const Scene& scene) {
  const Path root;
  wire::require_object(document, root,
                       {"digest", "pixels", "fragments", "hits", "renderer", "not_run"});
  const std::string& given =
      wire::read_string(wire::member(document, root, "digest"), {root, "digest"});
  if (given != digest)
    throw Refusal(fmt::format("/digest is \"{}\", an answer to another scene than \"{}\"",
                              wire::excerpt(given, 40), digest));
  Answer answer;
  if (const json* claims = wire::optional_member(document, "renderer"))
    answer.claims = read_claims(*claims, {root, "renderer"});
  const json* reason = wire::optional_member(document, "not_run");
  if (reason == nullptr) {
    answer.outcome = read_rendering(document, root, scene);
    return answer;
  }
  for (const char* key : {"pixels", "fragments", "hits"})
    if (document.contains(key))
      throw Refusal(fmt::format("the line has both \"not_run\" and \"{}\"", key));
  answer.outcome = Failure{FailureKind::unsupported, wire::read_string(*reason, {root, "not_run"})};
  return answer;
}

}  // namespace

std::string answer_line(const std::string& digest, const Rendering& rendering,
                        const RendererInfo* claims) {
  std::string hits;
  if (!rendering.hits.empty()) hits = fmt::format(",\"hits\":[{}]", fmt::join(rendering.hits, ","));
  return fmt::format(R"({{"digest":{},"pixels":{},"fragments":{}{}{}}})", text_of(digest),
                     pixels_json(rendering), fragments_json(rendering), hits,
                     claims_member(claims));
}

std::string refusal_line(const std::string& digest, const std::string& reason,
                         const RendererInfo* claims) {
  return fmt::format(R"({{"digest":{},"not_run":{}{}}})", text_of(digest), text_of(reason),
                     claims_member(claims));
}

std::variant<Answer, WireError> parse_answer(std::string_view line, const std::string& digest,
                                             const Scene& scene) {
  try {
    return read_answer(wire::parse_text(line), digest, scene);
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
