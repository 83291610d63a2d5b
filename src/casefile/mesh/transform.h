// SPDX-License-Identifier: MIT
//
// Reads `transform`, which moves vertices before they are drawn.
//
// {"model": [...], "view": {...}, "projection": {...}} takes vertices in object space, and meshes,
// to clip coordinates. They are computed once, here, in float32, so that both sides get the same
// numbers. {"affine": [...]} moves vertices in window coordinates, exactly if the result is a
// multiple of 2^-16. Operations of a list are applied in the order written.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "casefile/json/fields.h"
#include "casefile/json/json_layout.h"
#include "exact/fixed.h"
#include "model/scene.h"

namespace edgecase {

// Affine maps of window coordinates: x' = a x + c y + e, y' = b x + d y + f.
//
// Computed in integers, in steps of 2^-48 pixels: moving, scaling by multiples of 2^-16, shearing
// and quarter turns are exact unless the result needs finer steps, and any rounding is reported.
// The cosine of other angles is rounded to 2^-48.

// One map. The magnitude of a, b, c, d is at most 2^10, that of e and f at most 2^14.
struct AffineStep {
  std::array<std::int64_t, 4> linear{};  // a, b, c, d, in steps of 2^-48
  std::array<std::int64_t, 2> shift{};   // e, f, in steps of 2^-48 pixels
  bool exact = true;                     // false: a, b, c, d were rounded themselves
};

constexpr float kMaxTransformNumber = 1073741824;  // 2^30: largest magnitude of any number
constexpr int kMaxAffineFactor = 1024;             // largest magnitude of a, b, c, d
constexpr int kMaxAffineShift = 16384;             // of e and f, pixels

// x' = a x + c y + e, y' = b x + d y + f, with exact numbers.
AffineStep affine_step(const std::array<Fixed, 6>& a_to_f);

// A rotation about (0, 0) by an angle in degrees, counterclockwise with y up.
AffineStep turn_step(Fixed degrees);

struct MovedPoint {
  Point point;         // rounded to multiples of 2^-16
  bool exact = false;  // nothing was rounded
};

// Applies the maps in order. Nothing if a coordinate leaves [-2^14, 2^14] on the way.
std::optional<MovedPoint> move_point(Point point, std::span<const AffineStep> steps);

// Model, view and projection matrices in float32, made and multiplied by GLM; its only user.
//
// Matrices act on columns: v' = M v. As in OpenGL, the eye looks along -z, and depth runs from -1
// (near) to 1 (far) after the division by w.

// Column by column.
using Matrix = std::array<float, 16>;
using Vector = std::array<float, 3>;

constexpr Matrix kIdentity{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

// after * before: first `before`, then `after`.
Matrix product(const Matrix& after, const Matrix& before);

Matrix scaling(const Vector& by);
// Counterclockwise if the axis points at the viewer; the axis need not have length 1.
Matrix rotation(float degrees, const Vector& axis);

Matrix look_at(const Vector& eye, const Vector& center, const Vector& up);

// `aspect`: width / height. near and far are distances from the eye.
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

struct Transform {
  Place place;
  std::vector<AffineStep> affine;     // for vertices in window coordinates
  std::optional<Place> affine_place;  // of "affine" in the file
  Matrix matrix = kIdentity;          // projection times view times model
  bool has_matrix = false;            // the file has one of those
};

// Adds findings for faults; the result is then incomplete.
Transform read_transform(const Place& place, Findings& findings);

// Lists of at most kMaxOperations objects with one key, such as {"translate": ...}. Affine
// operations, for window coordinates, have two numbers where the others have three.
constexpr std::size_t kMaxOperations = 64;
std::vector<AffineStep> read_affine(const Place& place, Findings& findings);

// The definitions of "transform" and its parts in the schema.
Pieces transform_schemas();
Pieces affine_schemas();

}  // namespace edgecase
