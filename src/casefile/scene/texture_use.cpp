// SPDX-License-Identifier: MIT
#include "casefile/scene/textures.h"

#include <fmt/format.h>

#include <array>

#include "casefile/json/numbers.h"
#include "casefile/json/schema.h"
#include "casefile/json/text.h"
#include "casefile/scene/forms.h"
#include "model/scene_faults.h"

namespace edgecase {

namespace {

const Keys kLookupKeys{{}, {"lod", "bias", "gradients"}, {}};
constexpr Float32Range kLodRange{-kMaxLod, kMaxLod};
constexpr Float32Range kBiasRange{-kMaxLodBias, kMaxLodBias};
constexpr Float32Range kGradientRange{-kMaxGradient, kMaxGradient};

const Keys& sampler_keys() {
  static const Keys keys = [] {
    Keys all{{}, keys_of<Sampler>(), {}};
    all.optional.insert(all.optional.begin(), "wrap");
    all.optional.push_back("border");
    return all;
  }();
  return keys;
}

// A name for both directions, or [s, t]; `dimensions` 0: unknown.
void read_wrap(const Place& place, int dimensions, Findings& findings, std::array<Wrap, 2>& wrap) {
  if (place.node->kind != JsonKind::array) {
    read_plain(place, "wrap", {}, findings, wrap[0]);
    wrap[1] = wrap[0];
    return;
  }
  if (dimensions == 1) {
    findings.add(place, "a one-dimensional texture wraps along s alone", "write one name");
    return;
  }
  if (place.node->children.size() != 2) {
    findings.add(place, fmt::format("wrap has {} names", place.node->children.size()),
                 "write one name, or [s, t]");
    return;
  }
  for (std::size_t i = 0; i < 2; ++i) read_plain(place.child(i), "wrap", {}, findings, wrap[i]);
}

void read_border(const Place& place, const Texture* texture, Findings& findings,
                 std::array<float, 4>& border) {
  const bool wide = texture == nullptr || holds_floats(texture->format);
  const Float32Range range = wide ? Float32Range{-kMaxTexel, kMaxTexel} : Float32Range{0, 1};
  border = read_color(place, "a border", range, findings).value_or(border);
}

Sampler read_sampler(const Place& place, const Texture* texture, Findings& findings) {
  const std::size_t before = findings.size();
  Sampler sampler;
  const ObjectReader object(place, "a sampler", sampler_keys(), findings);
  if (const auto wrap = object.find("wrap"))
    read_wrap(*wrap, texture != nullptr ? texture->dimensions : 0, findings, sampler.wrap);
  read_fields(object, findings, sampler);
  if (const auto border = object.find("border"))
    read_border(*border, texture, findings, sampler.border);
  if (findings.size() != before) return sampler;
  for (const SceneFault& fault : faults_of(sampler, texture))
    findings.add(place, fault.text, fault.remedy);
  return sampler;
}

// [[ds/dx, dt/dx], [ds/dy, dt/dy]], or [[ds/dx], [ds/dy]] for a one-dimensional texture.
void read_gradients(const Place& place, int dimensions, Findings& findings, Lookup& lookup) {
  if (!expect_kind(place, JsonKind::array, "gradients", findings)) return;
  if (place.node->children.size() != 2) {
    findings.add(place, fmt::format("gradients has {} items", place.node->children.size()),
                 "write [[ds/dx, dt/dx], [ds/dy, dt/dy]]");
    return;
  }
  std::array<float, 2>* const both[] = {&lookup.dx, &lookup.dy};
  for (std::size_t i = 0; i < 2; ++i) {
    const Place item = place.child(i);
    if (dimensions == 1) {
      const auto value =
          read_float32s<1>(item, "a gradient", kGradientRange, Float32Kind::exact, findings);
      if (value) (*both[i])[0] = (*value)[0];
    } else if (dimensions == 2) {
      *both[i] = read_float32s<2>(item, "a gradient", kGradientRange, Float32Kind::exact, findings)
                     .value_or(*both[i]);
    }
  }
}

Lookup read_lookup(const Place& place, int dimensions, Findings& findings) {
  const std::size_t before = findings.size();
  Lookup lookup;
  const ObjectReader object(place, "a lookup", kLookupKeys, findings);
  if (findings.size() != before) return lookup;
  if (place.node->children.size() != 1) {
    findings.add(place, fmt::format("a lookup has {} keys", place.node->children.size()),
                 "write exactly one of " + join_names(kLookupKeys.optional));
    return lookup;
  }
  const Place member = place.child(0);
  parse_name(member.node->name, lookup.kind);
  const auto read_value = [&](Float32Range range) {
    lookup.value =
        read_float32(member, member.node->name, range, Float32Kind::exact, findings).value_or(0);
  };
  switch (lookup.kind) {
    case LookupKind::implicit:  // has no key
      break;
    case LookupKind::bias:
      read_value(kBiasRange);
      break;
    case LookupKind::lod:
      read_value(kLodRange);
      break;
    case LookupKind::gradients:
      read_gradients(member, dimensions, findings, lookup);
      break;
  }
  return lookup;
}

// The texture with a number; nothing, and a finding, if there is none.
std::optional<std::size_t> read_number(const Place& place,
                                       const std::optional<TextureList>& textures,
                                       Findings& findings) {
  const auto number =
      read_integer(place, "texture", {0, static_cast<int>(kMaxTextures) - 1}, findings);
  if (!number || !textures) return std::nullopt;
  const auto index = static_cast<std::size_t>(*number);
  if (index < textures->size()) return index;
  findings.add(place, fmt::format("there is no texture {}", index),
               textures->empty()
                   ? std::string("add \"textures\": [...] beside the target")
                   : fmt::format("the case has textures 0 to {}", textures->size() - 1));
  return std::nullopt;
}

JsonPiece wrap_piece(const std::array<Wrap, 2>& wrap, int dimensions) {
  if (dimensions == 1 || wrap[0] == wrap[1]) return plain_piece(wrap[0]);
  return json_array({plain_piece(wrap[0]), plain_piece(wrap[1])});
}

JsonPiece sampler_piece(const Sampler& sampler, int dimensions) {
  const Sampler standard;
  Pieces members;
  if (sampler.wrap != standard.wrap)
    members.push_back(named("wrap", wrap_piece(sampler.wrap, dimensions)));
  add_fields(sampler, members);
  if (sampler.border != standard.border)
    members.push_back(named("border", color_piece(sampler.border)));
  return json_object(std::move(members));
}

JsonPiece lookup_piece(const Lookup& lookup, int dimensions) {
  const auto only = [&](JsonPiece piece) {
    return json_object({named(name_of(lookup.kind), std::move(piece))});
  };
  switch (lookup.kind) {
    case LookupKind::implicit:  // has no members
      break;
    case LookupKind::bias:
    case LookupKind::lod:
      return only(exact_piece(lookup.value));
    case LookupKind::gradients:
      return only(json_array({uv_piece(lookup.dx, dimensions), uv_piece(lookup.dy, dimensions)}));
  }
  return json_object({});
}

}  // namespace

TextureState read_texture_state(const ObjectReader& state,
                                const std::optional<TextureList>& textures, Findings& findings) {
  TextureState result;
  const auto number = state.find("texture");
  const auto sampler = state.find("sampler");
  const auto lookup = state.find("lookup");
  result.textured = number.has_value();
  if (!number) {
    for (const auto& place : {sampler, lookup})
      if (place)
        findings.add_key(*place,
                         fmt::format("a state has {} without a texture", quote(place->node->name)),
                         "add \"texture\": 0, or remove it");
    return result;
  }
  const auto index = read_number(*number, textures, findings);
  const Texture* texture = index ? (*textures)[*index].get() : nullptr;
  if (texture != nullptr) result.dimensions = texture->dimensions;
  TextureUse use;
  use.texture = index.value_or(0);
  if (sampler) use.sampler = read_sampler(*sampler, texture, findings);
  if (lookup) use.lookup = read_lookup(*lookup, result.dimensions, findings);
  if (index) result.use = use;
  return result;
}

std::vector<JsonPiece> texture_use_pieces(const TextureUse& use, int dimensions) {
  Pieces members{named("texture", integer_piece(static_cast<int>(use.texture)))};
  JsonPiece sampler = sampler_piece(use.sampler, dimensions);
  if (!sampler.children.empty()) members.push_back(named("sampler", std::move(sampler)));
  if (use.lookup.kind != LookupKind::implicit)
    members.push_back(named("lookup", lookup_piece(use.lookup, dimensions)));
  return members;
}

JsonPiece uv_piece(const std::array<float, 2>& coordinates, int dimensions) {
  return exact_list({coordinates.data(), dimensions == 1 ? 1U : 2U});
}

namespace {

constexpr std::string_view kTextureUseSchema = R"json({
  "gradient": {
    "description": "[ds, dt] per pixel, or [ds] of a one-dimensional texture: float32 numbers of \
        magnitude @gradient at most.",
    "type": "array",
    "minItems": 1,
    "maxItems": 2,
    "items": {"$ref": "#/$defs/float32", "minimum": "@least_gradient", "maximum": "@gradient"}
  },
  "lod_number": {
    "description": "A level of detail: a float32 number from @least_lod to @lod.",
    "$ref": "#/$defs/float32",
    "minimum": "@least_lod",
    "maximum": "@lod"
  },
  "bias_number": {
    "description": "What is added to the level of detail: a float32 number from @least_bias to \
        @bias.",
    "$ref": "#/$defs/float32",
    "minimum": "@least_bias",
    "maximum": "@bias"
  },
  "wrap": {
    "description": "What stands beyond 0 to 1: the image again, mirrored by turns, its edge \
        texels, or the border colour.",
    "enum": "@wraps"
  },
  "sampler": {
    "title": "Sampler",
    "description": "How the draw's texture is looked up.",
    "type": "object",
    "additionalProperties": false,
    "properties": {
      "wrap": {
        "title": "Wrap",
        "description": "One name for both directions, or [s, t].",
        "default": "@wrap",
        "if": {"type": "array"},
        "then": {"minItems": 2, "maxItems": 2, "items": {"$ref": "#/$defs/wrap"}},
        "else": {"$ref": "#/$defs/wrap"}
      },
      "@fields": 0,
      "border": {
        "title": "Border",
        "description": "Colour beyond the image, (0, 0, 0, 0) if not said.",
        "$ref": "#/$defs/texel_color"
      }
    }
  },
  "lookup": {
    "title": "Lookup",
    "description": "What the shader gives beside texture coordinates; left out, nothing: the \
        level of detail comes from their derivatives.",
    "type": "object",
    "minProperties": 1,
    "maxProperties": 1,
    "additionalProperties": false,
    "properties": {
      "lod": {
        "title": "Level of detail",
        "description": "textureLod.",
        "$ref": "#/$defs/lod_number"
      },
      "bias": {
        "title": "Bias",
        "description": "texture with a bias.",
        "$ref": "#/$defs/bias_number"
      },
      "gradients": {
        "title": "Gradients",
        "description": "textureGrad: [[ds/dx, dt/dx], [ds/dy, dt/dy]]. Variants and \"y\": \
            \"down\" turn them with the image.",
        "type": "array",
        "minItems": 2,
        "maxItems": 2,
        "items": {"$ref": "#/$defs/gradient"}
      }
    }
  }
})json";

}  // namespace

Pieces texture_use_schemas() {
  return schema_pieces(
      kTextureUseSchema,
      {named("gradient", schema_number(kGradientRange.high)),
       named("least_gradient", schema_number(kGradientRange.low)),
       named("lod", schema_number(kLodRange.high)),
       named("least_lod", schema_number(kLodRange.low)),
       named("bias", schema_number(kBiasRange.high)),
       named("least_bias", schema_number(kBiasRange.low)), named("wraps", schema_names<Wrap>()),
       named("wrap", json_string(name_of(Sampler().wrap[0]))),
       named("fields", json_object(field_schemas<Sampler>()))});
}

}  // namespace edgecase
