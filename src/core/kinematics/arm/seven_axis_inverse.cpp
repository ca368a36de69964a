// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/arm/seven_axis_inverse.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "base/dense_solvers.hpp"
#include "kinematics/arm/pose_difference.hpp"
#include "kinematics/arm/turn.hpp"
#include "lamina/base/angle.hpp"

namespace lamina {
namespace {

constexpr double kMeets = 0.5;          // mm: within which axes count as meeting
constexpr double kAsMade = 1e-11;       // rad and mm: rounding
constexpr double kAxesInLine = 1e-10;   // sine
constexpr double kStretched = 1e-10;    // by how much rounding brings a cosine beyond 1
constexpr double kFar = 3.0;            // by how much moved axes may bring it beyond 1
constexpr double kLeastBend = 0.05;     // rad: an elbow that Newton's method can bend
constexpr double kSameSolution = 1e-6;  // rad
constexpr double kFarthestStep = 0.5;   // rad: beyond it the linear model is none
constexpr double kReached = 1e-7;       // mm, turns at the lever
constexpr double kDamping = 10.0;       // mm a radian: of joints that hardly move the nozzle
constexpr int kLeadingSteps = 3;
constexpr double kNoFurther = 1e-8;  // mm: where rounding ends the gain
constexpr int kMostRefinements = 12;
constexpr std::array<double, 4> kParts = {0.25, 0.5, 0.75, 1.0};

/// Three axes, each at a right angle to the next.
struct ThreeAxes {
  const Point3& first;
  const Point3& second;
  const Point3& third;
};

/// The two sets of values by which three axes bring about a rotation; the second axis turns either way.
std::array<Point3, 2> eulerValues(const ThreeAxes& axes, const Eigen::Matrix3d& rotation, double kept) {
  const Point3 across = axes.second.cross(axes.first);
  const double at_zero = std::atan2(across.dot(axes.third), axes.first.dot(axes.third));
  const Point3 wanted = rotation * axes.third;
  const double sine = axes.first.cross(wanted).norm();
  const double bend = std::atan2(sine, axes.first.dot(wanted));
  std::array<Point3, 2> values;
  for (std::size_t i = 0; i < 2; ++i) {
    const double turned_by = i == 0 ? bend : -bend;
    const Point3 bent = std::cos(turned_by) * axes.first + std::sin(turned_by) * across;
    Point3& value = values[i];
    value[0] = sine < kAxesInLine ? kept : angleOf(turnBetween(bent, wanted, axes.first));
    value[1] = wrappedRadians(turned_by - at_zero);
    const Eigen::Matrix3d before =
        matrixOf(axes.first, turnOf(value[0])) * matrixOf(axes.second, turnOf(value[1]));
    const Point3 rest = before.transpose() * (rotation * axes.second);
    value[2] = std::atan2(axes.third.dot(axes.second.cross(rest)), axes.second.dot(rest));
  }
  return values;
}

/// Right-handed axes: one direction, and another as far as it is at a right angle to it.
Eigen::Matrix3d axesAlong(const Point3& first, const Point3& second) {
  const Point3 across = (second - first.dot(second) * first).normalized();
  Eigen::Matrix3d axes;
  axes << first, across, first.cross(across);
  return axes;
}

/// Finds the solutions of an arm whose axes meet in shoulder and wrist.
class CentredSolver {
 public:
  CentredSolver(const SevenAxes& arm, const Eigen::Isometry3d& bed_from_nozzle, const SevenValues& near)
      : arm_(arm), moved_(bed_from_nozzle * arm.bed_from_nozzle_at_zero.inverse()), near_(near) {}

  /// @param least_bend  of the elbow from stretched or folded [rad]; above 0, poses somewhat out of reach
  /// have
  ///   solutions too, which come near them
  SevenSolutions all(double arm_angle, double least_bend) {
    const Point3 line = moved_ * arm_.wrist - arm_.shoulder;
    const Screw& elbow = arm_.axes[3];
    const Point3 from = arm_.wrist - elbow.point;
    const Point3 to = arm_.shoulder - elbow.point;
    const double along = elbow.direction.dot(from) * elbow.direction.dot(to);
    const double a = to.dot(from) - along;
    const double b = to.dot(elbow.direction.cross(from));
    const double asked = 0.5 * (from.squaredNorm() + to.squaredNorm() - line.squaredNorm()) - along;
    const double most = std::hypot(a, b) * std::cos(least_bend);
    const bool is_far = std::abs(asked) > std::hypot(a, b) * (1.0 + (least_bend > 0.0 ? kFar : kStretched));
    if (is_far || !(line.norm() > 0.0)) return {};
    const TwoTurns bends = turnsWith(a, b, std::clamp(asked, -most, most));
    const Eigen::Matrix3d wanted = wantedAxes(line, arm_angle);
    // The first turn is the one with a negative sine of the elbow if axis 4 is not reversed.
    addElbow(wanted, bends.turns[0], arm_.elbow_sense > 0.0 ? 2 : 0);
    addElbow(wanted, bends.turns[1], arm_.elbow_sense > 0.0 ? 0 : 2);
    return found_;
  }

 private:
  /// The line from the shoulder to the wrist and the direction of axis 4, where they shall be.
  Eigen::Matrix3d wantedAxes(const Point3& line, double arm_angle) const {
    const Point3 along = line.normalized();
    const Point3& first = arm_.axes[0].direction;
    const Point3 level = first.cross(along);
    const Point3 start = level.norm() < kAxesInLine ? first.unitOrthogonal() : Point3(level.normalized());
    return axesAlong(along, arm_.elbow_sense * turned(start, along, turnOf(arm_angle)));
  }

  void addElbow(const Eigen::Matrix3d& wanted, const Turn& bend, int branch) {
    const auto& axes = arm_.axes;
    const Eigen::Matrix3d fourth = matrixOf(axes[3].direction, bend);
    const Point3 line = axes[3].point + fourth * (arm_.wrist - axes[3].point) - arm_.shoulder;
    const Eigen::Matrix3d upper = wanted * axesAlong(line.normalized(), axes[3].direction).transpose();
    const Eigen::Matrix3d hand = (upper * fourth).transpose() * moved_.linear();
    const ThreeAxes shoulder{axes[0].direction, axes[1].direction, axes[2].direction};
    const ThreeAxes wrist{axes[4].direction, axes[5].direction, axes[6].direction};
    const std::array<Point3, 2> hands = eulerValues(wrist, hand, near_[4]);
    const std::array<Point3, 2> uppers = eulerValues(shoulder, upper, near_[0]);
    for (int i = 0; i < 4; ++i) {
      SevenSolution solution;
      solution.branch = branch + (i < 2 ? 0 : 4) + i % 2;
      solution.values << uppers[i < 2 ? 0 : 1], angleOf(bend), hands[i % 2 == 0 ? 0 : 1];
      found_.push_back(solution);
    }
  }

  const SevenAxes& arm_;
  Eigen::Isometry3d moved_;  ///< from where the nozzle is at zero
  const SevenValues& near_;
  SevenSolutions found_;
};

/// What joint values shall bring about.
struct SevenTarget {
  const Eigen::Isometry3d& bed_from_nozzle;
  double arm_angle;
};

/// How the nozzle [mm, turn in mm at the lever] and the arm angle [the same] move with each joint.
Matrix7d ratesOf(const SevenAxes& arm, const SevenPosture& posture) {
  Matrix7d rates;
  for (std::size_t i = 0; i < arm.axes.size(); ++i) {
    const Screw& axis = posture.axes[i];
    const auto j = static_cast<Eigen::Index>(i);
    rates.col(j).head<3>() = axis.direction.cross(posture.bed_from_nozzle.translation() - axis.point);
    rates.col(j).segment<3>(3) = kTurnLever * axis.direction;
  }
  rates.row(6) = kTurnLever * armAngleRates(arm, posture);
  return rates;
}

/// What is missing to a pose and an arm angle: as `ratesOf`.
Vector7d missingTo(const SevenTarget& target, const SevenAxes& arm, const SevenPosture& posture) {
  Vector7d missing;
  missing.head<6>() = poseDifference(posture.bed_from_nozzle, target.bed_from_nozzle);
  missing[6] = kTurnLever * std::remainder(target.arm_angle - armAngle(arm, posture), 2.0 * M_PI);
  return missing;
}

SevenValues limited(const SevenValues& way) {
  return way * std::min(1.0, kFarthestStep / std::max(way.norm(), kFarthestStep));
}

/// Joint values for a pose and an arm angle, by Newton's method.
std::optional<SevenValues> followed(const SevenAxes& arm, const SevenTarget& target, SevenValues values) {
  Vector7d missing;
  for (int step = 0; step <= kMostRefinements; ++step) {
    const SevenPosture posture = postureOf(arm, values);
    missing = missingTo(target, arm, posture);
    if (missing.cwiseAbs().maxCoeff() < kNoFurther || step == kMostRefinements) break;
    const SevenValues way = solutionOf(ratesOf(arm, posture), missing);
    if (!way.allFinite()) return std::nullopt;
    values += limited(way);
  }
  if (!(missing.cwiseAbs().maxCoeff() < kReached)) return std::nullopt;
  return values;
}

/// A solution of the centred arm, led on while its axes move to where they are: near a solution.
SevenValues ledOn(const SevenAxes& arm, const SevenTarget& target, SevenValues values) {
  for (const double part : kParts) {
    const SevenAxes moved = movedAxes(arm, part);
    for (int step = 0; step < kLeadingSteps; ++step) {
      const SevenPosture posture = postureOf(moved, values);
      const Matrix7d rates = ratesOf(moved, posture);
      Matrix7d squares = rates.transpose() * rates;
      squares.diagonal().array() += kDamping * kDamping;
      values += limited(solutionOf(squares, Vector7d(rates.transpose() * missingTo(target, moved, posture))));
    }
  }
  return values;
}

bool isAmong(const SevenSolutions& found, const SevenValues& values) {
  return std::any_of(found.begin(), found.end(), [&](const SevenSolution& known) {
    const SevenValues apart = (known.values - values).unaryExpr(&wrappedRadians);
    return apart.cwiseAbs().maxCoeff() < kSameSolution;
  });
}

int signsOf(const SevenSines& sines) {
  return (sines.shoulder < 0.0 ? 4 : 0) + (sines.elbow < 0.0 ? 2 : 0) + (sines.wrist < 0.0 ? 1 : 0);
}

/// Branches by the signs of the arm as it is, the first one found of equal ones keeping them.
void renumber(SevenSolutions& found, const SevenAxes& arm) {
  std::array<int, 8> count{};
  for (SevenSolution& solution : found) {
    const int signs = signsOf(sinesOf(arm, postureOf(arm, solution.values)));
    solution.branch = signs + 8 * count[static_cast<std::size_t>(signs)]++;
  }
}

}  // namespace

SevenAxisInverse::SevenAxisInverse(const SerialChain& arm)
    : arm_(sevenAxes(arm)), centred_(movedAxes(arm_, 0.0)) {
  const double offset = offsetOf(arm_);
  deviation_ = std::max(offset, tiltOf(arm_));
  is_followed_ = offset > kMeets;
}

SevenSolutions SevenAxisInverse::solutions(const Eigen::Isometry3d& bed_from_nozzle, double arm_angle,
                                           const SevenValues& near) const {
  const bool is_exact = deviation_ <= kAsMade;
  const SevenTarget target{bed_from_nozzle, arm_angle};
  const SevenSolutions starts =
      CentredSolver(centred_, bed_from_nozzle, near).all(arm_angle, is_exact ? 0.0 : kLeastBend);
  SevenSolutions found;
  for (const SevenSolution& start : starts) {
    std::optional<SevenValues> values = start.values;
    if (!is_exact)
      values = followed(arm_, target, is_followed_ ? ledOn(arm_, target, start.values) : start.values);
    if (!values || (is_followed_ && isAmong(found, *values))) continue;
    found.push_back({start.branch, values->unaryExpr(&wrappedRadians)});
  }
  if (is_followed_) renumber(found, arm_);
  std::sort(found.begin(), found.end(),
            [](const SevenSolution& a, const SevenSolution& b) { return a.branch < b.branch; });
  return found;
}

double SevenAxisInverse::armAngle(const SevenValues& values) const {
  return lamina::armAngle(arm_, postureOf(arm_, values));
}

double SevenAxisInverse::singularityMargin(const SevenValues& values) const {
  const SevenSines sines = sinesOf(arm_, postureOf(arm_, values));
  return std::min({std::abs(sines.shoulder), std::abs(sines.elbow), std::abs(sines.wrist), sines.plane});
}

}  // namespace lamina
