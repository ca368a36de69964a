// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <vector>

#include "lamina/calibration/sensor_pose.hpp"

namespace lamina {

/// A target's surface, with what is not known of where it stands.
class SurfaceModel {
 public:
  SurfaceModel() = default;
  SurfaceModel(const SurfaceModel&) = delete;
  SurfaceModel& operator=(const SurfaceModel&) = delete;
  virtual ~SurfaceModel() = default;

  /// Number of unknowns: shifts [mm] and turns [rad], small about where the target is thought to be.
  virtual Eigen::Index unknowns() const = 0;
  /// Steps of derivatives by them.
  virtual Eigen::VectorXd steps() const = 0;
  /// The face nearest to a point [mm, bed]; negative for a point of none.
  virtual int faceOf(const Point3& point, const Eigen::VectorXd& unknowns) const = 0;
  /// Distance from a face [mm].
  virtual double distance(int face, const Point3& point, const Eigen::VectorXd& unknowns) const = 0;
};

/// The model of a target.
/// @param points  as seen so far [mm, bed]; a plane begins where they lie
std::unique_ptr<SurfaceModel> surfaceModelOf(const SensorTarget& target, const std::vector<Point3>& points);

}  // namespace lamina
