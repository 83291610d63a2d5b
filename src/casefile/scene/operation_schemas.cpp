// SPDX-License-Identifier: MIT
//
// Tests, blending and masks in the schema of case files.
#include <string>
#include <string_view>
#include <vector>

#include "casefile/json/schema.h"
#include "casefile/scene/field_schema.h"
#include "casefile/scene/fragment_operations.h"

namespace edgecase {

namespace {

constexpr std::string_view kOperationSchema = R"json({
  "compare_function": {
    "description": "How the reference must compare with the stored stencil value, or a \
        fragment's depth with the stored depth.",
    "enum": "@functions"
  },
  "stencil_operation": {
    "description": "What becomes of the stored value: incr and decr stop at 255 and 0, the \
        others wrap.",
    "enum": "@operations"
  },
  "blend_factor": {
    "description": "A factor of blending, as OpenGL has it.",
    "enum": "@factors"
  },
  "depth_test": {
    "title": "Depth test",
    "description": "How a fragment's depth must compare with the stored one: a function's name, \
        \"off\" (neither tested nor written), or an object. Needs a depth buffer, unless it is \
        \"off\".",
    "if": {"type": "string"},
    "then": {"enum": "@functions_or_off"},
    "else": {"type": "object", "additionalProperties": false, "properties": {"@depth_test": 0}},
    "default": "@depth_default"
  },
  "stencil_test": {
    "title": "Stencil test",
    "description": "Of polygons of both facings alike, or of each. Needs a stencil buffer.",
    "if": {"type": "object", "anyOf": [{"required": ["front"]}, {"required": ["back"]}]},
    "then": {
      "additionalProperties": false,
      "properties": {
        "front": {
          "title": "Front face",
          "description": "Of front-facing polygons, points and lines.",
          "$ref": "#/$defs/stencil_face"
        },
        "back": {
          "title": "Back face",
          "description": "Of back-facing polygons.",
          "$ref": "#/$defs/stencil_face"
        }
      }
    },
    "else": {"$ref": "#/$defs/stencil_face"}
  },
  "stencil_face": {
    "title": "Face of a stencil test",
    "description": "The reference is compared with the stored value, both under the read mask; \
        then the stored value is changed, under the write mask.",
    "type": "object",
    "additionalProperties": false,
    "properties": {"@stencil_face": 0}
  },
  "blend": {
    "title": "Blending",
    "description": "What a fragment's colour and the stored one make together: a name, one term \
        for all components, or a term for red, green and blue and one for alpha. \"over\" is \
        {src_alpha, one_minus_src_alpha}, of alpha {one, one_minus_src_alpha}; \
        \"premultiplied-over\" {one, one_minus_src_alpha}; \"add\" {one, one}; \"multiply\" \
        {dst_color, zero}. Left out, fragments replace what is stored.",
    "if": {"type": "string"},
    "then": {"enum": "@presets"},
    "else": {
      "type": "object",
      "if": {"anyOf": [{"required": ["color"]}, {"required": ["alpha"]}]},
      "then": {
        "required": ["color", "alpha"],
        "additionalProperties": false,
        "properties": {
          "color": {
            "title": "Colour",
            "description": "Of red, green and blue.",
            "$ref": "#/$defs/blend_term",
            "unevaluatedProperties": false
          },
          "alpha": {
            "title": "Alpha",
            "description": "Of alpha.",
            "$ref": "#/$defs/blend_term",
            "unevaluatedProperties": false
          },
          "constant": {"$ref": "#/$defs/blend_constant"}
        }
      },
      "else": {
        "$ref": "#/$defs/blend_term",
        "properties": {"constant": {"$ref": "#/$defs/blend_constant"}},
        "unevaluatedProperties": false
      }
    }
  },
  "blend_term": {
    "title": "Term of a blending",
    "description": "An equation, and the factors of the fragment's colour and of the stored one, \
        which min and max do without.",
    "type": "object",
    "if": {
      "required": ["equation"],
      "properties": {
        "equation": {"description": "One without factors.", "enum": "@without_factors"}
      }
    },
    "then": {"not": {"anyOf": [{"required": ["source"]}, {"required": ["destination"]}]}},
    "else": {"required": "@required_factors"},
    "properties": {"@blend_term": 0}
  },
  "blend_constant": {
    "title": "Constant colour",
    "description": "What factors of constant colour and alpha stand for, each component 0 to 1. \
        Left out, it is [0, 0, 0, 0].",
    "$ref": "#/$defs/clear"
  }
})json";

std::vector<std::string> functions_or_off() {
  std::vector<std::string> names = names_of<CompareFunction>();
  names.emplace_back(kDepthOff);
  return names;
}

std::vector<std::string> presets() {
  std::vector<std::string> names;
  for (const BlendPreset& preset : kBlendPresets) names.emplace_back(preset.name);
  return names;
}

std::vector<std::string> without_factors() {
  std::vector<std::string> names;
  for (const BlendEquation equation : values_of<BlendEquation>())
    if (!takes_factors(equation)) names.emplace_back(name_of(equation));
  return names;
}

}  // namespace

Pieces fragment_operation_schemas() {
  return schema_pieces(kOperationSchema,
                       {named("functions", schema_names<CompareFunction>()),
                        named("operations", schema_names<StencilOperation>()),
                        named("factors", schema_names<BlendFactor>()),
                        named("functions_or_off", schema_names(functions_or_off())),
                        named("depth_default", json_string(name_of(DepthTest().function))),
                        named("depth_test", json_object(field_schemas<DepthTest>())),
                        named("stencil_face", json_object(field_schemas<StencilFace>())),
                        named("blend_term", json_object(field_schemas<BlendTerm>())),
                        named("required_factors", schema_names(required_keys<BlendTerm>())),
                        named("presets", schema_names(presets())),
                        named("without_factors", schema_names(without_factors()))});
}

}  // namespace edgecase
