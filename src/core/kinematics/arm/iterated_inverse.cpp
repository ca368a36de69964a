// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <cmath>
#include <kdl/chain.hpp>
#include <kdl/chainiksolverpos_lma.hpp>

#include "kinematics/arm/arm_inverse.hpp"
#include "kinematics/arm/newton_refinement.hpp"
#include "lamina/base/random.hpp"

namespace lamina {
namespace {

constexpr double kParallel = 1e-3;  // rad: more than the rounding of any description

using Axes = std::array<Screw, 6>;

Axes axesAt(const SerialChain& arm, const ArmValues& values) {
  Axes axes;
  Eigen::Isometry3d moved = Eigen::Isometry3d::Identity();
  for (std::size_t j = 0; j < axes.size(); ++j) {
    const Screw& screw = arm.screws[j];
    axes[j] = {moved.linear() * screw.direction, moved * screw.point};
    moved = moved * Eigen::Translation3d(screw.point) *
            Eigen::AngleAxisd(values[static_cast<Eigen::Index>(j)], screw.direction) *
            Eigen::Translation3d(-screw.point);
  }
  return axes;
}

bool areParallel(const Screw& a, const Screw& b) { return a.direction.cross(b.direction).norm() < kParallel; }

/// The point of an axis nearest to another, which is no parallel.
Point3 nearest(const Screw& on, const Screw& to) {
  const Point3 common = on.direction.cross(to.direction);
  const double along = (to.point - on.point).cross(to.direction).dot(common) / common.squaredNorm();
  return on.point + along * on.direction;
}

double shoulderSine(const Axes& axes) {
  if (areParallel(axes[0], axes[1])) return 1.0;
  const Point3& up = axes[0].direction;
  const Point3 wrist = areParallel(axes[4], axes[5]) ? axes[4].point : nearest(axes[4], axes[5]);
  const Point3 from_base = wrist - axes[0].point;
  const double height = up.dot(wrist - axes[1].point);
  const double front = axes[1].direction.cross(up).normalized().dot(from_base);
  const double distance = std::hypot(front, height);
  return distance > 0.0 ? front / distance : 0.0;
}

double elbowSine(const Axes& axes) {
  if (!areParallel(axes[1], axes[2])) return 1.0;
  const Point3& axis = axes[1].direction;
  const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - axis * axis.transpose();
  const bool goes_on = areParallel(axes[2], axes[3]) || areParallel(axes[3], axes[4]);
  const Point3 end = goes_on ? axes[3].point : nearest(axes[3], axes[4]);
  const Point3 upper = across * (axes[2].point - axes[1].point);
  const Point3 fore = across * (end - axes[2].point);
  const double size = upper.norm() * fore.norm();
  return size > 0.0 ? axis.dot(upper.cross(fore)) / size : 0.0;
}

/// Sines of an arm of any geometry; 1 where one is not defined:
/// shoulder if axis 2 is no parallel of axis 1, by the point of axis 5 that is nearest to axis 6;
/// elbow if axes 2 and 3 are parallel, by axis 4, or where it is nearest to axis 5 if it is no parallel of 3;
/// wrist as the triple product of axes 4, 5 and 6.
ArmSines generalSines(const SerialChain& arm, const ArmValues& values) {
  const Axes axes = axesAt(arm, values);
  ArmSines sines;
  sines.shoulder = shoulderSine(axes);
  sines.elbow = elbowSine(axes);
  sines.wrist = axes[3].direction.cross(axes[5].direction).dot(axes[4].direction);
  return sines;
}

constexpr std::size_t kStarts = 40;      // where arms with offset wrists showed all their branches
constexpr std::size_t kAllBranches = 8;  // of three signs
constexpr std::uint64_t kSeed = 6;       // any: the same starts for every pose
constexpr double kGoal = 1e-4;           // near enough for Newton's method: m and rad
constexpr int kMostIterations = 100;
constexpr double kMetres = 1e-3;  // in a millimetre: KDL weighs lengths against angles in metres

KDL::Vector vectorOf(const Point3& point) { return {point.x(), point.y(), point.z()}; }

KDL::Frame frameOf(const Eigen::Isometry3d& pose) {
  const Eigen::Matrix3d& r = pose.linear();
  return {KDL::Rotation(r(0, 0), r(0, 1), r(0, 2), r(1, 0), r(1, 1), r(1, 2), r(2, 0), r(2, 1), r(2, 2)),
          vectorOf(kMetres * pose.translation())};
}

KDL::Chain kdlChain(const SerialChain& arm) {
  KDL::Chain chain;
  for (const Screw& screw : arm.screws) {
    const KDL::Joint joint(vectorOf(kMetres * screw.point), vectorOf(screw.direction), KDL::Joint::RotAxis);
    const bool is_last = &screw == &arm.screws.back();
    chain.addSegment(
        KDL::Segment(joint, is_last ? frameOf(arm.bed_from_nozzle_at_zero) : KDL::Frame::Identity()));
  }
  return chain;
}

/// Greatest difference of two configurations [rad].
double distance(const ArmValues& a, const ArmValues& b) {
  return (a - b)
      .unaryExpr([](double angle) { return std::abs(std::remainder(angle, 2.0 * M_PI)); })
      .maxCoeff();
}

/// Searches the solutions of one pose.
class Search {
 public:
  Search(const SerialChain& arm, const KDL::Chain& chain, const Eigen::Isometry3d& pose)
      : arm_(arm), pose_(pose), target_(frameOf(pose)), solver_(chain, kGoal, kMostIterations) {}

  /// Of several solutions of a branch the one nearest to `near` is kept.
  ArmSolutions run(const ArmValues& near) {
    tryFrom(near, near);
    Random random(kSeed);
    for (std::size_t start = 0; start < kStarts && found_.size() < kAllBranches; ++start)
      tryFrom(ArmValues::NullaryExpr([&] { return random.uniform(-M_PI, M_PI); }), near);
    std::sort(found_.begin(), found_.end(),
              [](const ArmSolution& a, const ArmSolution& b) { return a.branch < b.branch; });
    return found_;
  }

 private:
  void tryFrom(const ArmValues& start, const ArmValues& near) {
    KDL::JntArray from(6);
    KDL::JntArray to(6);
    from.data = start;
    solver_.CartToJnt(from, target_, to);
    const auto values = refined(arm_, pose_, to.data);
    if (!values) return;
    const ArmSolution solution{branchOf(generalSines(arm_, *values)), *values};
    const auto same = std::find_if(found_.begin(), found_.end(),
                                   [&](const ArmSolution& known) { return known.branch == solution.branch; });
    if (same == found_.end())
      found_.push_back(solution);
    else if (distance(solution.values, near) < distance(same->values, near))
      *same = solution;
  }

  const SerialChain& arm_;
  const Eigen::Isometry3d& pose_;
  KDL::Frame target_;
  KDL::ChainIkSolverPos_LMA solver_;
  ArmSolutions found_;
};

class IteratedInverse : public ArmInverse {
 public:
  explicit IteratedInverse(const SerialChain& arm) : arm_(arm), chain_(kdlChain(arm)) {}

  ArmSolutions solutions(const Eigen::Isometry3d& bed_from_nozzle, const ArmValues& near) const override {
    return Search(arm_, chain_, bed_from_nozzle).run(near);
  }

  ArmSines sines(const ArmValues& values) const override { return generalSines(arm_, values); }

  double singularityMargin(const ArmValues& values) const override {
    Eigen::Matrix<double, 6, 6> columns = jacobian(arm_, values);
    const double reach_mm = columns.topRows<3>().colwise().norm().maxCoeff();
    columns.topRows<3>() /= reach_mm;
    const ArmValues singular = Eigen::JacobiSVD<Eigen::Matrix<double, 6, 6>>(columns).singularValues();
    return singular[5] / singular[0];
  }

 private:
  SerialChain arm_;
  KDL::Chain chain_;
};

}  // namespace

std::unique_ptr<const ArmInverse> iteratedInverse(const SerialChain& arm) {
  return std::make_unique<IteratedInverse>(arm);
}

}  // namespace lamina
