// SPDX-License-Identifier: MIT
#include "wire/answer_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <nlohmann/json.hpp>
#include <utility>

#include "wire/answer_planes.h"
#include "wire/fragments.h"
#include "wire/json_values.h"
#include "wire/rendering_json.h"

namespace edgecase {

using nlohmann::json;
using wire::Path;
using wire::Refusal;

namespace {

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
  return ",\"hits\":" + hits_json(rendering);
}

std::string samples_members(const Rendering& rendering) {
  std::string members;
  if (!rendering.sample_positions.empty())
    members += ",\"sample_positions\":" + sample_positions_json(rendering);
  if (!rendering.sample_pixels.empty())
    members += ",\"sample_pixels\":" + sample_pixels_json(rendering);
  return members;
}

std::string depths_member(const Rendering& rendering) {
  return rendering.depths.empty() ? "" : ",\"depths\":" + depths_json(rendering);
}

std::string stencils_member(const Rendering& rendering) {
  return rendering.stencils.empty() ? "" : ",\"stencils\":" + stencils_json(rendering);
}

std::string mip_chains_member(const Rendering& rendering) {
  return rendering.mip_chains.empty() ? "" : ",\"mip_chains\":" + mip_chains_json(rendering);
}

// The number of fragments at each pixel.
std::vector<std::uint32_t> captured_fragments(const Rendering& rendering) {
  std::vector<std::uint32_t> captured(rendering.pixel_index(0, rendering.height));
  for (const Fragment& fragment : rendering.fragments)
    ++captured[rendering.pixel_index(fragment.x, fragment.y)];
  return captured;
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

// A float32 buffer may store a depth that rounding took beyond 0 or 1; an unsigned one cannot.
std::vector<double> read_depths(const json& value, const Path& path, std::size_t size,
                                DepthFormat format) {
  std::vector<double> depths = wire::read_plane<double>(value, path, size);
  if (holds_floats(format)) return depths;
  const auto beyond =
      std::ranges::find_if(depths, [](double depth) { return !(depth >= 0 && depth <= 1); });
  if (beyond == depths.end()) return depths;
  const Path at(path, static_cast<std::size_t>(beyond - depths.begin()));
  throw Refusal(fmt::format("{} is {}, but it must be 0 to 1", at.text(), *beyond));
}

// Reads either the key "coverage", or "pixels" and "fragments".
void read_drawn(const json& document, const Path& root, const Scene& scene, Rendering& rendering) {
  const std::vector<bool> textured = wire::textured_primitives(scene);
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
    wire::read_fragments(list, at, scene, textured, rendering);
}

// Reads what an answer reports about samples, if there are several.
void read_samples(const json& document, const Path& root, std::size_t size, Rendering& rendering) {
  if (const json* positions = wire::optional_member(document, "sample_positions"))
    rendering.sample_positions =
        wire::read_reported_positions(*positions, {root, "sample_positions"}, rendering.samples);
  const json* pixels = wire::optional_member(document, "sample_pixels");
  if (pixels == nullptr) return;
  if (rendering.samples == 1)
    throw Refusal("the line has \"sample_pixels\", but the target has one sample");
  rendering.sample_pixels = wire::read_plane<std::uint8_t>(*pixels, {root, "sample_pixels"}, size);
}

void check_buffers(const json& document, const Path& path, const Scene& scene) {
  if (document.contains("depths") && scene.target.depth == DepthFormat::none)
    throw Refusal(path.text() + " has \"depths\", but the target has no depth buffer");
  if (document.contains("stencils") && scene.target.stencil == StencilFormat::none)
    throw Refusal(path.text() + " has \"stencils\", but the target has no stencil buffer");
}

Rendering blank_rendering(const Target& target) {
  Rendering rendering;
  rendering.width = target.width;
  rendering.height = target.height;
  rendering.samples = target.samples;
  return rendering;
}

std::size_t area_of(const Target& target) {
  return static_cast<std::size_t>(target.width) * static_cast<std::size_t>(target.height);
}

// Reads a single drawing: a scene that is not supersampled, or a pass.
Rendering read_drawing(const json& document, const Path& root, const Scene& scene) {
  Rendering rendering = blank_rendering(scene.target);
  const std::size_t area = area_of(scene.target);
  // Hits, depths and stencils have one plane for each sample.
  const std::size_t planes = area * static_cast<std::size_t>(rendering.samples);
  if (!document.contains("coverage")) {
    rendering.pixels = wire::read_plane<std::uint8_t>(wire::member(document, root, "pixels"),
                                                      {root, "pixels"}, 4 * area);
    if (scene.target.depth != DepthFormat::none)
      rendering.depths = read_depths(wire::member(document, root, "depths"), {root, "depths"},
                                     planes, scene.target.depth);
    if (scene.target.stencil != StencilFormat::none)
      rendering.stencils = wire::read_plane<std::uint8_t>(wire::member(document, root, "stencils"),
                                                          {root, "stencils"}, planes);
  }
  if (const json* hits = wire::optional_member(document, "hits"))
    rendering.hits = wire::read_plane<std::uint32_t>(*hits, {root, "hits"}, planes);
  read_samples(document, root, 4 * planes, rendering);
  if (const json* chains = wire::optional_member(document, "mip_chains"))
    rendering.mip_chains = wire::read_mip_chains(*chains, {root, "mip_chains"}, scene);
  read_drawn(document, root, scene, rendering);
  sort_fragments(rendering);
  return rendering;
}

// A pass has one sample and is always a whole answer.
Rendering read_pass(const json& value, const Path& path, const Scene& scene) {
  wire::require_object(value, path, {"pixels", "fragments", "depths", "mip_chains", "hits"});
  check_buffers(value, path, scene);
  return read_drawing(value, path, scene);
}

// Passes differ from the scene only in positions, which do not matter for reading.
Rendering read_supersampled(const json& document, const Path& root, const Scene& scene) {
  Rendering rendering = blank_rendering(scene.target);
  const std::size_t size = 4 * area_of(scene.target);
  rendering.pixels = wire::read_plane<std::uint8_t>(wire::member(document, root, "pixels"),
                                                    {root, "pixels"}, size);
  rendering.accumulated = wire::read_plane<double>(wire::member(document, root, "accumulated"),
                                                   {root, "accumulated"}, size);
  const json& passes = wire::member(document, root, "passes");
  const Path at(root, "passes");
  wire::require_array(passes, at, scene.supersampling.size());
  for (std::size_t k = 0; k < passes.size(); ++k)
    rendering.passes.push_back(read_pass(passes[k], {at, k}, scene));
  return rendering;
}

Rendering read_rendering(const json& document, const Path& root, const Scene& scene) {
  Rendering rendering = scene.supersampling.empty() ? read_drawing(document, root, scene)
                                                    : read_supersampled(document, root, scene);
  if (document.contains("coverage"))
    check_coverage(rendering, scene);
  else
    check_rendering(rendering, scene);
  return rendering;
}

// In a supersampled scene only passes have fragments and what belongs to them.
void check_supersampled_form(const json& document, bool is_supersampled) {
  for (const char* key : {"passes", "accumulated"})
    if (!is_supersampled && document.contains(key))
      throw Refusal(fmt::format("the line has \"{}\", but the scene is not supersampled", key));
  for (const char* key : {"fragments", "coverage", "depths", "stencils", "mip_chains", "hits",
                          "sample_positions", "sample_pixels"})
    if (is_supersampled && document.contains(key))
      throw Refusal(
          fmt::format("the line has \"{}\" beside the passes of a supersampled scene", key));
}

// Refuses keys that exclude each other, and a form of answer that was not requested.
void check_form(const json& document, const Scene& scene, bool coverage_only) {
  const auto refuse_beside = [&](const char* first, std::initializer_list<const char*> others) {
    if (!document.contains(first)) return;
    for (const char* key : others)
      if (document.contains(key))
        throw Refusal(fmt::format("the line has both \"{}\" and \"{}\"", first, key));
  };
  refuse_beside("not_run", {"pixels", "fragments", "coverage", "depths", "stencils", "mip_chains",
                            "hits", "sample_positions", "sample_pixels", "passes", "accumulated"});
  refuse_beside("coverage", {"pixels", "fragments", "depths", "stencils", "mip_chains",
                             "sample_positions", "sample_pixels"});
  check_supersampled_form(document, !scene.supersampling.empty());
  check_buffers(document, Path(), scene);
  if (!document.contains("coverage")) return;
  if (!coverage_only)
    throw Refusal("the line has \"coverage\", but the request asked for a whole answer");
  if (scene.target.samples != 1)
    throw Refusal("the line has \"coverage\", which cannot tell which samples are covered");
}

Answer read_answer(const json& document, const std::string& digest, const Scene& scene,
                   bool coverage_only) {
  const Path root;
  wire::require_object(
      document, root,
      {"digest", "pixels", "fragments", "coverage", "depths", "stencils", "mip_chains", "hits",
       "sample_positions", "sample_pixels", "passes", "accumulated", "renderer", "not_run"});
  const std::string& given =
      wire::read_string(wire::member(document, root, "digest"), {root, "digest"});
  if (given != digest)
    throw Refusal(fmt::format("/digest is \"{}\", an answer to another scene than \"{}\"",
                              wire::excerpt(given, 40), digest));
  check_form(document, scene, coverage_only);
  Answer answer;
  if (const json* claims = wire::optional_member(document, "renderer"))
    answer.claims = bounded_claims(read_claims(*claims, {root, "renderer"}));
  if (const json* reason = wire::optional_member(document, "not_run"))
    answer.outcome = Failure{FailureKind::unsupported,
                             bounded_text(wire::read_string(*reason, {root, "not_run"}))};
  else
    answer.outcome = read_rendering(document, root, scene);
  return answer;
}

}  // namespace

std::string bounded_text(std::string text) {
  if (text.size() <= kLongestText) return text;
  std::size_t end = kLongestText;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;  // a character
  const std::size_t left = text.size() - end;
  text.resize(end);
  text.shrink_to_fit();
  return text + fmt::format("... ({} bytes more)", left);
}

RendererInfo bounded_claims(RendererInfo claims) {
  if (claims.traits.size() > kMostTraits)
    throw Refusal(fmt::format("a renderer has {} traits, and may have {}", claims.traits.size(),
                              kMostTraits));
  for (std::string* text : {&claims.vendor, &claims.version, &claims.device})
    *text = bounded_text(std::move(*text));
  for (auto& [name, trait] : claims.traits) {
    if (name.size() > kLongestTraitName)
      throw Refusal(fmt::format("the name of a trait has {} bytes, and may have {}", name.size(),
                                kLongestTraitName));
    trait = bounded_text(std::move(trait));
  }
  return claims;
}

std::string answer_line(const std::string& digest, const Rendering& rendering,
                        const RendererInfo* claims) {
  if (!rendering.passes.empty())
    return fmt::format(R"({{"digest":{},"pixels":{},"accumulated":{},"passes":{}{}}})",
                       text_of(digest), pixels_json(rendering), accumulated_json(rendering),
                       passes_json(rendering), claims_member(claims));
  return fmt::format(R"({{"digest":{},"pixels":{},"fragments":{}{}{}{}{}{}{}}})", text_of(digest),
                     pixels_json(rendering), fragments_json(rendering), samples_members(rendering),
                     depths_member(rendering), stencils_member(rendering),
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
    return read_answer(wire::parse_answer_text(line), digest, scene, coverage_only);
  } catch (const std::exception& thrown) {
    return error_of_reading(thrown);
  }
}

std::optional<std::string> contradiction_of_hits(const Rendering& rendering) {
  if (rendering.hits.empty() || rendering.samples != 1) return std::nullopt;
  const std::vector<std::uint32_t> captured = captured_fragments(rendering);
  const auto [hit, fragment] =
      std::mismatch(rendering.hits.begin(), rendering.hits.end(), captured.begin());
  if (hit == rendering.hits.end()) return std::nullopt;
  const auto index = static_cast<int>(hit - rendering.hits.begin());
  return fmt::format(
      "hit counts and fragments contradict each other at pixel ({}, {}): {} against {}",
      index % rendering.width, index / rendering.width, *hit, *fragment);
}

std::optional<std::string> excess_of_hits(const Rendering& rendering) {
  const std::vector<std::uint32_t> captured = captured_fragments(rendering);
  for (std::size_t i = 0; i < rendering.hits.size(); ++i) {
    const std::size_t pixel = i % captured.size();
    if (rendering.hits[i] <= captured[pixel]) continue;
    const std::string sample =
        rendering.samples == 1 ? "" : fmt::format(", sample {}", i / captured.size());
    const auto index = static_cast<int>(pixel);
    return fmt::format("more hits than fragments at pixel ({}, {}){}: {} against {}",
                       index % rendering.width, index / rendering.width, sample, rendering.hits[i],
                       captured[pixel]);
  }
  return std::nullopt;
}

}  // namespace edgecase
