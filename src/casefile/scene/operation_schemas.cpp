// SPDX-License-Identifier: MIT
//
// Tests, blending and masks in the schema of case files.
#include <string>
#include <string_view>
#include <vector>

#include "casefile/json/schema.h"
#include "casefile/scene/forms.h"
#include "casefile/scene/fragment_operations.h"
#include "casefile/scene/patterns.h"
#include "casefile/scene/samples.h"

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
                        named("functions_or_off", json_strings(functions_or_off())),
                        named("depth_default", json_string(name_of(DepthTest().function))),
                        named("depth_test", json_object(field_schemas<DepthTest>())),
                        named("stencil_face", json_object(field_schemas<StencilFace>())),
                        named("blend_term", json_object(field_schemas<BlendTerm>())),
                        named("required_factors", json_strings(required_keys<BlendTerm>())),
                        named("presets", json_strings(presets())),
                        named("without_factors", json_strings(without_factors()))});
}

// Samples and points within a pixel in the schema of case files.

namespace {

constexpr std::string_view kSampleSchema = R"json({
  "within_pixel": {
    "description": "An exact multiple of 1/65536 from 0 to below 1, written like a coordinate.",
    "$ref": "#/$defs/coordinate",
    "minimum": 0,
    "exclusiveMaximum": 1
  },
  "supersample": {
    "title": "Supersampling",
    "description": "Where every pixel is shaded, and how much each place counts: the image is \
        the weighted mean of as many passes, each of them the scene moved and drawn to a target \
        of one sample. Exactly one pattern of places; @passes passes at most. The target has one \
        sample, and the case no drawings.",
    "type": "object",
    "additionalProperties": false,
    "oneOf": [
      {"required": ["grid"]},
      {"required": ["jittered", "seed"]},
      {"required": ["n-rooks", "seed"]},
      {"required": ["random", "seed"]},
      {"required": ["samples"]}
    ],
    "dependentSchemas": {
      "grid": {"not": {"required": ["seed"]}},
      "samples": {"not": {"required": ["seed"]}},
      "weights": {
        "required": ["samples"],
        "not": {"anyOf": [{"required": ["kernel"]}, {"required": ["radius"]}]}
      },
      "jittered": {
        "not": {
          "anyOf": [
            {"required": ["grid"]},
            {"required": ["n-rooks"]},
            {"required": ["random"]},
            {"required": ["samples"]}
          ]
        }
      },
      "n-rooks": {
        "not": {
          "anyOf": [
            {"required": ["grid"]},
            {"required": ["random"]},
            {"required": ["samples"]}
          ]
        }
      },
      "random": {"not": {"anyOf": [{"required": ["grid"]}, {"required": ["samples"]}]}}
    },
    "properties": {
      "grid": {
        "title": "Grid",
        "description": "n: the centres of n x n cells, row by row from the bottom left, each \
            taken to the nearest multiple of 1/65536.",
        "type": "integer",
        "minimum": 1,
        "maximum": "@side"
      },
      "jittered": {
        "title": "Jittered",
        "description": "n: one place at random in each of n x n cells, row by row from the \
            bottom left.",
        "type": "integer",
        "minimum": 1,
        "maximum": "@side"
      },
      "n-rooks": {
        "title": "N rooks",
        "description": "n: as many places, one in each row and each column of n x n cells, at \
            random in its cell; from the left.",
        "type": "integer",
        "minimum": 1,
        "maximum": "@passes"
      },
      "random": {
        "title": "Random",
        "description": "n: as many places, each at random in the pixel.",
        "type": "integer",
        "minimum": 1,
        "maximum": "@passes"
      },
      "samples": {
        "title": "Samples",
        "description": "The places themselves, [x, y] in pixels from the pixel's lower left \
            corner; 0 to below 1 where there is a kernel or a radius.",
        "type": "array",
        "minItems": 1,
        "maxItems": "@passes",
        "items": {
          "title": "Place",
          "description": "[x, y].",
          "type": "array",
          "minItems": 2,
          "maxItems": 2,
          "items": {"$ref": "#/$defs/round_pixel"}
        }
      },
      "seed": {
        "title": "Seed",
        "description": "Which places at random (SplitMix64): the same on every machine.",
        "type": "integer",
        "minimum": 0,
        "maximum": "@seed"
      },
      "weights": {
        "title": "Weights",
        "description": "Of listed samples, a whole number for each; the image is over their sum. \
            Left out, all are 1.",
        "type": "array",
        "minItems": 1,
        "maxItems": "@passes",
        "items": {
          "title": "Weight",
          "description": "How much the place counts.",
          "type": "integer",
          "minimum": 1,
          "maximum": "@weight"
        }
      },
      "kernel": {
        "title": "Kernel",
        "description": "The weight of a place at distances dx and dy from the pixel's centre, a \
            product of one for each: box, 1; tent, 1 - |d|/r; gaussian, exp(-d^2 / (2 (r/2)^2)), \
            with r the radius. In units of 2^-16, rounded to the nearest.",
        "enum": "@kernels",
        "default": "@kernel"
      },
      "radius": {
        "title": "Radius",
        "description": "In pixels: places farther away from the pixel's centre along x or y are \
            left out. Above 1/2, the pattern is repeated in the eight pixels round the pixel. \
            Left out, 1/2 of a box and 1 of other kernels.",
        "$ref": "#/$defs/coordinate",
        "exclusiveMinimum": 0,
        "maximum": "@radius"
      }
    }
  },
  "round_pixel": {
    "description": "An exact multiple of 1/65536 from @low to @high, written like a coordinate.",
    "$ref": "#/$defs/coordinate",
    "minimum": "@low",
    "maximum": "@high"
  }
})json";

}  // namespace

Pieces sample_schemas() {
  return schema_pieces(
      kSampleSchema,
      {named("passes", schema_number(kMaxPasses)), named("side", schema_number(kMaxSide)),
       named("seed", schema_number(kMaxSeed)), named("weight", schema_number(kMaxPassWeight)),
       named("kernels", schema_names<Kernel>()), named("kernel", json_string(name_of(Kernel::box))),
       named("radius", schema_number(kMaxRadius.to_double())),
       named("low", schema_number(kLeastPlace)), named("high", schema_number(kLargestPlace))});
}

}  // namespace edgecase
