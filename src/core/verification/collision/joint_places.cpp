// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "verification/collision/joint_places.hpp"

#include <algorithm>
#include <cmath>
#include <deque>

#include "verification/collision/deposited_boxes.hpp"

namespace lamina {
namespace {

constexpr double kFreshWidths = 1.5;  // of the bead: what the nozzle has just left is soft, and has its shape
constexpr double kJointTurn = 5.0 * M_PI / 180.0;  // of a joint between places

const Path& pathAt(const JointRun& run, std::size_t station) {
  const WaypointIndex& at = run.path.at[station];
  return run.toolpath.layers[at.layer].paths[at.path];
}

const Point3& pointAt(const JointRun& run, std::size_t station) {
  return pathAt(run, station).points[run.path.at[station].waypoint];
}

/// Boxes that are set once the nozzle has gone so far.
struct Fresh {
  double set_at_mm = 0.0;
  std::size_t boxes = 0;
};

bool startsPath(const JointRun& run, std::size_t station) {
  if (station == 0) return true;
  const WaypointIndex& at = run.path.at[station];
  const WaypointIndex& before = run.path.at[station - 1];
  return at.layer != before.layer || at.path != before.path;
}

double greatestTurn(const JointRun& run, const JointValues& from, const JointValues& to) {
  double greatest = 0.0;
  const std::vector<DrivenJoint>& joints = run.model.joints();
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const auto i = static_cast<Eigen::Index>(j);
    if (joints[j].kind == JointKind::Rotary) greatest = std::max(greatest, std::abs(to[i] - from[i]));
  }
  return greatest;
}

}  // namespace

std::vector<std::size_t> depositedBeforeStations(const JointRun& run, double tolerance_mm) {
  std::vector<std::size_t> deposited(run.path.at.size());
  std::deque<Fresh> fresh;
  std::size_t set = 0;  // boxes
  std::size_t all = 0;
  double way_mm = 0.0;
  for (std::size_t s = 0; s < deposited.size(); ++s) {
    while (!fresh.empty() && fresh.front().set_at_mm <= way_mm) {
      set = fresh.front().boxes;
      fresh.pop_front();
    }
    deposited[s] = set;
    const Path& path = pathAt(run, s);
    const bool starts = startsPath(run, s);
    if (!starts) way_mm += (pointAt(run, s) - pointAt(run, s - 1)).norm();
    // The first station of a closed path is its start; its return to there comes last.
    if (path.is_closed && starts) continue;
    all += piecesDepositedAt(path, run.path.at[s].waypoint, tolerance_mm);
    fresh.push_back({way_mm + kFreshWidths * path.bead.at(run.path.at[s].waypoint).width_mm, all});
  }
  return deposited;
}

std::vector<JointValues> placesBefore(const JointRun& run, std::size_t station,
                                      const ClearanceSettings& settings) {
  const JointValues& to = run.path.values[station];
  if (to.size() == 0) return {};
  if (station == 0 || run.path.values[station - 1].size() == 0) return {to};
  const JointValues& from = run.path.values[station - 1];
  const double way =
      (run.model.bedFromNozzle(to).translation() - run.model.bedFromNozzle(from).translation()).norm();
  const int steps = std::max({1, static_cast<int>(std::ceil(way / settings.spacing_mm)),
                              static_cast<int>(std::ceil(greatestTurn(run, from, to) / kJointTurn))});
  std::vector<JointValues> places;
  for (int i = 1; i < steps; ++i) places.push_back(from + static_cast<double>(i) / steps * (to - from));
  places.push_back(to);
  return places;
}

}  // namespace lamina
