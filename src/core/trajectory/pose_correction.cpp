// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "trajectory/pose_correction.hpp"

#include <algorithm>
#include <cmath>

#include "base/dense_solvers.hpp"
#include "lamina/base/angle.hpp"
#include "lamina/geometry/vector.hpp"

namespace lamina {
namespace {

constexpr int kMostSteps = 20;
constexpr double kRadianWeight = 100.0;  // mm: what a radian of the tool axis counts like
constexpr double kRankThreshold = 1e-6;

using Residual = Eigen::Matrix<double, 6, 1>;

Residual residual(const Eigen::Isometry3d& is, const Eigen::Isometry3d& asked) {
  Residual error;
  error << asked.translation() - is.translation(),
      is.linear().col(2).cross(asked.linear().col(2)) * kRadianWeight;
  return error;
}

}  // namespace

PoseCorrection::PoseCorrection(const KinematicModel& model, const TrajectorySettings& settings)
    : model_(model),
      tip_mm_(0.5 * settings.line_tolerance_mm),
      tool_axis_rad_(toRadians(0.5 * settings.line_tolerance_deg)),
      speeds_(static_cast<Eigen::Index>(model.joints().size())) {
  for (Eigen::Index j = 0; j < speeds_.size(); ++j) speeds_[j] = model.joints()[j].max_speed;
}

bool PoseCorrection::isWithin(const Eigen::Isometry3d& is, const Eigen::Isometry3d& asked) const {
  const Residual error = residual(is, asked);
  return error.head<3>().norm() <= tip_mm_ && error.tail<3>().norm() <= tool_axis_rad_ * kRadianWeight &&
         is.linear().col(2).dot(asked.linear().col(2)) > 0.0;
}

std::optional<JointValues> PoseCorrection::near(JointValues values, const Eigen::Isometry3d& asked,
                                                Keep keep) const {
  const int rows = keep == Keep::Tip ? 3 : 6;
  const double close = 0.01 * std::min(tip_mm_, tool_axis_rad_ * kRadianWeight);
  for (int step = 0; step < kMostSteps; ++step) {
    const Eigen::Isometry3d pose = model_.bedFromNozzle(values);
    const Residual error = residual(pose, asked);
    if (error.head(rows).norm() < close) return values;
    Jacobian jacobian = model_.jacobian(values);
    const Point3 tool_axis = pose.linear().col(2);
    jacobian.bottomRows<3>() -= (tool_axis * (tool_axis.transpose() * jacobian.bottomRows<3>())).eval();
    jacobian.bottomRows<3>() *= kRadianWeight;
    const Eigen::MatrixXd scaled = jacobian.topRows(rows) * speeds_.asDiagonal();
    values += speeds_.cwiseProduct(shortestSolution(scaled, error.head(rows), kRankThreshold));
    if (!values.allFinite()) return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace lamina
