// SPDX-License-Identifier: MIT
#include "casefile/case_reader.h"

#include <algorithm>
#include <iterator>
#include <string_view>
#include <utility>
#include <vector>

#include "casefile/json/schema.h"
#include "casefile/mesh/mesh.h"
#include "casefile/mesh/transform.h"
#include "casefile/scene/forms.h"
#include "casefile/scene/fragment_operations.h"
#include "casefile/scene/samples.h"
#include "casefile/sweep/sweep.h"
#include "casefile/sweep/variants.h"
#include "model/policy.h"

namespace edgecase {

namespace {

constexpr std::string_view kExpectSchema = R"json({
  "expect": {
    "title": "Expectation",
    "description": "Which pixels must be hit under a policy, drawn here or in a file; of a \
        target with several samples, which samples must be covered.",
    "type": "object",
    "additionalProperties": false,
    "oneOf": [
      {"required": ["coverage"]},
      {"required": ["coverage_file"]},
      {"required": ["masks"]}
    ],
    "properties": {
      "policy": {
        "title": "Policy",
        "description": "Name of the policy under which the drawing holds.",
        "type": "string",
        "minLength": 1,
        "maxLength": "@name",
        "pattern": "^[^\\u0000-\\u001f\\u007f]*$",
        "default": "@policy"
      },
      "when": {
        "title": "When",
        "description": "For which cases the drawing holds: axes and their values; other axes \
            have any value. \"variant\" names an image (\"reverse\", \"winding\", \"octant=3\", \
            \"translate=3,2\"), else the drawing holds without variants. Left out, it holds for \
            the base case without variants.",
        "type": "object",
        "minProperties": 1,
        "properties": {
          "variant": {
            "title": "Variant",
            "description": "The part of an id that names an image.",
            "type": "string",
            "pattern": "^(reverse|winding|octant=[1-7]|translate=3,2)$"
          }
        },
        "propertyNames": {"pattern": "^[a-z][a-z0-9-]*$"},
        "additionalProperties": {"$ref": "#/$defs/value_name"}
      },
      "coverage": {
        "title": "Coverage",
        "description": "One string per row, the top row first, as wide as the target: . for no \
            hit, # for one, 2 to 9 for as many.",
        "type": "array",
        "minItems": 1,
        "maxItems": "@side",
        "items": {
          "title": "Row",
          "description": "One row of pixels.",
          "type": "string",
          "minLength": 1,
          "maxLength": "@side",
          "pattern": "^[.#2-9]+$"
        }
      },
      "coverage_file": {
        "title": "Coverage file",
        "description": "Path of a text file with the same rows, relative to the case's folder \
            and inside it.",
        "type": "string",
        "minLength": 1,
        "pattern": "^(?!/|\\.\\./).+$"
      },
      "masks": {
        "title": "Masks",
        "description": "Of one primitive on a target with several samples. One string per row, \
            the top row first, with a cell for each pixel of the target, separated by blanks: . \
            where no sample is covered, else a mask in hexadecimal digits, bit s for sample s.",
        "type": "array",
        "minItems": 1,
        "maxItems": "@side",
        "items": {
          "title": "Row",
          "description": "One row of pixels.",
          "type": "string",
          "pattern": "^ *(\\.|(?!0+( |$))[0-9a-fA-F]{1,4})( +(\\.|(?!0+( |$))[0-9a-fA-F]{1,4}))* \
              *$"
        }
      }
    }
  }
})json";

constexpr std::string_view kCaseSchema = R"json({
  "$schema": "https://json-schema.org/draft/2020-12/schema",
  "title": "Edgecase case file",
  "description": "One scene that holds a rasterizer against the rules of OpenGL, and what it \
      should draw. One file, one issue. The program's own loader checks what a schema cannot: \
      keys that stand twice, the sum of all vertices, widths and heights of drawings, whether \
      samples suit what is said of them, how many passes supersampling makes and where they move \
      vertices, files beside the case, the order of magnitude of strings, where the pointers of \
      a sweep lead and how many cases it makes (each is checked like a file of its own), that \
      OpenGL's float32 numbers can hold every coordinate exactly, that vertices lie inside the \
      clip volume, what meshes and image files hold, and whether a sampler and texture \
      coordinates suit their texture.",
  "type": "object",
  "required": "@required",
  "additionalProperties": false,
  "properties": {
    "$schema": {
      "title": "Schema",
      "description": "Path of this schema, so that editors offer help: \"../case.schema.json\".",
      "type": "string",
      "maxLength": "@text",
      "pattern": "^[^\\u0000-\\u001f\\u007f]*$"
    },
    "title": {
      "title": "Title",
      "description": "What the case is about, in one line of 1 to @word characters. No two cases \
          share one.",
      "type": "string",
      "minLength": 1,
      "maxLength": "@word",
      "pattern": "^[^\\u0000-\\u001f\\u007f]*$"
    },
    "why": {
      "title": "Why",
      "description": "Why this must come out as it does: the reasoning, for a person who sees \
          the case fail.",
      "type": "string",
      "maxLength": "@text",
      "pattern": "^[^\\u0000-\\u0008\\u000b-\\u001f\\u007f]*$"
    },
    "rules": {
      "title": "Rules",
      "description": "Ids of the rules that the case is about, for example \
          \"line.diamond-exit\"; `edgecase rules` lists them.",
      "type": "array",
      "minItems": 1,
      "uniqueItems": true,
      "items": {
        "title": "Rule",
        "description": "Id of a rule.",
        "type": "string",
        "maxLength": "@word",
        "pattern": "^[a-z0-9]+(\\.[a-z0-9-]+)+$"
      }
    },
    "spec": {
      "title": "Specification",
      "description": "Where the specification says so: \"GL 4.6 core, 14.6.1\".",
      "type": "string",
      "maxLength": "@text",
      "pattern": "^[^\\u0000-\\u001f\\u007f]*$"
    },
    "origin": {
      "title": "Origin",
      "description": "A link to the bug or discussion that led to the case.",
      "type": "string",
      "maxLength": "@text",
      "pattern": "^https?://[^\\u0000-\\u0020\\u007f]+$"
    },
    "invariant": {
      "title": "Invariant",
      "description": "Whether images of the scene are drawn, too, which must be alike: moved, with its colours masked, cut by the scissor test, behind others, and once more (ruling 67).",
      "type": "boolean"
    },
    "tags": {
      "title": "Tags",
      "description": "Words to select cases by.",
      "type": "array",
      "uniqueItems": true,
      "items": {
        "title": "Tag",
        "description": "Lower-case letters, digits and dashes.",
        "type": "string",
        "maxLength": "@word",
        "pattern": "^[a-z0-9-]+$"
      }
    },
    "target": {"$ref": "#/$defs/target"},
    "details": {
      "title": "Details",
      "description": "What is asked of every fragment beside its colour and depth: \
          \"coordinates\", gl_FragCoord; \"derivatives\", dFdx and dFdy of the colour and their \
          fine and coarse forms.",
      "type": "array",
      "minItems": 1,
      "uniqueItems": true,
      "items": {"title": "Detail", "description": "What is asked for.", "enum": "@details"}
    },
    "transform": {
      "title": "Transform",
      "description": "Of all draws that have no transform of their own.",
      "$ref": "#/$defs/transform"
    },
    "textures": {
      "title": "Textures",
      "description": "Images that draws look up, numbered from 0.",
      "type": "array",
      "minItems": 1,
      "maxItems": "@textures",
      "items": {"$ref": "#/$defs/texture"}
    },
    "draws": {
      "title": "Draws",
      "description": "What is drawn, in this order; at most @vertices vertices over all draws. \
          Primitives are numbered from 0 over all of them.",
      "type": "array",
      "minItems": 1,
      "maxItems": "@draws",
      "items": {"$ref": "#/$defs/draw"}
    },
    "expect": {
      "title": "Expectations",
      "description": "Your own truth, drawn by hand, of what the exact side must cover; never \
          what OpenGL is seen to do.",
      "type": "array",
      "items": {"$ref": "#/$defs/expect"}
    },
    "sweep": {
      "title": "Sweep",
      "description": "Named axes of values: the file stands for a case of every combination, \
          with :AXIS=VALUE added to its id for every axis in this order. Axes multiply, except \
          those of one zip group; @cases cases a file at most, variants included.",
      "type": "object",
      "minProperties": 1,
      "propertyNames": {"$ref": "#/$defs/axis_name"},
      "additionalProperties": {"$ref": "#/$defs/axis"}
    },
    "variants": {
      "title": "Variants",
      "description": "Images of each case, with their name added to its id. reverse: the \
          vertices of each draw in reverse order, of separate primitives each within itself, of \
          fans all but the hub. winding: second and third vertex of each separate triangle \
          exchanged. octants: the seven other images under mirrors and transposition about the \
          target's centre (octant=1 to octant=7: 1 mirrors x, 2 mirrors y, 4 then exchanges x \
          and y). translate: moved by (3, 2) pixels, the target as much larger (translate=3,2).",
      "type": "array",
      "minItems": 1,
      "uniqueItems": true,
      "items": {"title": "Variant", "description": "Name of a variant.", "enum": "@variants"}
    }
  },
  "$defs": {"@definitions": 0}
})json";

Pieces expectation_schemas() {
  return schema_pieces(kExpectSchema, {named("side", schema_number(kMaxTargetSize)),
                                       named("policy", json_string(Policy().name)),
                                       named("name", schema_number(kNameLimits.most))});
}

// In the order of their users.
Pieces definitions() {
  Pieces all;
  for (Pieces part :
       {target_schemas(), draw_schemas(), vertex_schemas(), sample_schemas(), texture_schemas(),
        texture_use_schemas(), fragment_operation_schemas(), transform_schemas(), affine_schemas(),
        sweep_schemas(), expectation_schemas(), number_schemas()})
    std::ranges::move(part, std::back_inserter(all));
  return all;
}

}  // namespace

std::string case_schema() {
  std::vector<std::string> details;
  for_each_form<Details>(
      [&](const auto& field, const auto&) { details.emplace_back(field.case_key); });
  return lay_out(json_object(schema_pieces(
      kCaseSchema,
      {named("required", json_strings(case_keys().required)),
       named("text", schema_number(TextLimits().most)),
       named("word", schema_number(kWordLimits.most)), named("details", json_strings(details)),
       named("textures", schema_number(kMaxTextures)), named("draws", schema_number(kMaxDraws)),
       named("vertices", schema_number(kMaxVertices)), named("cases", schema_number(kMaxCases)),
       named("variants", json_strings(variant_names())),
       named("definitions", json_object(definitions()))})));
}

}  // namespace edgecase
