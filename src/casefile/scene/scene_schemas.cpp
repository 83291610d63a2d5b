// SPDX-License-Identifier: MIT
//
// Targets and draws in the schema of case files.
#include <string>
#include <string_view>
#include <vector>

#include "casefile/json/numbers.h"
#include "casefile/json/schema.h"
#include "casefile/mesh/mesh.h"
#include "casefile/scene/forms.h"
#include "casefile/scene/scene_reader.h"
#include "casefile/scene/viewport.h"

namespace edgecase {

namespace {

constexpr std::string_view kTargetSchema = R"json({
  "target": {
    "title": "Target",
    "description": "What is drawn on.",
    "type": "object",
    "required": "@required",
    "additionalProperties": false,
    "properties": {
      "@fields": 0,
      "sample_positions": {
        "title": "Sample positions",
        "description": "Where the samples of every pixel lie, as many points [x, y] as there are \
            samples, by sample index: pixels from the pixel's lower left corner. Left out, they \
            lie wherever the renderer has them. A renderer that cannot place samples does not \
            run the case.",
        "type": "array",
        "minItems": 2,
        "maxItems": "@samples",
        "items": {
          "title": "Sample",
          "description": "[x, y] within the pixel.",
          "type": "array",
          "minItems": 2,
          "maxItems": 2,
          "items": {"$ref": "#/$defs/within_pixel"}
        }
      },
      "supersample": {"$ref": "#/$defs/supersample"},
      "depth_range": {
        "title": "Depth range",
        "description": "[near, far]: window depths of the near and of the far plane \
            (glDepthRange), float32 numbers from 0 to 1, in either order.",
        "type": "array",
        "minItems": 2,
        "maxItems": 2,
        "items": {"$ref": "#/$defs/window_depth"},
        "default": "@depth_range"
      },
      "y": {
        "title": "Direction of y",
        "description": "\"down\": every y of the file (of vertices, clip coordinates, viewport, \
            scissors, sample positions and places of supersampling) is reflected, as where \
            images have their first row on top: window y counts from the target's upper edge \
            downwards, clip y is negated. Triangles then wind the other way round.",
        "enum": ["up", "down"],
        "default": "up"
      },
      "clear": {
        "title": "Clear colour",
        "description": "Colour before anything is drawn. Left out, it is a dark colour derived \
            from the case's id (each of red, green and blue 0 to 63 of 255, alpha 1), so that no \
            two cases share their right answer.",
        "$ref": "#/$defs/clear"
      },
      "viewport": {
        "title": "Viewport",
        "description": "The rectangle onto which clip coordinates are mapped; all vertices must \
            lie strictly inside. It may be smaller or larger than the target, and beside it. \
            Left out, it is the smallest one with power-of-two sizes that holds the target, all \
            vertices and what wide lines and large points cover round them, and keeps every \
            coordinate exact in float32; or, if any vertex is given in clip coordinates or \
            object space, the smallest one at (0, 0) that holds the target.",
        "$ref": "#/$defs/rectangle",
        "properties": {
          "width": {
            "description": "In pixels, 1 to @size; a power of two keeps coordinates exact.",
            "minimum": 1
          },
          "height": {
            "description": "In pixels, 1 to @size; a power of two keeps coordinates exact.",
            "minimum": 1
          }
        }
      }
    }
  },
  "rectangle": {
    "description": "A rectangle of whole pixels, y up.",
    "type": "object",
    "required": ["x", "y", "width", "height"],
    "additionalProperties": false,
    "properties": {
      "x": {
        "title": "Left edge",
        "description": "In whole pixels, -@size to @size.",
        "type": "integer",
        "minimum": "@least",
        "maximum": "@size"
      },
      "y": {
        "title": "Lower edge",
        "description": "In whole pixels, y up, -@size to @size.",
        "type": "integer",
        "minimum": "@least",
        "maximum": "@size"
      },
      "width": {
        "title": "Width",
        "description": "In pixels, 0 to @size.",
        "type": "integer",
        "minimum": 0,
        "maximum": "@size"
      },
      "height": {
        "title": "Height",
        "description": "In pixels, 0 to @size.",
        "type": "integer",
        "minimum": 0,
        "maximum": "@size"
      }
    }
  }
})json";

}  // namespace

Pieces target_schemas() {
  return schema_pieces(kTargetSchema,
                       {named("required", json_strings(required_keys<Target>())),
                        named("fields", json_object(field_schemas<Target>())),
                        named("samples", schema_number(kMaxSamples)),
                        named("depth_range", json_array({exact_piece(DepthRange().near),
                                                         exact_piece(DepthRange().far)})),
                        named("size", schema_number(kMaxViewportSize)),
                        named("least", schema_number(-kMaxViewportSize))});
}

namespace {

constexpr std::string_view kDrawSchema = R"json({
  "draw": {
    "title": "Draw",
    "description": "Some primitives of one kind, drawn with one state.",
    "type": "object",
    "required": ["primitive"],
    "additionalProperties": false,
    "allOf": [
      {"oneOf": [{"required": ["vertices"]}, {"required": ["mesh"]}]},
      {
        "if": {"required": ["mesh"]},
        "then": {
          "properties": {
            "primitive": {"description": "Meshes are made of triangles.", "const": "triangles"}
          }
        }
      },
      {
        "if": {
          "required": ["primitive"],
          "properties": {"primitive": {"description": "Made of lines.", "enum": "@of_lines"}}
        },
        "then": {"properties": {"vertices": {"description": "Two at least.", "minItems": 2}}}
      },
      {
        "if": {
          "required": ["primitive"],
          "properties": {
            "primitive": {"description": "Made of triangles.", "enum": "@of_triangles"}
          }
        },
        "then": {"properties": {"vertices": {"description": "Three at least.", "minItems": 3}}}
      }
    ],
    "properties": {
      "primitive": {
        "title": "Primitive",
        "description": "points takes 1 vertex each, lines 2, triangles 3. Strips, loops and fans \
            share vertices and take 2 (lines) or 3 (triangles) or more.",
        "enum": "@primitives"
      },
      "vertices": {
        "title": "Vertices",
        "description": "In window coordinates: pixels, y up; pixel (0, 0) at the lower left has \
            its centre at (1/2, 1/2). As many as the primitives take.",
        "type": "array",
        "minItems": 1,
        "maxItems": "@vertices",
        "items": {"$ref": "#/$defs/vertex"}
      },
      "mesh": {
        "title": "Mesh",
        "description": "Path of an OBJ file, relative to the case's folder and inside the suite, \
            in place of vertices: its faces, cut into triangles, in object space. Colours are \
            those of its vertices, if they have any, or, where the draw is textured, texture \
            coordinates those of its corners. Normals, groups and materials are left out.",
        "type": "string",
        "minLength": 1,
        "maxLength": "@path",
        "pattern": "^[^/\\u0000-\\u001f\\u007f][^\\u0000-\\u001f\\u007f]*$"
      },
      "transform": {
        "title": "Transform",
        "description": "Of this draw's vertices, in place of the case's own.",
        "$ref": "#/$defs/transform"
      },
      "state": {
        "title": "State",
        "description": "How it is drawn.",
        "type": "object",
        "additionalProperties": false,
        "dependentRequired": {"sampler": ["texture"], "lookup": ["texture"]},
        "properties": {
          "@fields": 0,
          "@multisampling": 0,
          "sample_mask": {
            "title": "Sample mask",
            "description": "Of a target with several samples: bit s lets sample s be covered \
                (glSampleMaski), 0 to 2^samples - 1. Left out, nothing is masked.",
            "type": "integer",
            "minimum": 0,
            "maximum": "@mask"
          },
          "texture": {
            "title": "Texture",
            "description": "Number of the texture, from 0, in which fragments look up their \
                colour. The vertices then have \"uv\" and no colours.",
            "type": "integer",
            "minimum": 0,
            "maximum": "@last_texture"
          },
          "sampler": {"$ref": "#/$defs/sampler"},
          "lookup": {"$ref": "#/$defs/lookup"}
        }
      },
      "color": {
        "title": "Colour",
        "description": "Colour of all vertices that have none of their own. Where neither is \
            given, each primitive (of strips, loops and fans each vertex) gets a bright colour \
            derived from the case's id, clearly different from the one before.",
        "$ref": "#/$defs/color"
      }
    }
  }
})json";

JsonPiece primitives_of_kind(PrimitiveKind kind) {
  std::vector<std::string> names;
  for (const Primitive primitive : values_of<Primitive>())
    if (kind_of(primitive) == kind) names.emplace_back(name_of(primitive));
  return json_strings(names);
}

}  // namespace

Pieces draw_schemas() {
  return schema_pieces(kDrawSchema,
                       {named("primitives", schema_names<Primitive>()),
                        named("path", schema_number(kPathLimits.most)),
                        named("of_lines", primitives_of_kind(PrimitiveKind::line)),
                        named("of_triangles", primitives_of_kind(PrimitiveKind::triangle)),
                        named("vertices", schema_number(kMaxVertices)),
                        named("fields", json_object(field_schemas<Draw>())),
                        named("multisampling", json_object(field_schemas<Multisampling>())),
                        named("mask", schema_number((1U << kMaxSamples) - 1)),
                        named("last_texture", schema_number(kMaxTextures - 1))});
}

}  // namespace edgecase
