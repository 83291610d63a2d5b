// SPDX-License-Identifier: MIT
#include "casefile/matrices.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

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

Matrix translation(const Vector& by) {
  return from_glm(glm::translate(glm::mat4(kOne), to_glm(by)));
}

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

}  // namespace edgecase
