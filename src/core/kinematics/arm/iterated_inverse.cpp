// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <kdl/chain.hpp>
#include <kdl/chainiksolverpos_lma.hpp>

#include "base/dense_solvers.hpp"
#include "kinematics/arm/arm_axes.hpp"
#include "kinematics/arm/arm_inverse.hpp"
#include "kinematics/arm/newton_refinement.hpp"
#include "lamina/base/random.hpp"

namespace lamina {
namespace {

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
    const ArmSolution solution{branchOf(generalSines(axesAt(arm_, *values))), *values};
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

  ArmSines sines(const ArmValues& values) const override { return generalSines(axesAt(arm_, values)); }

  double singularityMargin(const ArmValues& values) const override {
    Eigen::Matrix<double, 6, 6> columns = jacobian(arm_, values);
    const double reach_mm = columns.topRows<3>().colwise().norm().maxCoeff();
    columns.topRows<3>() /= reach_mm;
    const Eigen::VectorXd singular = singularValues(columns);
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
