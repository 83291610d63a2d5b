// SPDX-License-Identifier: MIT
#include "casefile/scene/scene_reader.h"

#include <fmt/format.h>

#include <algorithm>

#include "casefile/json/numbers.h"
#include "casefile/json/schema.h"
#include "casefile/json/text.h"
#include "casefile/scene/viewport.h"
#include "exact/numeral.h"

namespace edgecase {

namespace {

const Keys kVertexKeys{{}, {"at", "clip", "object", "color", "uv"}, {"attributes"}};

constexpr FixedRange kWindowRange{Fixed::from_integer(-Fixed::kMaxCoordinate),
                                  Fixed::from_integer(Fixed::kMaxCoordinate)};
constexpr FixedRange kDepthRange{Fixed::from_integer(-1), Fixed::from_integer(1)};
constexpr Float32Range kColorRange{-kMaxColor, kMaxColor};
constexpr Float32Range kTextureRange = kColorRange;  // interpolated like colours
constexpr float kMaxObject = 1073741824;             // 2^30
constexpr Float32Range kObjectRange{-kMaxObject, kMaxObject};
constexpr Float32Range kClipRange{-kMaxW, kMaxW};

constexpr const char* kRoundedClip =
    "clip coordinates are rounded to multiples of 2^-30 times the power of two at or below w";
constexpr const char* kRoundedWindow =
    "what the affine transform yields is rounded to the nearest multiples of 1/65536";

void read_w(const Place& place, Findings& findings, Vertex& vertex) {
  const auto w = read_float32(place, "w", {-kMaxW, kMaxW}, Float32Kind::exact, findings);
  if (!w) return;
  if (!(*w > 0))
    findings.add(
        place,
        fmt::format("w is {}: the vertex lies at or behind the eye, and has no place in the "
                    "window",
                    short_decimal(*w)),
        "write a w above 0, or give \"clip\" coordinates");
  else if (*w < kMinW)
    findings.add(
        place, fmt::format("w is {}, out of range", short_decimal(*w)),
        fmt::format("write a number from {} to {}", exact_decimal(kMinW), exact_decimal(kMaxW)));
  else
    vertex.w = *w;
}

// [x, y], [x, y, z] or [x, y, z, w].
void read_position(const Place& place, Findings& findings, VertexFields& fields) {
  if (!expect_kind(place, JsonKind::array, "a vertex's position", findings)) return;
  const std::size_t count = place.node->children.size();
  if (count < 2 || count > 4) {
    findings.add(place, fmt::format("a vertex takes 2 to 4 coordinates, and this has {}", count),
                 "write [x, y], [x, y, z] or [x, y, z, w]");
    return;
  }
  Vertex& vertex = fields.vertex;
  fields.x = place.child(0);
  fields.y = place.child(1);
  vertex.position.x = read_coordinate(*fields.x, "x", kWindowRange, findings).value_or(Fixed());
  vertex.position.y = read_coordinate(*fields.y, "y", kWindowRange, findings).value_or(Fixed());
  if (count > 2) {
    fields.z = place.child(2);
    vertex.z = read_coordinate(*fields.z, "z", kDepthRange, findings).value_or(Fixed());
  }
  if (count > 3) read_w(place.child(3), findings, vertex);
}

// Stores checked and rounded clip coordinates; rounding is noted at `origin`. False, and a finding,
// if they cannot be drawn.
bool set_clip(const ClipPosition& clip, const std::string& subject, const Place& origin,
              Findings& findings, VertexFields& fields) {
  if (const auto fault = find_clip_fault(clip, subject)) {
    findings.add(fields.place, fault->message, fault->remedy);
    return false;
  }
  const ClipPosition rounded = round_to_grid(clip);
  if (rounded != clip) findings.note(origin, kRoundedClip);
  fields.vertex.clip = rounded;
  fields.vertex.w = rounded.w;
  return true;
}

void read_clip(const Place& place, Findings& findings, VertexFields& fields) {
  const auto numbers = read_float32s<4>(place, "clip", kClipRange, Float32Kind::exact, findings);
  if (!numbers) return;
  const auto& [x, y, z, w] = *numbers;
  set_clip({x, y, z, w}, "the vertex", place, findings, fields);
}

void read_object(const Place& place, Findings& findings, VertexFields& fields) {
  fields.object = read_float32s<3>(place, "object", kObjectRange, Float32Kind::nearest, findings)
                      .value_or(Vector{});
}

// Reads the position of a vertex, which is given in exactly one way.
void read_place(const Place& place, const ObjectReader& object, Findings& findings,
                VertexFields& fields) {
  std::vector<Place> given;
  for (const char* name : {"at", "clip", "object"})
    if (const auto member = object.find(name)) given.push_back(*member);
  if (given.empty()) {
    if (object.valid())
      findings.add(place, "a vertex lacks \"at\"",
                   "add \"at\": [x, y], or \"clip\": [x, y, z, w], or \"object\": [x, y, z]");
    return;
  }
  if (given.size() > 1) {
    findings.add(place,
                 fmt::format("a vertex has both \"{}\" and \"{}\"", given[0].node->name,
                             given[1].node->name),
                 "give exactly one of at, clip, object");
    return;
  }
  fields.place = given[0];
  const std::string& name = given[0].node->name;
  if (name == "at") read_position(given[0], findings, fields);
  if (name == "clip") read_clip(given[0], findings, fields);
  if (name == "object") read_object(given[0], findings, fields);
}

void refuse_without_uv(const Place& place, const VertexDefaults& defaults, Findings& findings) {
  findings.add(place, "a vertex of a textured draw lacks \"uv\"",
               defaults.dimensions == 1 ? "add \"uv\": [s]" : "add \"uv\": [s, t]");
}

// [s, t], or [s] for a one-dimensional texture.
void read_texture_coordinates(const Place& place, const ObjectReader& object,
                              const VertexDefaults& defaults, Findings& findings, Vertex& vertex) {
  const auto uv = object.find("uv");
  if (!uv) {
    if (defaults.textured && object.valid()) refuse_without_uv(place, defaults, findings);
    return;
  }
  if (!defaults.textured) {
    findings.add_key(*uv, "a vertex has \"uv\", and its draw no texture",
                     "remove it, or add \"texture\": 0 to the draw's state");
    return;
  }
  if (!expect_kind(*uv, JsonKind::array, "uv", findings) || defaults.dimensions == 0) return;
  if (!expect_count(*uv, "uv", static_cast<std::size_t>(defaults.dimensions), findings)) return;
  for (std::size_t i = 0; i < uv->node->children.size(); ++i)
    vertex.texture_coordinates[i] =
        read_float32(uv->child(i), i == 0 ? "s" : "t", kTextureRange, Float32Kind::exact, findings)
            .value_or(0);
}

// Projects from object space to clip coordinates; false if the vertex cannot be drawn.
bool project(const Transform* transform, Findings& findings, VertexFields& fields) {
  const Vector& object = *fields.object;
  const ClipPosition clip = clip_position(transform ? transform->matrix : kIdentity, object);
  const std::string subject =
      fmt::format("{} ({}, {}, {})", fields.of_mesh ? "the mesh's vertex" : "the vertex",
                  short_decimal(object[0]), short_decimal(object[1]), short_decimal(object[2]));
  return set_clip(clip, subject, transform ? transform->place : fields.place, findings, fields);
}

void move(const Transform& transform, Findings& findings, VertexFields& fields) {
  const auto moved = move_point(fields.vertex.position, transform.affine);
  if (!moved || !moved->point.x.in_coordinate_range() || !moved->point.y.in_coordinate_range()) {
    findings.add(fields.place, "the transform moves the vertex out of range",
                 fmt::format("keep coordinates from -{0} to {0}", Fixed::kMaxCoordinate));
    return;
  }
  if (!moved->exact) findings.note(*transform.affine_place, kRoundedWindow);
  fields.vertex.position = moved->point;
}

}  // namespace

VertexFields read_vertex(const Place& place, const VertexDefaults& defaults, Findings& findings) {
  VertexFields fields;
  fields.place = place;
  if (defaults.color) {
    fields.vertex.color = *defaults.color;
    fields.has_color = true;
  }
  if (place.node->kind == JsonKind::array) {
    read_position(place, findings, fields);
    if (defaults.textured) refuse_without_uv(place, defaults, findings);
    return fields;
  }
  if (place.node->kind != JsonKind::object) {
    findings.add(
        place, fmt::format("a vertex must be an array or an object, not {}", describe(*place.node)),
        "write [x, y] or {\"at\": [x, y]}");
    return fields;
  }
  const ObjectReader object(place, "a vertex", kVertexKeys, findings);
  read_place(place, object, findings, fields);
  read_texture_coordinates(place, object, defaults, findings, fields.vertex);
  if (const auto color = object.find("color")) {
    if (defaults.textured)
      findings.add_key(*color, "a vertex of a textured draw has a colour, and its texture gives it",
                       "remove it");
    fields.vertex.color = read_color(*color, "a vertex's colour", kColorRange, findings)
                              .value_or(fields.vertex.color);
    fields.has_color = true;
  }
  return fields;
}

std::vector<VertexFields> mesh_vertices(const Mesh& mesh, const Place& place,
                                        const VertexDefaults& defaults, Findings& findings) {
  const auto has_uv = [](const MeshVertex& vertex) { return vertex.uv.has_value(); };
  if (defaults.textured && !std::all_of(mesh.begin(), mesh.end(), has_uv)) {
    findings.add(
        place, fmt::format("{}: some corners have no texture coordinates", quote(place.node->text)),
        "give the mesh \"vt\" lines, and its faces corners like 1/1");
    return {};
  }
  std::vector<VertexFields> vertices(mesh.size());
  for (std::size_t i = 0; i < mesh.size(); ++i) {
    VertexFields& fields = vertices[i];
    fields.place = place;
    fields.of_mesh = true;
    fields.object = mesh[i].position;
    if (defaults.textured) {
      fields.vertex.texture_coordinates = *mesh[i].uv;
      if (defaults.dimensions == 1) fields.vertex.texture_coordinates[1] = 0;
      continue;
    }
    const std::optional<Color> color = mesh[i].color ? mesh[i].color : defaults.color;
    fields.has_color = color.has_value();
    if (color) fields.vertex.color = *color;
  }
  return vertices;
}

TransformUse transform_vertices(const Transform* transform, std::vector<VertexFields>& vertices,
                                Findings& findings) {
  TransformUse use;
  for (VertexFields& fields : vertices) {
    if (fields.object) {
      use.matrix = true;
      const bool drawn = project(transform, findings, fields);
      if (!drawn && fields.of_mesh) break;
    } else if (!fields.vertex.clip) {
      use.affine = true;
      if (transform && transform->affine_place) move(*transform, findings, fields);
    }
  }
  return use;
}

namespace {

constexpr std::string_view kVertexSchema = R"json({
  "vertex": {
    "title": "Vertex",
    "description": "[x, y], [x, y, z], [x, y, z, w], or an object with one of \"at\", \"clip\" \
        and \"object\", and \"color\", or \"uv\" where the draw is textured.",
    "if": {"type": "object"},
    "then": {
      "oneOf": [{"required": ["at"]}, {"required": ["clip"]}, {"required": ["object"]}],
      "additionalProperties": false,
      "properties": {
        "at": {"$ref": "#/$defs/position"},
        "clip": {
          "title": "Clip coordinates",
          "description": "[x, y, z, w] as a vertex shader hands them on: float32 numbers, \
              rounded to multiples of 2^-30 times the power of two at or below the largest \
              magnitude among them, which is from @least_w to @largest_w. Outside -w <= x, y, z \
              <= w lines and triangles are clipped, and points dropped.",
          "type": "array",
          "minItems": 4,
          "maxItems": 4,
          "prefixItems": [
            {"title": "x", "$ref": "#/$defs/clip_number"},
            {"title": "y", "$ref": "#/$defs/clip_number"},
            {"title": "z", "$ref": "#/$defs/clip_number"},
            {"title": "w", "$ref": "#/$defs/clip_number"}
          ]
        },
        "object": {
          "title": "Object space",
          "description": "[x, y, z], which the transform's model, view and projection take to \
              clip coordinates, in float32.",
          "$ref": "#/$defs/three"
        },
        "color": {
          "title": "Colour",
          "description": "Colour of this vertex.",
          "$ref": "#/$defs/color"
        },
        "uv": {
          "title": "Texture coordinates",
          "description": "[s, t], or [s] of a one-dimensional texture: float32 numbers of \
              magnitude @largest_uv at most. A texture's lower left corner is (0, 0), its upper \
              right one (1, 1).",
          "type": "array",
          "minItems": 1,
          "maxItems": 2,
          "items": {"$ref": "#/$defs/texture_number"}
        }
      },
      "not": {"required": ["color", "uv"]}
    },
    "else": {"$ref": "#/$defs/position"}
  },
  "position": {
    "title": "Position",
    "description": "x and y in pixels (y up), where the vertex lands; z from -1 (near) to 1 \
        (far) after the division by w; w of the clip coordinates, 1 if not said.",
    "type": "array",
    "minItems": 2,
    "maxItems": 4,
    "prefixItems": [
      {"title": "x", "$ref": "#/$defs/coordinate"},
      {"title": "y", "$ref": "#/$defs/coordinate"},
      {"title": "z", "$ref": "#/$defs/depth"},
      {"title": "w", "$ref": "#/$defs/w"}
    ]
  },
  "depth": {
    "description": "An exact multiple of 1/65536 from -1 (near) to 1 (far), written like a \
        coordinate.",
    "$ref": "#/$defs/coordinate",
    "minimum": -1,
    "maximum": 1
  },
  "w": {
    "description": "A float32 number from @least_w to @largest_w. In window coordinates (clip \
        coordinates before w, from -1 to 1) times w must be float32 numbers, too: a power of two \
        keeps them so.",
    "$ref": "#/$defs/float32",
    "minimum": "@least_w",
    "maximum": "@largest_w"
  },
  "clip_number": {
    "description": "A float32 number of magnitude @largest_w at most.",
    "$ref": "#/$defs/float32",
    "minimum": "@least_clip",
    "maximum": "@largest_w"
  },
  "texture_number": {
    "description": "A float32 number of magnitude @largest_uv at most.",
    "$ref": "#/$defs/float32",
    "minimum": "@least_uv",
    "maximum": "@largest_uv"
  }
})json";

}  // namespace

Pieces vertex_schemas() {
  return schema_pieces(kVertexSchema, {named("least_w", schema_number(kMinW)),
                                       named("largest_w", schema_number(kMaxW)),
                                       named("least_clip", schema_number(-kMaxW)),
                                       named("largest_uv", schema_number(kTextureRange.high)),
                                       named("least_uv", schema_number(kTextureRange.low))});
}

}  // namespace edgecase
