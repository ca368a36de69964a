// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "kinematics/joint_path/rung.hpp"
#include "kinematics/joint_path/stations.hpp"
#include "kinematics/model/joint_ranges.hpp"
#include "lamina/kinematics/joint_path/joint_path_settings.hpp"

namespace lamina {

/// Whether a straight motion in joint space between two sets of values of different branches moves the nozzle
/// as the toolpath asks. Then the motion passes a singularity at which the branches meet.
using SteadyCrossing = std::function<bool(const double* from, const double* to)>;

/// Finds the cheapest path along a ladder of rungs by dynamic programming. A rung is needed only until the
/// next but one arrives; 2 bytes are kept for each of its nodes.
///
/// The cost of an edge is the sum of the squared turns of the joints over their greatest speeds and of the
/// squared turn of the yaw, over the duration of the motion, plus the penalty of the node at its end times
/// the duration. Two nodes are joined
/// - within a branch, if their samples are at most `yaw_reach` and one row apart and, except on a travel, no
///   joint turns by more than `max_turn_deg`. Where a joint becomes free it may turn to any sample,
///   over as many rungs as `yaw_reach` needs for half a turn: it may be free for no longer;
/// - between branches, if the crossing is steady and samples are not yaws;
/// - on a clear travel always, at `branch_change_cost`; if nodes are so many that this would take long, only
///   from the cheapest node of each branch.
class LadderSearch {
 public:
  LadderSearch(std::vector<JointRange> ranges, const JointPathSettings& settings, SteadyCrossing crossing);

  /// How a rung is joined to the previous one.
  enum class Link : std::uint8_t {
    Start,  ///< nothing is before it
    Joined,
    Cut,    ///< both have nodes, and no edge joins them
    Empty,  ///< it has no node
  };
  Link advance(Rung rung, const StationMotion& motion);

  /// Gap between two rungs that no edge joins, described by the least turn of the joint that turns most.
  struct Cut {
    std::size_t joint = 0;
    double turn = 0.0;      ///< [mm, rad]; infinite if there is no node of the branch
    bool is_wound = false;  ///< whether only a whole turn of the joint prevents an edge
  };
  const Cut& lastCut() const { return cut_; }

  /// The chosen node of each rung, kNoNode where there is none.
  std::vector<NodeId> trace() const;

 private:
  struct RungRecord {
    std::size_t first_back = 0;
    NodeId end = kNoNode;  ///< end of the path, if the next rung is not joined
    std::uint8_t branches = 0;
  };
  struct Reached {
    double cost;
    NodeId from;
  };

  /// A node that edges lead to.
  struct Target {
    const Rung& rung;
    std::size_t slot = 0;
    int branch = 0;
    int in_row = 0;   ///< number of its sample within its row
    int per_row = 1;  ///< samples of its rung
    const StationMotion& motion;
  };
  /// A node that an edge sets out from.
  struct Departure {
    std::size_t slot = 0;
    NodeId id = kNoNode;
    int in_row = 0;  ///< number of its sample within a row as long as the target's
  };

  double edge(const double* from, const double* to, double most_turn_factor) const;
  bool standsStill(const double* from, const double* to, const StationMotion& motion) const;
  double yawCost(int from, int to) const;
  void setYawCosts(const Rung& rung);
  void reachAll(const Rung& rung, const StationMotion& motion, std::vector<Reached>& reached) const;
  int reachOf(const Rung& rung) const;
  void reach(const Target& target, Reached& best) const;
  void reachFrom(const Target& target, int sample, Reached& best) const;
  void tryEdge(const Target& target, const Departure& from, Reached& best) const;
  void overTravel(const Rung& rung, const StationMotion& motion, std::vector<Reached>& reached) const;
  std::vector<std::size_t> departures(std::size_t nodes) const;
  void finishBefore();
  Cut cutBetween(const double* from, const double* to) const;
  Cut cutBefore(const Rung& rung) const;

  std::vector<JointRange> ranges_;
  JointPathSettings settings_;
  SteadyCrossing crossing_;
  std::vector<double> weights_;
  std::vector<double> half_periods_;
  std::vector<double> most_turn_;
  std::vector<double> yaw_costs_;  ///< cost by distance in samples, for the newest rung of yaws
  Rung before_;
  int free_rungs_ = 0;  ///< number of rungs of a free joint in a row, up to `before_`
  std::vector<double> cost_;
  std::vector<RungRecord> records_;
  std::vector<NodeId> back_;
  Cut cut_;
};

}  // namespace lamina
