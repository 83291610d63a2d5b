// SPDX-License-Identifier: MIT
//
// Samples and points within a pixel in the schema of case files.
#include <string_view>

#include "casefile/json/schema.h"
#include "casefile/scene/patterns.h"
#include "casefile/scene/samples.h"

namespace edgecase {

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
