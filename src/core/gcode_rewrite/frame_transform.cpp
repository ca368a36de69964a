// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gcode_rewrite/frame_transform.hpp"

#include <Eigen/LU>

#include "geometry/space_vectors.hpp"
#include "lamina/base/angle.hpp"
#include "lamina/geometry/shortest_rotation.hpp"

namespace lamina {
namespace {

constexpr double kStraight = 1e-9;  // rad: what rounding leaves of a rotation

/// The matrix of a map that keeps lines straight, or of its inverse.
template <class Call>
Eigen::Affine3d matrixOf(const Call& call) {
  Eigen::Affine3d matrix = Eigen::Affine3d::Identity();
  matrix.translation() = call(Point3::Zero());
  for (int axis = 0; axis < 3; ++axis)
    matrix.linear().col(axis) = call(Point3::Unit(axis)) - matrix.translation();
  return matrix;
}

Eigen::Quaterniond turnOf(const Eigen::Matrix3d& linear, const Point3& normal) {
  const bool is_rotation = (linear * linear.transpose()).isIdentity(kStraight) && linear.determinant() > 0.0;
  if (is_rotation) return Eigen::Quaterniond(linear);
  const Point3 mapped = linear.inverse().transpose() * normal;  // as normals of planes are mapped
  return shortestRotation(normal, mapped);
}

Eigen::Quaterniond unlessStraight(const Eigen::Quaterniond& frame) {
  const bool is_straight = angleBetween(frame * Point3::UnitZ(), Point3::UnitZ()) < kStraight;
  return is_straight ? Eigen::Quaterniond::Identity() : frame;
}

}  // namespace

StatedFrame transformedFrame(const StatedFrame& source, const PointTransform& transform,
                             const std::optional<Point3>& tool_axis) {
  if (!transform.keepsLines()) return {};
  const Eigen::Affine3d map = matrixOf([&](const Point3& point) { return transform.map.map(point); });
  const Point3 normal = source.bed_from_layers * Point3::UnitZ();
  const Eigen::Quaterniond turn = turnOf(map.linear(), normal);
  StatedFrame stated;
  stated.bed_from_layers = unlessStraight((turn * source.bed_from_layers).normalized());
  const Point3 held = tool_axis.value_or(turn * (source.bed_from_nozzle * Point3::UnitZ()));
  stated.bed_from_nozzle = shortestRotation(-Point3::UnitZ(), held) * nozzleDown();
  if (transform.axes != nullptr)
    stated.bed_from_program = matrixOf([&](const Point3& point) { return transform.axes->inverse(point); });
  return stated;
}

double toolAxisOffNormalDeg(const StatedFrame& frame) {
  const Point3 tool_axis = frame.bed_from_nozzle * Point3::UnitZ();
  return toDegrees(angleBetween(tool_axis, -(frame.bed_from_layers * Point3::UnitZ())));
}

}  // namespace lamina
