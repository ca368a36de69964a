// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "lamina/control/correction_map.hpp"
#include "lamina/control/loop_settings.hpp"
#include "lamina/control/run/missed_map.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"
#include "lamina/toolpath/toolpath.hpp"
#include "lamina/trajectory/trajectory_feeder.hpp"

namespace lamina {

/// A toolpath where it is driven.
struct DrivenToolpath {
  std::string id;
  Toolpath toolpath;  ///< as it is timed: its waypoints are those that states head for [mm, part frame]
  Eigen::Isometry3d bed_from_part = Eigen::Isometry3d::Identity();  ///< translation [mm]
};

/// What became of a layer's map.
struct DrivenLayer {
  std::string digest;  ///< of the map; empty if the layer is driven as planned
  MissedMap missed;    ///< what of the layer had been handed over before
};

/// Corrects a trajectory by the maps that came before it is handed over: the flow by the amount, the nozzle
/// back along its tool axis by the height, through the machine's inverse kinematics on the branch that it is
/// on. Times stay. What was handed over stays, too: heights go over from there at `kHeightSpeed` at most, so
/// that joints do not jump.
class ChunkCorrection {
 public:
  static constexpr double kHeightSpeed = 5.0;  ///< of the nozzle along its axis, by corrections [mm/s]

  /// @param settings  of which the feeder's delay and limits count; amounts are led by them
  /// @param model     must outlive this
  ChunkCorrection(DrivenToolpath toolpath, const LoopSettings& settings, const KinematicModel& model);

  /// @param digest  that the map is told under
  /// @return why the map is not used, in words; empty if it is used from now on
  std::string hear(const CorrectionMap& map, const std::string& digest);

  std::size_t layers() const { return driven_.toolpath.layers.size(); }
  /// Whether a layer has a map.
  bool isKnown(std::size_t layer) const { return maps_.count(layer) > 0; }

  /// The next chunk, corrected. Where a height cannot be reached, or would lead a joint out of its limits, it
  /// stays as it was.
  TrajectoryChunk corrected(TrajectoryChunk chunk);

  /// The first height of the last chunk that stayed as it was, in words: layer, path, joint, value and
  /// limits. Empty if there was none, or once it was taken.
  std::string takeRefusal() { return std::exchange(refusal_, {}); }

  /// Of the layers that it became clear of since the last call, once each: when their map came, or when all
  /// of them was handed over without one.
  std::vector<DrivenLayer> takeLayers() { return std::exchange(layers_, {}); }

 private:
  /// What is asked for at a point of the trajectory.
  struct Asked {
    double amount = 0.0;
    double dz_mm = 0.0;
  };

  void miss(std::size_t layer, const std::string& reason);
  void noteHandedOver(const TrajectoryChunk& chunk);
  const PathCorrection* find(const WaypointIndex& heading_for) const;
  Asked askedAt(const JointState& state) const;
  double alongAt(const JointState& state) const;
  double handedOver(double time_s) const;
  std::string defectOf(const JointValues& position) const;
  std::optional<JointValues> movedBack(const JointValues& position, double height_mm) const;
  double follow(const JointState& state, double present_mm, double wanted_mm);

  DrivenToolpath driven_;
  LoopSettings settings_;
  const KinematicModel& model_;
  Eigen::Isometry3d part_from_bed_;
  std::map<std::size_t, CorrectionMap> maps_;       ///< by layer, led
  std::vector<std::pair<double, double>> heights_;  ///< time and height of the last chunk [s, mm]
  std::string refusal_;
  std::optional<std::size_t> handed_layer_;  ///< of which something was deposited by what was handed over
  PlaceOnLayer handed_;                      ///< the last of it
  std::set<std::size_t> told_;               ///< layers
  std::vector<DrivenLayer> layers_;
};

}  // namespace lamina
