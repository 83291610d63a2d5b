// SPDX-License-Identifier: MIT
//
// Transforms in the schema of case files.
#include <string_view>

#include "casefile/json/schema.h"
#include "casefile/mesh/transform.h"

namespace edgecase {

namespace {

constexpr std::string_view kTransformSchema = R"json({
  "real": {
    "description": "A number of a transform, of magnitude @largest at most, taken to the nearest \
        float32.",
    "$ref": "#/$defs/float32",
    "minimum": "@least",
    "maximum": "@largest"
  },
  "three": {
    "description": "[x, y, z].",
    "type": "array",
    "minItems": 3,
    "maxItems": 3,
    "items": {"$ref": "#/$defs/real"}
  },
  "sixteen": {
    "description": "A 4 x 4 matrix, row by row, that acts on columns.",
    "type": "array",
    "minItems": 16,
    "maxItems": 16,
    "items": {"$ref": "#/$defs/real"}
  },
  "sides": {
    "description": "left, right, bottom and top of the near plane or of the box; near and far \
        are distances from the eye.",
    "type": "object",
    "required": ["left", "right", "bottom", "top", "near", "far"],
    "additionalProperties": false,
    "properties": {
      "left": {"title": "Left", "$ref": "#/$defs/real"},
      "right": {"title": "Right", "$ref": "#/$defs/real"},
      "bottom": {"title": "Bottom", "$ref": "#/$defs/real"},
      "top": {"title": "Top", "$ref": "#/$defs/real"},
      "near": {"title": "Near", "$ref": "#/$defs/real"},
      "far": {"title": "Far", "$ref": "#/$defs/real"}
    }
  },
  "transform": {
    "description": "model, view and projection take vertices in object space, and meshes, to \
        clip coordinates, once, in float32. affine moves vertices in window coordinates.",
    "type": "object",
    "minProperties": 1,
    "additionalProperties": false,
    "properties": {
      "model": {
        "title": "Model",
        "description": "From object to world space.",
        "$ref": "#/$defs/operations"
      },
      "view": {
        "title": "View",
        "description": "From world to eye space: {\"look_at\": ...}, or operations. The eye \
            looks along -z.",
        "if": {"type": "array"},
        "then": {"$ref": "#/$defs/operations"},
        "else": {
          "type": "object",
          "required": ["look_at"],
          "additionalProperties": false,
          "properties": {
            "look_at": {
              "title": "Look at",
              "description": "An eye that looks at the center, with up upwards.",
              "type": "object",
              "required": ["eye", "center", "up"],
              "additionalProperties": false,
              "properties": {
                "eye": {"title": "Eye", "$ref": "#/$defs/three"},
                "center": {"title": "Center", "$ref": "#/$defs/three"},
                "up": {"title": "Up", "$ref": "#/$defs/three"}
              }
            }
          }
        }
      },
      "projection": {
        "title": "Projection",
        "description": "From eye space to clip coordinates; depth from -1 (near) to 1 (far).",
        "type": "object",
        "minProperties": 1,
        "maxProperties": 1,
        "additionalProperties": false,
        "properties": {
          "perspective": {
            "title": "Perspective",
            "description": "A pyramid round -z: its angle from bottom to top, width by height, \
                and the distances of both planes, 0 < near < far.",
            "type": "object",
            "required": ["fov_y_degrees", "aspect", "near", "far"],
            "additionalProperties": false,
            "properties": {
              "fov_y_degrees": {
                "title": "Field of view",
                "description": "In degrees, between 0 and 180.",
                "$ref": "#/$defs/real",
                "exclusiveMinimum": 0,
                "exclusiveMaximum": 180
              },
              "aspect": {
                "title": "Aspect",
                "description": "Width by height.",
                "$ref": "#/$defs/real",
                "exclusiveMinimum": 0
              },
              "near": {
                "title": "Near",
                "description": "Above 0.",
                "$ref": "#/$defs/real",
                "exclusiveMinimum": 0
              },
              "far": {
                "title": "Far",
                "description": "Above near.",
                "$ref": "#/$defs/real",
                "exclusiveMinimum": 0
              }
            }
          },
          "frustum": {
            "title": "Frustum",
            "description": "A pyramid of any shape; 0 < near < far.",
            "$ref": "#/$defs/sides",
            "properties": {"near": {"description": "Above 0.", "exclusiveMinimum": 0}}
          },
          "orthographic": {
            "title": "Orthographic",
            "description": "A box.",
            "$ref": "#/$defs/sides"
          },
          "matrix": {"title": "Matrix", "$ref": "#/$defs/sixteen"}
        }
      },
      "affine": {
        "title": "Affine maps",
        "description": "Of window coordinates, one after the other, the first one first. The \
            result is exact where it is a multiple of 1/65536, else the nearest one.",
        "type": "array",
        "minItems": 1,
        "maxItems": "@operations",
        "items": {"$ref": "#/$defs/affine_map"}
      }
    }
  },
  "operations": {
    "description": "Applied one after the other, the first one first.",
    "type": "array",
    "maxItems": "@operations",
    "items": {
      "title": "Operation",
      "description": "One key.",
      "type": "object",
      "minProperties": 1,
      "maxProperties": 1,
      "additionalProperties": false,
      "properties": {
        "translate": {"title": "Translate", "$ref": "#/$defs/three"},
        "scale": {"title": "Scale", "$ref": "#/$defs/three"},
        "rotate": {
          "title": "Rotate",
          "description": "About an axis through (0, 0, 0), counterclockwise where it points at \
              the viewer.",
          "type": "object",
          "required": ["degrees", "axis"],
          "additionalProperties": false,
          "properties": {
            "degrees": {"title": "Angle", "description": "In degrees.", "$ref": "#/$defs/real"},
            "axis": {
              "title": "Axis",
              "description": "Of any length but 0.",
              "$ref": "#/$defs/three"
            }
          }
        },
        "matrix": {"title": "Matrix", "$ref": "#/$defs/sixteen"}
      }
    }
  }
})json";

}  // namespace

Pieces transform_schemas() {
  return schema_pieces(kTransformSchema, {named("largest", schema_number(kMaxTransformNumber)),
                                          named("least", schema_number(-kMaxTransformNumber)),
                                          named("operations", schema_number(kMaxOperations))});
}

namespace {

constexpr std::string_view kAffineSchema = R"json({
  "factor": {
    "description": "An exact multiple of 1/65536 from -@factor to @factor, written like a \
        coordinate.",
    "$ref": "#/$defs/coordinate",
    "minimum": "@least_factor",
    "maximum": "@factor"
  },
  "shift": {
    "description": "In pixels: an exact multiple of 1/65536 from -@shift to @shift, written like \
        a coordinate.",
    "$ref": "#/$defs/swept"
  },
  "two_factors": {
    "description": "[x, y].",
    "type": "array",
    "minItems": 2,
    "maxItems": 2,
    "items": {"$ref": "#/$defs/factor"}
  },
  "affine_map": {
    "title": "Affine map",
    "description": "One key.",
    "type": "object",
    "minProperties": 1,
    "maxProperties": 1,
    "additionalProperties": false,
    "properties": {
      "translate": {
        "title": "Translate",
        "description": "By [x, y] pixels.",
        "type": "array",
        "minItems": 2,
        "maxItems": 2,
        "items": {"$ref": "#/$defs/shift"}
      },
      "rotate": {
        "title": "Rotate",
        "description": "About (0, 0), counterclockwise where y points up.",
        "type": "object",
        "required": ["degrees"],
        "additionalProperties": false,
        "properties": {
          "degrees": {
            "title": "Angle",
            "description": "In degrees; multiples of 90 are exact.",
            "$ref": "#/$defs/swept"
          }
        }
      },
      "scale": {
        "title": "Scale",
        "description": "Of x and y, about (0, 0).",
        "$ref": "#/$defs/two_factors"
      },
      "shear": {
        "title": "Shear",
        "description": "[p, q]: x' = x + p y, y' = q x + y.",
        "$ref": "#/$defs/two_factors"
      },
      "matrix": {
        "title": "Matrix",
        "description": "[a, b, c, d, e, f]: x' = a x + c y + e, y' = b x + d y + f.",
        "type": "array",
        "minItems": 6,
        "maxItems": 6,
        "prefixItems": [
          {"$ref": "#/$defs/factor"},
          {"$ref": "#/$defs/factor"},
          {"$ref": "#/$defs/factor"},
          {"$ref": "#/$defs/factor"},
          {"$ref": "#/$defs/shift"},
          {"$ref": "#/$defs/shift"}
        ]
      }
    }
  }
})json";

}  // namespace

Pieces affine_schemas() {
  return schema_pieces(kAffineSchema, {named("factor", schema_number(kMaxAffineFactor)),
                                       named("least_factor", schema_number(-kMaxAffineFactor)),
                                       named("shift", schema_number(kMaxAffineShift))});
}

}  // namespace edgecase
