// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/joint_path/rung_solver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "kinematics/model/external_joint.hpp"
#include "lamina/base/angle.hpp"
#include "lamina/geometry/shortest_rotation.hpp"

namespace lamina {

namespace {

/// Nearer to a singularity than this [rad] a pose is taken into it: a joint would swing for less than
/// a waypoint's orientation is accurate to.
constexpr double kExactlySingular = 1e-7;

/// The pose with the nozzle turned about its tool axis.
Eigen::Isometry3d yawed(const Eigen::Isometry3d& bed_from_nozzle, double yaw) {
  const double c = std::cos(yaw);
  const double s = std::sin(yaw);
  Eigen::Isometry3d turned = bed_from_nozzle;
  turned.matrix().col(0) = c * bed_from_nozzle.matrix().col(0) + s * bed_from_nozzle.matrix().col(1);
  turned.matrix().col(1) = c * bed_from_nozzle.matrix().col(1) - s * bed_from_nozzle.matrix().col(0);
  return turned;
}

/// Without nodes.
Rung roomFor(SampleKind kind, int samples, int branches, std::size_t joints) {
  Rung rung;
  rung.kind = kind;
  rung.samples = samples;
  rung.joints = static_cast<int>(joints);
  rung.branches = branches;
  const std::size_t nodes = rung.slot(rung.samples, 0);
  rung.values.resize(nodes * static_cast<std::size_t>(rung.joints));
  rung.penalty.assign(nodes, std::numeric_limits<double>::infinity());
  return rung;
}

/// The same nodes, with room for another number of branches.
Rung withBranches(const Rung& from, int branches) {
  Rung rung = roomFor(from.kind, from.samples, branches, static_cast<std::size_t>(from.joints));
  const auto per_sample = static_cast<std::ptrdiff_t>(std::min(from.branches, branches));
  for (int s = 0; s < from.samples; ++s) {
    const auto to = static_cast<std::ptrdiff_t>(rung.slot(s, 0));
    const auto own = static_cast<std::ptrdiff_t>(from.slot(s, 0));
    std::copy_n(from.penalty.begin() + own, per_sample, rung.penalty.begin() + to);
    std::copy_n(from.values.begin() + own * from.joints, per_sample * from.joints,
                rung.values.begin() + to * rung.joints);
  }
  return rung;
}

std::string marginText(double margin) { return angleText(std::asin(std::clamp(margin, 0.0, 1.0))); }

}  // namespace

RungSolver::RungSolver(const GuardedModel& guarded, const JointPathSettings& settings)
    : RungSolver(guarded, settings, jointRanges(guarded.model.joints())) {}

RungSolver::RungSolver(const GuardedModel& guarded, const JointPathSettings& settings,
                       std::vector<JointRange> ranges)
    : model_(&guarded.model),
      guard_(&guarded.guard),
      settings_(settings),
      ranges_(std::move(ranges)),
      least_margin_(std::sin(settings.least_margin_deg * kDegree)),
      avoided_margin_(std::sin(settings.singular_margin_deg * kDegree)) {
  for (const DrivenJoint& joint : model_->joints()) is_external_.push_back(isExternal(joint.name));
}

JointValues RungSolver::nearFor(const std::array<double, 3>& external) const {
  JointValues near(static_cast<Eigen::Index>(ranges_.size()));
  std::size_t next_external = 0;
  for (std::size_t j = 0; j < ranges_.size(); ++j)
    near[static_cast<Eigen::Index>(j)] = is_external_[j] ? external.at(next_external++) : ranges_[j].middle;
  return near;
}

JointValues RungSolver::withFree(JointValues near, double free_value) const {
  for (std::size_t j = 0; j < ranges_.size(); ++j)
    if (ranges_[j].is_rotary && !is_external_[j]) near[static_cast<Eigen::Index>(j)] = free_value;
  return near;
}

RungSolver::Asked RungSolver::askedAt(const Station& station) const {
  Asked asked{SampleKind::Single, station.pose(), nearFor(station.external), station.redundancy};
  const bool is_free = model_->toolAxisSpin() == ToolAxisSpin::Free;
  if (!is_free && settings_.yaw == YawChoice::Free) {
    asked.kind = SampleKind::Yaw;
    return asked;
  }
  const InverseSolutions found = inverse(asked, asked.bed_from_nozzle, asked.near);
  asked.found.assign(found.begin(), found.end());
  if (found.empty()) return asked;
  const JointValues& values = asked.found.front().values;
  const double margin = model_->singularityMargin(values);
  const double tolerance =
      std::max(kExactlySingular, is_free ? settings_.singular_tool_axis_tolerance_deg * kDegree : 0.0);
  if (margin > std::sin(tolerance)) return asked;
  asked.kind = SampleKind::FreeJoint;
  if (is_free) asked.bed_from_nozzle = passing(asked.bed_from_nozzle, values);
  return asked;
}

/// The pose with its tool axis along the rotary axis next to it, about which the joint is then free.
Eigen::Isometry3d RungSolver::passing(const Eigen::Isometry3d& bed_from_nozzle,
                                      const JointValues& values) const {
  const Jacobian jacobian = model_->jacobian(values);
  const Point3 tool_axis = bed_from_nozzle.linear().col(2);
  Point3 nearest = tool_axis;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t j = 0; j < ranges_.size(); ++j) {
    if (!ranges_[j].is_rotary || is_external_[j]) continue;
    const Point3 axis = jacobian.col(static_cast<Eigen::Index>(j)).tail<3>().normalized();
    const double sine = axis.cross(tool_axis).norm();
    if (sine >= least) continue;
    least = sine;
    nearest = axis.dot(tool_axis) < 0.0 ? Point3(-axis) : axis;
  }
  Eigen::Isometry3d passed = bed_from_nozzle;
  passed.linear() = shortestRotation(tool_axis, nearest) * bed_from_nozzle.linear();
  return passed;
}

InverseSolutions RungSolver::inverse(const Asked& asked, const Eigen::Isometry3d& bed_from_nozzle,
                                     const JointValues& near) const {
  const Redundancy* const redundancy = model_->redundancy();
  if (redundancy == nullptr) return model_->solutions(bed_from_nozzle, near);
  return redundancy->solutionsWith(bed_from_nozzle, near, asked.redundancy);
}

InverseSolutions RungSolver::solutionsAt(const Asked& asked, double coordinate) const {
  InverseSolutions found;
  if (asked.kind == SampleKind::FreeJoint)
    found = inverse(asked, asked.bed_from_nozzle, withFree(asked.near, coordinate));
  else if (asked.kind == SampleKind::Single && !asked.found.empty())
    found.assign(asked.found.begin(), asked.found.end());
  else
    found = inverse(asked, yawed(asked.bed_from_nozzle, coordinate), asked.near);
  for (InverseSolution& solution : found)
    for (std::size_t j = 0; j < ranges_.size(); ++j) {
      double& value = solution.values[static_cast<Eigen::Index>(j)];
      value = nearMiddle(ranges_[j], value);
    }
  return found;
}

bool RungSolver::isWithinLimits(const JointValues& values) const {
  for (std::size_t j = 0; j < ranges_.size(); ++j)
    if (!isWithin(ranges_[j], values[static_cast<Eigen::Index>(j)])) return false;
  return true;
}

bool RungSolver::isAllowed(const JointValues& values) const {
  return isWithinLimits(values) && guard_->allows(values);
}

double RungSolver::penaltyOf(const JointValues& values) const {
  const double margin = model_->singularityMargin(values);
  if (margin < least_margin_) return std::numeric_limits<double>::infinity();
  double penalty = margin < avoided_margin_
                       ? settings_.singular_weight * std::pow(1.0 - margin / avoided_margin_, 2)
                       : 0.0;
  const double near_limit = settings_.limit_margin_deg * kDegree;
  for (std::size_t j = 0; j < ranges_.size(); ++j) {
    if (!ranges_[j].is_rotary || ranges_[j].winds) continue;
    const double value = values[static_cast<Eigen::Index>(j)];
    const double room = std::max(0.0, std::min(value - ranges_[j].low, ranges_[j].high - value));
    if (room < near_limit) penalty += settings_.limit_weight * std::pow(1.0 - room / near_limit, 2);
  }
  return penalty;
}

void RungSolver::addNode(const InverseSolution& solution, std::size_t slot, Rung& rung) const {
  if (!isAllowed(solution.values)) return;
  rung.penalty[slot] = penaltyOf(solution.values);
  std::copy_n(solution.values.data(), ranges_.size(),
              rung.values.begin() + static_cast<std::ptrdiff_t>(slot * ranges_.size()));
}

Rung RungSolver::solve(const Station& station) const {
  const Asked asked = askedAt(station);
  const int samples = asked.kind == SampleKind::Single ? 1 : settings_.yaw_samples;
  Rung rung = roomFor(asked.kind, samples, kUsualBranches, ranges_.size());
  int branches = 0;
  for (int s = 0; s < samples; ++s) {
    const InverseSolutions found = solutionsAt(asked, coordinateOf(asked.kind, nodeId(s, 0)));
    for (const InverseSolution& solution : found) {
      branches = std::max(branches, solution.branch + 1);
      if (branches > rung.branches) rung = withBranches(rung, branches);
      addNode(solution, rung.slot(s, solution.branch), rung);
    }
  }
  if (branches != rung.branches) return withBranches(rung, branches);
  return rung;
}

std::optional<JointValues> RungSolver::at(const Station& station, SampleKind kind, double coordinate,
                                          int branch) const {
  const Asked asked = askedAt(station);
  if (asked.kind != kind) return std::nullopt;
  for (const InverseSolution& solution : solutionsAt(asked, coordinate))
    if (solution.branch == branch && isAllowed(solution.values) && std::isfinite(penaltyOf(solution.values)))
      return solution.values;
  return std::nullopt;
}

double RungSolver::coordinateOf(SampleKind kind, NodeId node) const {
  if (kind == SampleKind::Single) return 0.0;
  return 2.0 * M_PI * sampleOf(node) / settings_.yaw_samples;
}

/// Of the joint that is furthest outside of its range, in ranges; 0 of an endless one.
double RungSolver::greatestExcess(const JointValues& values) const {
  double excess = 0.0;
  for (std::size_t j = 0; j < ranges_.size(); ++j) {
    const double value = values[static_cast<Eigen::Index>(j)];
    const double by = std::max(ranges_[j].low - value, value - ranges_[j].high);
    if (!isWithin(ranges_[j], value)) excess = std::max(excess, by / (ranges_[j].high - ranges_[j].low));
  }
  return excess;
}

/// Of the joint that is furthest outside, by its range.
RungSolver::Hindrance RungSolver::limitHindrance(const JointValues& values) const {
  double furthest = -1.0;
  Hindrance hindrance{JointFault::OutOfLimits, ""};
  for (std::size_t j = 0; j < ranges_.size(); ++j) {
    const JointRange& range = ranges_[j];
    const double value = values[static_cast<Eigen::Index>(j)];
    const double outside = std::max(range.low - value, value - range.high) / (range.high - range.low);
    if (isWithin(range, value) || outside <= furthest) continue;
    furthest = outside;
    const bool is_low = value < range.low;
    hindrance.reason = "joint " + model_->joints()[j].name + " would have to be at " +
                       jointValueText(range, value) + "; its " + (is_low ? "least" : "greatest") +
                       " value is " + jointValueText(range, is_low ? range.low : range.high);
  }
  return hindrance;
}

RungSolver::Hindrance RungSolver::hindrance(const Station& station) const {
  const Asked asked = askedAt(station);
  const int samples = asked.kind == SampleKind::Single ? 1 : settings_.yaw_samples;
  double best_margin = -1.0;
  std::string collision;
  double least_outside = std::numeric_limits<double>::infinity();
  JointValues least;
  for (int s = 0; s < samples; ++s)
    for (const InverseSolution& solution : solutionsAt(asked, coordinateOf(asked.kind, nodeId(s, 0)))) {
      const bool is_within = isWithinLimits(solution.values);
      if (is_within && !guard_->allows(solution.values)) {
        if (collision.empty()) collision = guard_->hindrance(solution.values);
      } else if (is_within) {
        best_margin = std::max(best_margin, model_->singularityMargin(solution.values));
      }
      const double outside = greatestExcess(solution.values);
      if (outside >= least_outside) continue;
      least_outside = outside;
      least = solution.values;
    }
  if (best_margin >= 0.0)
    return {JointFault::Singular, marginText(best_margin) + " from a singularity; must be " +
                                      angleText(settings_.least_margin_deg * kDegree) + " or more"};
  if (!collision.empty()) return {JointFault::SelfCollision, collision};
  if (std::isfinite(least_outside)) return limitHindrance(least);
  return {JointFault::OutOfReach, headHindrance(station)};
}

/// Where no values bring the nozzle.
std::string RungSolver::headHindrance(const Station& station) const {
  std::string where = "no values of the joints of " + model_->name() + " bring the nozzle there";
  const auto is_rotary = [](const JointRange& range) { return range.is_rotary; };
  if (std::any_of(ranges_.begin(), ranges_.end(), is_rotary)) return where;
  const JointValues any = JointValues::Zero(static_cast<Eigen::Index>(ranges_.size()));
  const Point3 held = model_->bedFromNozzle(any).linear().col(2);
  const Point3 asked = askedAt(station).bed_from_nozzle.linear().col(2);
  const double turn = std::atan2(held.cross(asked).norm(), held.dot(asked));
  return where + ": its head is fixed, and " + angleText(turn) + " off the tool axis asked for";
}

}  // namespace lamina
