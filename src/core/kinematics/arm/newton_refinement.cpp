// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/arm/newton_refinement.hpp"

#include <algorithm>
#include <cmath>

#include "base/dense_solvers.hpp"
#include "kinematics/arm/pose_difference.hpp"
#include "lamina/base/angle.hpp"

namespace lamina {
namespace {

constexpr double kRefinedGoal = 1e-8;  // mm: where rounding ends the gain
constexpr double kEnough = 1e-7;       // mm
constexpr double kLargestStep = 0.3;   // rad: beyond it the linear model is none
constexpr double kDependent = 1e-10;   // pivots of columns that a singularity makes dependent
constexpr int kMostSteps = 12;

using Twist = Eigen::Matrix<double, 6, 1>;
using Columns = Eigen::Matrix<double, 6, 6>;

/// Where the nozzle is, and how it moves with each joint: tip [mm], turn [mm at the lever].
struct Linear {
  Eigen::Isometry3d pose;
  Columns columns;
};

/// In one pass: the general functions take one for the pose and another for the Jacobian.
Linear linearAt(const SerialChain& arm, const ArmValues& values) {
  Linear linear;
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  Point3 shift = Point3::Zero();
  for (Eigen::Index j = 0; j < 6; ++j) {
    const Screw& screw = arm.screws[static_cast<std::size_t>(j)];
    linear.columns.col(j).head<3>() = turn * screw.point + shift;
    linear.columns.col(j).tail<3>() = turn * screw.direction;
    turn = turn * Eigen::AngleAxisd(values[j], screw.direction).toRotationMatrix();
    shift = Point3(linear.columns.col(j).head<3>()) - turn * screw.point;
  }
  linear.pose.linear() = turn;
  linear.pose.translation() = shift;
  linear.pose = linear.pose * arm.bed_from_nozzle_at_zero;
  for (Eigen::Index j = 0; j < 6; ++j) {
    const Point3 point = linear.columns.col(j).head<3>();
    const Point3 direction = linear.columns.col(j).tail<3>();
    linear.columns.col(j) << direction.cross(linear.pose.translation() - point), kTurnLever * direction;
  }
  return linear;
}

/// The step that brings about a twist; at a singularity the shortest that comes nearest.
ArmValues stepFor(const Columns& columns, const Twist& twist) {
  ArmValues step = solutionOf(columns, twist);
  if (step.norm() < kLargestStep) return step;
  const ArmValues shortest = shortestSolution(columns, twist, kDependent);
  return shortest * std::min(1.0, kLargestStep / std::max(shortest.norm(), kLargestStep));
}

}  // namespace

std::optional<ArmValues> refined(const SerialChain& arm, const Eigen::Isometry3d& bed_from_nozzle,
                                 ArmValues values) {
  double error = 0.0;
  for (int step = 0; step <= kMostSteps; ++step) {
    const Linear linear = linearAt(arm, values);
    const Twist missing = poseDifference(linear.pose, bed_from_nozzle);
    error = missing.cwiseAbs().maxCoeff();
    if (error < kRefinedGoal) break;
    if (step < kMostSteps) values += stepFor(linear.columns, missing);
  }
  if (!(error < kEnough)) return std::nullopt;
  return values.unaryExpr(&wrappedRadians);
}

ArmSolutions refined(const SerialChain& arm, const Eigen::Isometry3d& bed_from_nozzle, ArmSolutions found) {
  const auto fails = [&](ArmSolution& solution) {
    const auto values = refined(arm, bed_from_nozzle, solution.values);
    if (values) solution.values = *values;
    return !values;
  };
  found.erase(std::remove_if(found.begin(), found.end(), fails), found.end());
  return found;
}

ArmSolutions wrappedValues(ArmSolutions found) {
  for (ArmSolution& solution : found) solution.values = solution.values.unaryExpr(&wrappedRadians).eval();
  return found;
}

}  // namespace lamina
