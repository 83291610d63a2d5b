// SPDX-License-Identifier: MIT
//
// Model, view and projection matrices in float32, made and multiplied by GLM; the only user of it.
//
// Matrices act on columns: v' = M v. They are OpenGL's own: the eye looks along -z, and depth runs
// from -1 (near) to 1 (far) after the division by w.
#pragma once

#include <array>

#include "model/scene.h"

namespace edgecase {

// Column by column.
using Matrix = std::array<float, 16>;
using Vector = std::array<float, 3>;

constexpr Matrix kIdentity{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

// after * before: first `before`, then `after`.
Matrix product(const Matrix& after, const Matrix& before);

Matrix translation(const Vector& by);
Matrix scaling(const Vector& by);
// Counterclockwise where the axis points at the viewer; the axis need not have length 1.
Matrix rotation(float degrees, const Vector& axis);

Matrix look_at(const Vector& eye, const Vector& center, const Vector& up);

// `aspect`: width by height. near and far are distances from the eye.
Matrix perspective(float fov_y_degrees, float aspect, float near, float far);

// The sides of the near plane, or of the box; near and far are distances from the eye.
struct Sides {
  float left = -1, right = 1, bottom = -1, top = 1, near = -1, far = 1;
};
Matrix frustum(const Sides& sides);
Matrix orthographic(const Sides& sides);

bool is_finite(const Matrix& matrix);

// The matrix times (x, y, z, 1), computed in float32.
ClipPosition clip_position(const Matrix& matrix, const Vector& object);

}  // namespace edgecase
