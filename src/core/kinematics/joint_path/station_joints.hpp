// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "kinematics/joint_path/rung.hpp"
#include "kinematics/joint_path/rung_solver.hpp"
#include "kinematics/joint_path/rung_store.hpp"
#include "kinematics/joint_path/stations.hpp"
#include "lamina/base/progress.hpp"
#include "lamina/kinematics/joint_path/joint_path.hpp"

namespace lamina {

/// Input of the search for joint values. The objects referred to must outlive it.
struct StationTask {
  const std::vector<Station>& stations;
  const KinematicModel& model;
  const RungSolver& solver;
  const JointPathSettings& settings;
};

/// Joint values found for one station.
struct StationJoints {
  SampleKind kind = SampleKind::Single;
  NodeId node = kNoNode;
  bool is_linked = false;  ///< whether an edge leads here from the station before
  JointValues values;  ///< of size 0 if there is no node; rotary ones are nearest to the middle of the limits
};

/// A station that cannot be run.
struct StationFault {
  std::size_t station = 0;
  JointFault fault = JointFault::OutOfReach;
  std::string reason;
};

/// The cheapest path through all stations, and the stations at which it is interrupted.
struct StationWayThrough {
  std::vector<StationJoints> stations;
  std::vector<StationFault> faults;  ///< stations without a node, and jumps, in the order of stations
};

/// Searches the cheapest path. Rungs are computed in parallel and in blocks: only few are in memory besides
/// those of the store.
StationWayThrough searchLadder(const StationTask& task, RungStore& rungs, Progress& progress);

/// Smooths the sampled angles of each run of stations in one branch. A run is left unchanged if the smoothed
/// angles cannot be reached at one of its stations, or would turn a joint by more than the settings allow.
void smoothSamples(std::vector<StationJoints>& joints, const StationTask& task, Progress& progress);

/// Reduces swings of the rotary joint whose axis is nearly along the tool axis of a machine: the joint turns
/// no more than needed to keep the tool axis within `swing_tolerance_deg` of the requested one, with the tip
/// unchanged. A run is left unchanged if one of its stations cannot be reached this way. Joint values of
/// machines of other kinds are left unchanged.
void steadySwings(std::vector<StationJoints>& stations, const StationTask& task);

/// Stations near a singularity at which a joint would slow down the feed by more than the settings allow.
/// @param joints  unwound (`unwind`)
std::vector<StationFault> slowPassages(const std::vector<StationJoints>& joints, const StationTask& task);

}  // namespace lamina
