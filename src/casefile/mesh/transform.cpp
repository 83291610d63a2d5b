// SPDX-License-Identifier: MIT
#include "casefile/mesh/transform.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <utility>

#include "casefile/json/numbers.h"
#include "casefile/json/text.h"

namespace edgecase {

namespace {

glm::mat4 to_glm(const Matrix& matrix) {
  return glm::make_mat4(matrix.data());
}

glm::vec3 to_glm(const Vector& vector) {
  return glm::make_vec3(vector.data());
}

Matrix from_glm(const glm::mat4& matrix) {
  Matrix result;
  std::copy_n(glm::value_ptr(matrix), result.size(), result.begin());
  return result;
}

constexpr float kOne = 1;  // GLM takes the identity as a number on the diagonal

}  // namespace

Matrix product(const Matrix& after, const Matrix& before) {
  return from_glm(to_glm(after) * to_glm(before));
}

namespace {

Matrix translation(const Vector& by) {
  return from_glm(glm::translate(glm::mat4(kOne), to_glm(by)));
}

}  // namespace

Matrix scaling(const Vector& by) {
  return from_glm(glm::scale(glm::mat4(kOne), to_glm(by)));
}

Matrix rotation(float degrees, const Vector& axis) {
  return from_glm(glm::rotate(glm::mat4(kOne), glm::radians(degrees), to_glm(axis)));
}

Matrix look_at(const Vector& eye, const Vector& center, const Vector& up) {
  return from_glm(glm::lookAtRH(to_glm(eye), to_glm(center), to_glm(up)));
}

Matrix perspective(float fov_y_degrees, float aspect, float near, float far) {
  return from_glm(glm::perspectiveRH_NO(glm::radians(fov_y_degrees), aspect, near, far));
}

Matrix frustum(const Sides& sides) {
  return from_glm(
      glm::frustumRH_NO(sides.left, sides.right, sides.bottom, sides.top, sides.near, sides.far));
}

Matrix orthographic(const Sides& sides) {
  return from_glm(
      glm::orthoRH_NO(sides.left, sides.right, sides.bottom, sides.top, sides.near, sides.far));
}

bool is_finite(const Matrix& matrix) {
  return std::all_of(matrix.begin(), matrix.end(),
                     [](float value) { return std::isfinite(value); });
}

ClipPosition clip_position(const Matrix& matrix, const Vector& object) {
  const glm::vec4 clip = to_glm(matrix) * glm::vec4(to_glm(object), kOne);
  return {clip.x, clip.y, clip.z, clip.w};
}

namespace {

const Keys kTransformKeys{{}, {"model", "view", "projection", "affine"}, {}};
const Keys kOperationKeys{{}, {"translate", "rotate", "scale", "matrix"}, {}};
const Keys kRotateKeys{{"degrees", "axis"}, {}, {}};
const Keys kLookAtKeys{{"eye", "center", "up"}, {}, {}};
const Keys kViewKeys{{"look_at"}, {}, {}};
const Keys kProjectionKeys{{}, {"perspective", "frustum", "orthographic", "matrix"}, {}};
const Keys kPerspectiveKeys{{"fov_y_degrees", "aspect", "near", "far"}, {}, {}};
const Keys kSidesKeys{{"left", "right", "bottom", "top", "near", "far"}, {}, {}};

constexpr Float32Range kRange{-kMaxTransformNumber, kMaxTransformNumber};

// The nearest float32 numbers, since computing with them rounds anyway.
float read_number(const Place& place, std::string_view what, Findings& findings) {
  return read_float32(place, what, kRange, Float32Kind::nearest, findings).value_or(0);
}

Vector read_vector(const Place& place, std::string_view what, Findings& findings) {
  return read_float32s<3>(place, what, kRange, Float32Kind::nearest, findings).value_or(Vector{});
}

// Reads numbers by name; false, and a finding, if one is missing or wrong.
bool read_named(const Place& place, std::string_view what, const Keys& keys,
                const std::vector<std::pair<const char*, float*>>& names, Findings& findings) {
  const std::size_t before = findings.size();
  const ObjectReader object(place, what, keys, findings);
  for (const auto& [name, value] : names)
    if (const auto member = object.find(name)) *value = read_number(*member, name, findings);
  return findings.size() == before;
}

// Sixteen numbers, row by row, as people write a matrix.
Matrix read_matrix(const Place& place, Findings& findings) {
  const auto rows = read_float32s<16>(place, "a matrix", kRange, Float32Kind::nearest, findings);
  if (!rows) return kIdentity;
  Matrix matrix{};
  for (std::size_t row = 0; row < 4; ++row)
    for (std::size_t column = 0; column < 4; ++column)
      matrix[4 * column + row] = (*rows)[4 * row + column];
  return matrix;
}

Matrix read_rotation(const Place& place, Findings& findings) {
  const std::size_t before = findings.size();
  const ObjectReader object(place, "a rotation", kRotateKeys, findings);
  float degrees = 0;
  Vector axis{};
  if (const auto member = object.find("degrees"))
    degrees = read_number(*member, "degrees", findings);
  if (const auto member = object.find("axis")) {
    axis = read_vector(*member, "an axis", findings);
    if (findings.size() == before && axis == Vector{})
      findings.add(*member, "an axis has no direction", "write one like [0, 1, 0]");
  }
  return findings.size() == before ? rotation(degrees, axis) : kIdentity;
}

// The only member of an object that must have exactly one.
std::optional<Place> only_member(const Place& place, std::string_view what, const Keys& keys,
                                 Findings& findings) {
  const std::size_t before = findings.size();
  const ObjectReader object(place, what, keys, findings);
  if (findings.size() != before) return std::nullopt;
  if (place.node->children.size() == 1) return place.child(0);
  findings.add(place, fmt::format("{} has {} keys", what, place.node->children.size()),
               "write exactly one of " + join_names(keys.optional));
  return std::nullopt;
}

Matrix read_operation(const Place& place, Findings& findings) {
  const auto member = only_member(place, "an operation", kOperationKeys, findings);
  if (!member) return kIdentity;
  const std::string& name = member->node->name;
  if (name == "translate") return translation(read_vector(*member, "a translation", findings));
  if (name == "scale") return scaling(read_vector(*member, "a scaling", findings));
  if (name == "rotate") return read_rotation(*member, findings);
  return read_matrix(*member, findings);
}

Matrix read_perspective(const Place& place, Findings& findings) {
  float fov = 0, aspect = 0, near = 0, far = 0;
  const bool sound = read_named(
      place, "a perspective", kPerspectiveKeys,
      {{"fov_y_degrees", &fov}, {"aspect", &aspect}, {"near", &near}, {"far", &far}}, findings);
  if (!sound) return kIdentity;
  const auto refuse = [&](const char* message, const char* remedy) {
    findings.add(place, message, remedy);
    return kIdentity;
  };
  if (!(fov > 0 && fov < 180))
    return refuse("fov_y_degrees does not lie between 0 and 180", "write an angle like 60");
  if (!(aspect > 0)) return refuse("aspect is not above 0", "write width by height, like 1.5");
  if (!(near > 0 && near < far))
    return refuse("near and far are no distances from the eye, the smaller one first",
                  "write 0 < near < far");
  return perspective(fov, aspect, near, far);
}

Matrix read_sides(const Place& place, bool is_frustum, Findings& findings) {
  Sides sides;
  const bool sound =
      read_named(place, is_frustum ? "a frustum" : "an orthographic projection", kSidesKeys,
                 {{"left", &sides.left},
                  {"right", &sides.right},
                  {"bottom", &sides.bottom},
                  {"top", &sides.top},
                  {"near", &sides.near},
                  {"far", &sides.far}},
                 findings);
  if (!sound) return kIdentity;
  if (sides.left == sides.right || sides.bottom == sides.top || sides.near == sides.far) {
    findings.add(place, "opposite sides are equal",
                 "let left and right, bottom and top, near and "
                 "far differ");
    return kIdentity;
  }
  if (is_frustum && !(sides.near > 0 && sides.near < sides.far)) {
    findings.add(place, "near and far are no distances from the eye, the smaller one first",
                 "write 0 < near < far");
    return kIdentity;
  }
  return is_frustum ? frustum(sides) : orthographic(sides);
}

Matrix read_look_at(const Place& place, Findings& findings) {
  const std::size_t before = findings.size();
  const ObjectReader object(place, "a look_at", kLookAtKeys, findings);
  Vector eye{}, center{}, up{};
  for (const auto& [name, vector] :
       {std::pair{"eye", &eye}, std::pair{"center", &center}, std::pair{"up", &up}})
    if (const auto member = object.find(name)) *vector = read_vector(*member, name, findings);
  if (findings.size() != before) return kIdentity;
  const Matrix matrix = look_at(eye, center, up);
  if (is_finite(matrix)) return matrix;
  findings.add(place, "a look_at has no direction: eye and center are equal, or up lies along them",
               "move the center, or choose another up");
  return kIdentity;
}

Matrix read_operations(const Place& place, Findings& findings) {
  Matrix matrix = kIdentity;
  if (!expect_kind(place, JsonKind::array, "a list of operations", findings)) return matrix;
  const std::size_t count = place.node->children.size();
  if (count > kMaxOperations) {
    findings.add(place, fmt::format("a list has {} operations", count),
                 fmt::format("write {} at most", kMaxOperations));
    return matrix;
  }
  for (std::size_t i = 0; i < count; ++i)
    matrix = product(read_operation(place.child(i), findings), matrix);
  return matrix;
}

// {"look_at": ...} or a list of operations; {"perspective": ...}, {"frustum": ...},
// {"orthographic": ...} or {"matrix": ...}.
Matrix read_view(const Place& place, Findings& findings) {
  if (place.node->kind == JsonKind::array) return read_operations(place, findings);
  const ObjectReader object(place, "a view", kViewKeys, findings);
  const auto member = object.find("look_at");
  return member ? read_look_at(*member, findings) : kIdentity;
}

Matrix read_projection(const Place& place, Findings& findings) {
  const auto member = only_member(place, "a projection", kProjectionKeys, findings);
  if (!member) return kIdentity;
  const std::string& name = member->node->name;
  if (name == "perspective") return read_perspective(*member, findings);
  if (name == "matrix") return read_matrix(*member, findings);
  return read_sides(*member, name == "frustum", findings);
}

}  // namespace

Transform read_transform(const Place& place, Findings& findings) {
  Transform transform;
  transform.place = place;
  const ObjectReader object(place, "a transform", kTransformKeys, findings);
  if (object.valid() && place.node->children.empty())
    findings.add(place, "a transform is empty",
                 "write one of " + join_names(kTransformKeys.optional) + ", or remove the key");
  transform.affine_place = object.find("affine");
  if (transform.affine_place) transform.affine = read_affine(*transform.affine_place, findings);
  const std::pair<const char*, Matrix (*)(const Place&, Findings&)> parts[] = {
      {"model", read_operations}, {"view", read_view}, {"projection", read_projection}};
  for (const auto& [name, read] : parts) {
    const auto member = object.find(name);
    if (!member) continue;
    transform.has_matrix = true;
    transform.matrix = product(read(*member, findings), transform.matrix);
  }
  if (transform.has_matrix && !is_finite(transform.matrix))
    findings.add(place, "the transform's numbers leave float32", "use smaller numbers");
  return transform;
}

}  // namespace edgecase
