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

/// Whether joints that go steadily from one set of values to another, of two branches, lead the nozzle as the
/// toolpath asks: then they pass a singularity and the branch has no meaning there.
using SteadyCrossing = std::function<bool(const double* from, const double* to)>;

/// The cheapest way along a ladder of rungs, by dynamic programming; a rung is needed only until the next but
/// one comes, and 2 bytes are kept for each of its nodes.
///
/// An edge costs the squared turns of the joints over their greatest speeds and the squared turn of the yaw,
/// over the duration of the motion, and what standing at its end costs for that long. Nodes are joined
/// - within a branch, their samples `yaw_reach` apart at most, no joint turning by more than `max_turn_deg`
///   unless on a travel;
/// - from one branch to another where the crossing is steady, if samples are not yaws;
/// - on a clear travel between any two, at `branch_change_cost` (from the cheapest node of each branch where
///   there are so many that the work would show).
class LadderSearch {
 public:
  LadderSearch(std::vector<JointRange> ranges, const JointPathSettings& settings, SteadyCrossing crossing);

  /// Whether the rung is joined to the one before.
  enum class Link : std::uint8_t {
    Start,  ///< nothing is before it
    Joined,
    Cut,    ///< both have nodes, and no edge joins them
    Empty,  ///< it has no node
  };
  Link advance(Rung rung, const StationMotion& motion);

  /// Where a ladder is cut: the least turn of the joint that turns most.
  struct Cut {
    std::size_t joint = 0;
    double turn = 0.0;      ///< [mm, rad]; infinite if there is no node of the branch
    bool is_wound = false;  ///< it would be joined but for a whole turn of the joint
  };
  const Cut& lastCut() const { return cut_; }

  /// The node of each rung, kNoNode where there is none.
  std::vector<NodeId> trace() const;

 private:
  struct RungRecord {
    std::size_t first_back = 0;
    NodeId end = kNoNode;  ///< where the way ends, if the next rung is not joined
    std::uint8_t branches = 0;
  };
  struct Reached {
    double cost;
    NodeId from;
  };

  double edge(const double* from, const double* to, double most_turn_factor) const;
  bool standsStill(const double* from, const double* to, const StationMotion& motion) const;
  double sampleTurn(int from, int to, int samples) const;
  void reach(const Rung& rung, std::size_t slot, const StationMotion& motion, Reached& best) const;
  void tryEdge(const Rung& rung, std::size_t slot, std::size_t from_slot, const StationMotion& motion,
               Reached& best) const;
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
  Rung before_;
  std::vector<double> cost_;
  std::vector<RungRecord> records_;
  std::vector<NodeId> back_;
  Cut cut_;
};

}  // namespace lamina
