// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "kinematics/joint_path/rung.hpp"
#include "kinematics/joint_path/rung_solver.hpp"
#include "kinematics/joint_path/stations.hpp"
#include "lamina/base/progress.hpp"
#include "lamina/kinematics/joint_path/joint_path.hpp"

namespace lamina {

/// What joints are looked for. The values must outlive it.
struct StationTask {
  const std::vector<Station>& stations;
  const KinematicModel& model;
  const RungSolver& solver;
  const JointPathSettings& settings;
};

/// What was found at one station.
struct StationJoints {
  SampleKind kind = SampleKind::Single;
  NodeId node = kNoNode;
  bool is_linked = false;  ///< there is an edge from the station before
  JointValues values;      ///< of size 0 where there is no node; rotary ones next to the middle of the limits
};

/// A station that cannot be run.
struct StationFault {
  std::size_t station = 0;
  JointFault fault = JointFault::OutOfReach;
  std::string reason;
};

/// The cheapest way through all stations.
struct StationWayThrough {
  std::vector<StationJoints> stations;
  std::vector<StationFault> faults;  ///< stations without a node, and jumps, in their order
};

/// Searches the ladder: rungs in parallel and in blocks, so that only few are held at a time.
StationWayThrough searchLadder(const StationTask& task, Progress& progress);

/// Evens out the sampled angles of each run of stations of one branch. A run of which a station cannot be
/// run so, or a joint would turn further than the settings allow, stays as it was.
void smoothSamples(std::vector<StationJoints>& joints, const StationTask& task, Progress& progress);

/// Lets the rotary joint that a machine's tool axis is nearly along swing no further than it must for the
/// tool axis to stay within `swing_tolerance_deg` of what is asked; the tip stays where it is. A run of which
/// a station could not be run so stays as it was, as does all on machines of other kinds.
void steadySwings(std::vector<StationJoints>& stations, const StationTask& task);

/// Where near a singularity a joint is too slow for the feed, by more than the settings allow.
/// @param joints  unwound
std::vector<StationFault> slowPassages(const std::vector<StationJoints>& joints, const StationTask& task);

}  // namespace lamina
