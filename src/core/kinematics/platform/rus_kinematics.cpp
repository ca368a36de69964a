// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/kinematics/platform/rus_kinematics.hpp"

#include <cmath>
#include <cstdio>
#include <string>

#include "base/dense_solvers.hpp"
#include "geometry/space_vectors.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"

namespace lamina {
namespace {

constexpr double kSettled = 1e-12;           // of a coupler's length
constexpr int kMostIterations = 30;          // Newton settles within six where it settles at all
constexpr double kGreatestStep = 0.3;        // of the turn [rad]; beyond it is no local solution
constexpr double kLongestStep = 0.25;        // of a crank [rad]; longer ones may end in another assembly
constexpr double kLeastStep = 1.0 / 4096.0;  // of the way from home

/// The angle of a crank's direction within the plane in which it turns is that of the ball's projection, less
/// or more half of what the leg's triangle leaves.
struct LegTriangle {
  double x = 0.0;      ///< the ball from the motor along the crank at 0 [mm]
  double y = 0.0;      ///< and along the crank at 90 deg
  double reach = 0.0;  ///< of that projection's length that the crank has to stand at
};

LegTriangle triangleOf(const RusLeg& leg, const Point3& ball) {
  const Point3 d = ball - leg.motor;
  const double squares = d.squaredNorm() + leg.crank_mm * leg.crank_mm - leg.coupler_mm * leg.coupler_mm;
  return {d.dot(leg.rest), d.dot(leg.axis.cross(leg.rest)), 0.5 * squares / leg.crank_mm};
}

double wrapped(double angle) { return std::remainder(angle, 2.0 * M_PI); }

std::string unreached(const RusPlatform& platform, const Eigen::Isometry3d& pose) {
  std::string legs;
  for (std::size_t i = 0; i < kLegs; ++i) {
    const RusLeg& leg = platform.legs[i];
    const Point3 ball = pose * leg.ball;
    if (crankAngle(leg, ball, leg.branch)) continue;
    char text[160];
    std::snprintf(text, sizeof text, "%sleg %zu (%.3f mm from motor to ball; crank %.3f mm, coupler %.3f mm)",
                  legs.empty() ? "" : ", ", i + 1, (ball - leg.motor).norm(), leg.crank_mm, leg.coupler_mm);
    legs += text;
  }
  return legs;
}

/// How far the couplers are from their lengths [mm].
CrankAngles lengthErrors(const RusPlatform& platform, const CrankAngles& cranks,
                         const Eigen::Isometry3d& pose) {
  CrankAngles errors;
  for (Eigen::Index i = 0; i < 6; ++i) {
    const RusLeg& leg = platform.legs[static_cast<std::size_t>(i)];
    errors[i] = (pose * leg.ball - leg.elbow(cranks[i])).norm() - leg.coupler_mm;
  }
  return errors;
}

/// The pose moved by a small motion; turns about the platform's origin.
Eigen::Isometry3d moved(const Eigen::Isometry3d& pose, const CrankAngles& motion) {
  Eigen::Isometry3d result = pose;
  result.translation() += motion.head<3>();
  result.linear() = turnBy(motion.tail<3>()) * pose.linear();
  return result;
}

/// Rotations that many steps have multiplied drift from being rotations.
Eigen::Isometry3d orthonormal(Eigen::Isometry3d pose) {
  pose.linear() = Eigen::Quaterniond(pose.linear()).normalized().toRotationMatrix();
  return pose;
}

double meanBallDistance(const RusPlatform& platform) {
  double sum = 0.0;
  for (const RusLeg& leg : platform.legs) sum += leg.ball.norm();
  return sum / static_cast<double>(kLegs);
}

}  // namespace

std::optional<double> crankAngle(const RusLeg& leg, const Point3& ball, CrankBranch branch) {
  const LegTriangle triangle = triangleOf(leg, ball);
  const double projected = std::hypot(triangle.x, triangle.y);
  if (!(std::abs(triangle.reach) <= projected) || projected == 0.0) return std::nullopt;
  const double line = std::atan2(triangle.y, triangle.x);
  const double opening = std::acos(triangle.reach / projected);
  return wrapped(branch == CrankBranch::Behind ? line - opening : line + opening);
}

std::optional<CrankAngles> crankAnglesIfReached(const RusPlatform& platform, const Eigen::Isometry3d& pose) {
  CrankAngles cranks;
  for (Eigen::Index i = 0; i < 6; ++i) {
    const RusLeg& leg = platform.legs[static_cast<std::size_t>(i)];
    const auto crank = crankAngle(leg, pose * leg.ball, leg.branch);
    if (!crank) return std::nullopt;
    cranks[i] = *crank;
  }
  return cranks;
}

CrankAngles crankAngles(const RusPlatform& platform, const Eigen::Isometry3d& pose) {
  const auto cranks = crankAnglesIfReached(platform, pose);
  if (!cranks) throw Unreachable("the platform's pose is out of reach of " + unreached(platform, pose));
  return *cranks;
}

std::optional<Eigen::Isometry3d> poseNear(const RusPlatform& platform, const CrankAngles& cranks,
                                          const Eigen::Isometry3d& near) {
  Eigen::Isometry3d pose = near;
  bool is_settled = false;
  for (int iteration = 0; iteration < kMostIterations; ++iteration) {
    const CrankAngles errors = lengthErrors(platform, cranks, pose);
    const double greatest = errors.cwiseAbs().maxCoeff();
    // One step more than it takes: the pose is as exact as the lengths are only after it.
    if (is_settled) return orthonormal(pose);
    is_settled = greatest <= kSettled * platform.legs[0].coupler_mm;
    const Matrix6 slopes = velocityEquation(platform, pose, cranks).pose_rates;
    const CrankAngles motion = solutionOf(slopes, CrankAngles(-errors));
    if (!motion.allFinite() || motion.tail<3>().norm() > kGreatestStep) return std::nullopt;
    pose = moved(pose, motion);
  }
  return std::nullopt;
}

Eigen::Isometry3d poseFromHome(const RusPlatform& platform, const CrankAngles& cranks) {
  const CrankAngles start = crankAngles(platform, platform.home);
  CrankAngles way = cranks - start;
  way = way.unaryExpr(&wrapped);
  const double longest = kLongestStep / std::max(kLongestStep, way.cwiseAbs().maxCoeff());
  Eigen::Isometry3d pose = platform.home;
  double done = 0.0;
  double step = longest;
  while (done < 1.0) {
    const double next = std::min(1.0, done + step);
    const auto found = poseNear(platform, start + next * way, pose);
    if (found) {
      pose = *found;
      done = next;
      step = std::min(longest, 2.0 * step);
    } else if ((step /= 2.0) < kLeastStep) {
      throw Unreachable("the platform's legs cannot be closed beyond " + numberText(100.0 * done) +
                        " % of the way from home to the cranks asked for");
    }
  }
  return pose;
}

VelocityEquation velocityEquation(const RusPlatform& platform, const Eigen::Isometry3d& pose,
                                  const CrankAngles& cranks) {
  VelocityEquation equation;
  for (Eigen::Index i = 0; i < 6; ++i) {
    const RusLeg& leg = platform.legs[static_cast<std::size_t>(i)];
    const Point3 arm = pose.linear() * leg.ball;
    const Point3 coupler = (pose.translation() + arm - leg.elbow(cranks[i])).normalized();
    equation.pose_rates.row(i) << coupler.transpose(), arm.cross(coupler).transpose();
    equation.crank_rates[i] = leg.crank_mm * coupler.dot(leg.crankTangent(cranks[i]));
  }
  return equation;
}

SingularityMargins singularityMargins(const RusPlatform& platform, const Eigen::Isometry3d& pose,
                                      const CrankAngles& cranks) {
  VelocityEquation equation = velocityEquation(platform, pose, cranks);
  SingularityMargins margins;
  margins.stretched = 1.0;
  for (Eigen::Index i = 0; i < 6; ++i) {
    const double sine = equation.crank_rates[i] / platform.legs[static_cast<std::size_t>(i)].crank_mm;
    margins.stretched = std::min(margins.stretched, std::abs(sine));
  }
  equation.pose_rates.rightCols<3>() /= meanBallDistance(platform);
  const Eigen::VectorXd values = singularValues(equation.pose_rates);
  margins.unheld = values[5] / values[0];
  return margins;
}

PlatformAngles platformAngles(const Eigen::Matrix3d& rotation) {
  // Of R_y(b) R_x(a) R_z(g): column 2 is (sin b cos a, -sin a, cos b cos a), row 1 is (cos a sin g, cos a cos
  // g, -sin a).
  PlatformAngles angles;
  const double cosine = std::hypot(rotation(0, 2), rotation(2, 2));
  angles.alpha = std::atan2(-rotation(1, 2), cosine);
  if (cosine > 1e-12) {
    angles.beta = std::atan2(rotation(0, 2), rotation(2, 2));
    angles.gamma = std::atan2(rotation(1, 0), rotation(1, 1));
  } else {
    angles.beta = std::atan2(-rotation(2, 0), rotation(0, 0));
  }
  return angles;
}

Eigen::Matrix3d rotationOf(const PlatformAngles& angles) {
  return (Eigen::AngleAxisd(angles.beta, Point3::UnitY()) * Eigen::AngleAxisd(angles.alpha, Point3::UnitX()) *
          Eigen::AngleAxisd(angles.gamma, Point3::UnitZ()))
      .toRotationMatrix();
}

}  // namespace lamina
