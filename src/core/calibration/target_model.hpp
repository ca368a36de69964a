// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <vector>

#include "lamina/calibration/sensor_pose.hpp"

namespace lamina {

/// Surface of a target whose position is not exactly known.
class SurfaceModel {
 public:
  SurfaceModel() = default;
  SurfaceModel(const SurfaceModel&) = delete;
  SurfaceModel& operator=(const SurfaceModel&) = delete;
  virtual ~SurfaceModel() = default;

  /// Number of unknowns: shifts [mm] and rotations [rad] from the assumed position, all small.
  virtual Eigen::Index unknowns() const = 0;
  /// Step of numeric differentiation for each unknown.
  virtual Eigen::VectorXd steps() const = 0;
  /// Index of the face nearest to a point [mm, bed frame]; negative if the point belongs to no face.
  virtual int faceOf(const Point3& point, const Eigen::VectorXd& unknowns) const = 0;
  /// Signed distance of a point from a face [mm].
  virtual double distance(int face, const Point3& point, const Eigen::VectorXd& unknowns) const = 0;
};

/// Makes the model of a target.
/// @param points  measured so far [mm, bed frame]; the model of a plane starts at these
std::unique_ptr<SurfaceModel> surfaceModelOf(const SensorTarget& target, const std::vector<Point3>& points);

}  // namespace lamina
