// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/kinematics/joint_path/straight_moves.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "kinematics/model/external_joint.hpp"
#include "kinematics/model/joint_ranges.hpp"

namespace lamina {
namespace {

/// One motion of the nozzle, between two poses with known joints.
class StraightMove {
 public:
  StraightMove(const KinematicModel& model, const JointValues& from, const JointValues& to)
      : model_(model),
        ranges_(jointRanges(model.joints())),
        from_(from),
        to_(to),
        start_(model.bedFromNozzle(from)),
        end_(model.bedFromNozzle(to)) {}

  /// Joints at a part of the way.
  /// @param before  those at the place before
  /// @return of size 0 if the place is out of reach
  JointValues at(double fraction, const JointValues& before) const {
    Eigen::Isometry3d pose(
        Eigen::Quaterniond(start_.linear()).slerp(fraction, Eigen::Quaterniond(end_.linear())));
    pose.translation() = start_.translation() + fraction * (end_.translation() - start_.translation());
    JointValues near = before;
    for (std::size_t j = 0; j < ranges_.size(); ++j) {
      const auto index = static_cast<Eigen::Index>(j);
      if (isExternal(model_.joints()[j].name))
        near[index] = from_[index] + fraction * (to_[index] - from_[index]);
    }
    return nextTo(near, solutionsAt(pose, near, fraction));
  }

 private:
  /// The redundancy goes steadily from one end to the other, by the shorter way.
  InverseSolutions solutionsAt(const Eigen::Isometry3d& pose, const JointValues& near,
                               double fraction) const {
    const Redundancy* const redundancy = model_.redundancy();
    if (redundancy == nullptr) return model_.solutions(pose, near);
    const double start = redundancy->angleAt(from_);
    const double turn = std::remainder(redundancy->angleAt(to_) - start, 2.0 * M_PI);
    return redundancy->solutionsWith(pose, near, start + fraction * turn);
  }

  JointValues nextTo(const JointValues& near, const InverseSolutions& solutions) const {
    JointValues nearest;
    double least = std::numeric_limits<double>::infinity();
    for (const InverseSolution& solution : solutions) {
      JointValues values = solution.values;
      for (std::size_t j = 0; j < ranges_.size(); ++j) {
        const auto index = static_cast<Eigen::Index>(j);
        if (ranges_[j].is_rotary)
          values[index] = near[index] + std::remainder(values[index] - near[index], 2.0 * M_PI);
      }
      const double turn = (values - near).cwiseAbs().maxCoeff();
      if (turn >= least) continue;
      least = turn;
      nearest = std::move(values);
    }
    return nearest;
  }

  const KinematicModel& model_;
  std::vector<JointRange> ranges_;
  const JointValues& from_;
  const JointValues& to_;
  Eigen::Isometry3d start_;
  Eigen::Isometry3d end_;
};

/// The waypoints of a toolpath in the order of the motion.
std::vector<WaypointIndex> waypointsOf(const Toolpath& toolpath) {
  std::vector<WaypointIndex> at;
  for (std::size_t l = 0; l < toolpath.layers.size(); ++l)
    for (std::size_t p = 0; p < toolpath.layers[l].paths.size(); ++p) {
      const Path& path = toolpath.layers[l].paths[p];
      at.push_back({l, p, 0});
      for (std::size_t m = 0; m < path.motionCount(); ++m) at.push_back({l, p, path.motionEnd(m)});
    }
  return at;
}

/// Puts the joints in between into a path, motion by motion.
class Insertion {
 public:
  Insertion(const JointPath& coarse, const Toolpath& fine, const KinematicModel& model)
      : coarse_(coarse), model_(model), at_(waypointsOf(fine)) {
    result_.tool_axis_tolerance = coarse.tool_axis_tolerance;
    result_.rewinds = coarse.rewinds;
    result_.values.reserve(at_.size());
  }

  JointPath run(const std::vector<int>& steps) && {
    for (std::size_t i = 0; i < coarse_.at.size(); ++i) {
      if (steps[i] > 1) lead(i, steps[i]);
      keep(i);
    }
    result_.at = std::move(at_);
    return std::move(result_);
  }

 private:
  /// What is in between on the motion to a waypoint.
  void lead(std::size_t i, int steps) {
    const StraightMove move(model_, coarse_.values[i - 1], coarse_.values[i]);
    JointValues before = coarse_.values[i - 1];
    for (int s = 1; s < steps; ++s) {
      JointValues values = move.at(static_cast<double>(s) / steps, before);
      if (values.size() == 0)
        result_.faults.push_back({at_[result_.values.size()], JointFault::OutOfReach,
                                  "there is no solution on the straight way here"});
      else
        before = values;
      result_.values.push_back(std::move(values));
    }
  }

  void keep(std::size_t i) {
    const WaypointIndex& at = at_[result_.values.size()];
    for (; next_ < coarse_.faults.size() && coarse_.faults[next_].at == coarse_.at[i]; ++next_) {
      result_.faults.push_back(coarse_.faults[next_]);
      result_.faults.back().at = at;
    }
    result_.values.push_back(coarse_.values[i]);
  }

  const JointPath& coarse_;
  const KinematicModel& model_;
  std::vector<WaypointIndex> at_;
  std::size_t next_ = 0;  ///< fault
  JointPath result_;
};

/// Joints are known at both ends of what is divided.
void keepWholeWhereUnknown(std::vector<int>& steps, const JointPath& path) {
  for (std::size_t i = 0; i < steps.size(); ++i)
    if (i == 0 || path.values[i].size() == 0 || path.values[i - 1].size() == 0) steps[i] = 1;
}

bool isWhole(const std::vector<int>& steps) {
  return std::all_of(steps.begin(), steps.end(), [](int count) { return count == 1; });
}

}  // namespace

DividedJointPath alongStraightMoves(Toolpath toolpath, JointPath stated, const KinematicModel& model,
                                    const JointPathSettings& settings) {
  std::vector<int> steps = stepsWithin(toolpath, settings.division);
  DividedJointPath result;
  result.divided = undivided(std::move(toolpath));
  result.joints = std::move(stated);
  for (int division = 0;; ++division) {
    keepWholeWhereUnknown(steps, result.joints);
    if (!isWhole(steps)) {
      DividedToolpath finer = divided(result.divided, steps);
      result.joints = Insertion(result.joints, finer.toolpath, model).run(steps);
      result.divided = std::move(finer);
    }
    const auto deviations = motionDeviations(result.joints, result.divided.toolpath, model, settings);
    steps = stepsAgainst(deviations, settings.division);
    if (division == kMostDivisions || isWhole(steps)) return result;
  }
}

}  // namespace lamina
