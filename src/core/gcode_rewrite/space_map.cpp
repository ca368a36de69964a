// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/gcode_rewrite/space_map.hpp"

#include <Eigen/LU>
#include <cmath>
#include <string>

#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"

namespace lamina {
namespace {

constexpr double kWorstCondition = 1e6;
constexpr double kOrthonormal = 1e-12;  // what rounding leaves of products of rotations

}  // namespace

double SpaceMap::volumeRatio(const Point3& point) const {
  constexpr double kStep =
      1e-4;  // mm; the error of central differences is least near the cube root of epsilon
  Eigen::Matrix3d jacobian;
  for (int axis = 0; axis < 3; ++axis) {
    const Point3 step = kStep * Point3::Unit(axis);
    jacobian.col(axis) = (map(point + step) - map(point - step)) / (2.0 * kStep);
  }
  return std::abs(jacobian.determinant());
}

AffineMap::AffineMap(const Eigen::Affine3d& to_mapped) : to_mapped_(to_mapped) {
  if (!to_mapped.matrix().allFinite()) throw InvalidInput("the map of space is not finite");
  const Eigen::Matrix3d linear = to_mapped.linear();
  const double condition = linear.norm() * linear.inverse().norm();
  if (!(condition < kWorstCondition))
    throw InvalidInput("the map of space has the condition " + numberText(condition) +
                       "; it must be invertible, below 1e6");
  from_mapped_ = to_mapped.inverse(Eigen::Affine);
  volume_ratio_ = std::abs(linear.determinant());
  if ((linear * linear.transpose()).isIdentity(kOrthonormal)) kind_ = MapKind::Isometry;
}

AffineMap operator*(const AffineMap& after, const AffineMap& before) {
  return AffineMap(after.matrix() * before.matrix());
}

AffineMap rotation(const Point3& axis, double angle_deg) {
  if (!(axis.norm() > 1e-9)) throw InvalidInput("the axis has no direction; it must be longer than 1e-9");
  Eigen::Affine3d matrix = Eigen::Affine3d::Identity();
  matrix.linear() = Eigen::AngleAxisd(toRadians(angle_deg), axis.normalized()).toRotationMatrix();
  return AffineMap(matrix);
}

AffineMap scaling(const Point3& factors) { return AffineMap(Eigen::Affine3d(factors.asDiagonal())); }

AffineMap shear(int moved, int along, double factor) {
  if (moved < 0 || moved > 2 || along < 0 || along > 2 || moved == along)
    throw InvalidInput("shear moves axis " + std::to_string(moved) + " along axis " + std::to_string(along) +
                       "; they must be two of 0, 1, 2");
  Eigen::Affine3d matrix = Eigen::Affine3d::Identity();
  matrix(moved, along) = factor;
  return AffineMap(matrix);
}

AffineMap beltAxes(double gantry_deg) {
  if (!(gantry_deg >= 15.0 && gantry_deg <= 90.0))
    throw InvalidInput("the gantry leans by " + numberText(gantry_deg) + " deg; must be in [15, 90]");
  const double angle = toRadians(gantry_deg);
  Eigen::Affine3d matrix = Eigen::Affine3d::Identity();
  matrix.linear() << 1.0, 0.0, 0.0,     //
      0.0, 0.0, 1.0 / std::sin(angle),  //
      0.0, -1.0, std::cos(angle) / std::sin(angle);
  return AffineMap(matrix);
}

}  // namespace lamina
