// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Stations in between, so that joints that move steadily keep tip and tool axis on the way.
#include <optional>
#include <string>

#include "lamina/base/error.hpp"
#include "lamina/geometry/shortest_rotation.hpp"
#include "lamina/toolpath/waypoint_text.hpp"
#include "trajectory/joint_stations.hpp"
#include "trajectory/pose_correction.hpp"

namespace lamina {
namespace {

constexpr int kMostHalvings = 24;

Eigen::Isometry3d halfway(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) {
  Eigen::Isometry3d middle = Eigen::Isometry3d::Identity();
  middle.translation() = 0.5 * (a.translation() + b.translation());
  // The turn about the tool axis is no part of what is asked: the tool axes' great circle counts.
  const auto turn = shortestRotation(a.linear().col(2), b.linear().col(2));
  middle.linear() = Eigen::Quaterniond::Identity().slerp(0.5, turn).toRotationMatrix() * a.linear();
  return middle;
}

class LineKeeper {
 public:
  LineKeeper(const KinematicModel& model, const TrajectorySettings& settings)
      : model_(model), correction_(model, settings) {}

  /// Appends the stations after `from` up to and with `to`.
  void append(JointStations& out, const JointStation& from, const JointStation& to, int halvings) const {
    JointStation middle = to;
    middle.values = 0.5 * (from.values + to.values);
    middle.pose = model_.bedFromNozzle(middle.values);
    const Eigen::Isometry3d asked = halfway(from.pose, to.pose);
    if (correction_.isWithin(middle.pose, asked)) return out.each.push_back(to);
    auto kept = corrected(middle.values, asked, correction_.distance(from.values, to.values));
    if (!kept || halvings == kMostHalvings) {
      if (to.area_mm2 == 0.0) return appendLoose(out, to);
      throw Unreachable("the straight way to " + toText(to.heading_for) + " cannot be followed by '" +
                        model_.name() + "' within the tolerance on lines; is it near a singularity?");
    }
    middle.values = *kept;
    middle.pose = model_.bedFromNozzle(middle.values);
    middle.length_mm = 0.5 * to.length_mm;
    middle.is_smooth = true;
    middle.dwell_s = 0.0;
    JointStation rest = to;
    rest.length_mm = middle.length_mm;
    append(out, from, middle, halvings + 1);
    append(out, middle, rest, halvings + 1);
  }

 private:
  static void appendLoose(JointStations& out, const JointStation& to) {
    out.each.push_back(to);
    if (out.loose.empty() || out.loose.back() != to.heading_for) out.loose.push_back(to.heading_for);
  }

  /// Joint values near `values` with the tip as asked: with the tool axis as it comes where that is good
  /// enough, which passes singularities steadily, else with the tool axis as asked too, or as it comes where
  /// there is no such way.
  std::optional<JointValues> corrected(const JointValues& values, const Eigen::Isometry3d& asked,
                                       double farthest) const {
    const auto near = [&](PoseCorrection::Keep keep) {
      auto found = correction_.near(values, asked, keep);
      if (found && correction_.distance(*found, values) > farthest) found.reset();
      return found;
    };
    auto by_tip = near(PoseCorrection::Keep::Tip);
    if (by_tip && correction_.isWithin(model_.bedFromNozzle(*by_tip), asked)) return by_tip;
    auto by_both = near(PoseCorrection::Keep::TipAndToolAxis);
    return by_both ? by_both : by_tip;
  }

  const KinematicModel& model_;
  PoseCorrection correction_;
};

}  // namespace

JointStations keptOnLines(const JointStations& stations, const KinematicModel& model,
                          const TrajectorySettings& settings) {
  const LineKeeper keeper(model, settings);
  JointStations kept;
  kept.each.reserve(stations.each.size());
  kept.each.push_back(stations.each.front());
  std::vector<std::size_t> new_index(1, 0);
  for (std::size_t i = 1; i < stations.each.size(); ++i) {
    keeper.append(kept, stations.each[i - 1], stations.each[i], 0);
    new_index.push_back(kept.each.size() - 1);
  }
  kept.of_path.reserve(stations.of_path.size());
  for (const std::size_t index : stations.of_path) kept.of_path.push_back(new_index[index]);
  return kept;
}

}  // namespace lamina
