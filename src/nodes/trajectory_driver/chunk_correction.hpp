// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <map>
#include <optional>
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
  std::string toolpath_id;
  std::string digest;  ///< of the map; empty if the layer is driven as planned
  MissedMap missed;    ///< what of the layer had been handed over before, and why a map is not used
};

/// Corrects a trajectory by the maps that came before it is handed over: the flow by the amount, the nozzle
/// back along its tool axis by the height, through the machine's inverse kinematics on the branch that it is
/// on. Times stay. What was handed over stays, too: heights go over from there at `kHeightSpeed` at most, so
/// that joints do not jump, and amounts no faster than the feeder follows, to a map that comes late, to the
/// coasting map of a layer that was waited for in vain, and to 0 where none is.
class ChunkCorrection {
 public:
  static constexpr double kHeightSpeed = 5.0;  ///< of the nozzle along its axis, by corrections [mm/s]

  /// @param settings  of which the feeder's delay and limits count; amounts are led by them
  /// @param model     must outlive this
  ChunkCorrection(DrivenToolpath toolpath, const LoopSettings& settings, const KinematicModel& model);

  /// @param digest  under which the map is reported
  /// @return why the map is not used, in words; empty if it is used from now on
  std::string hear(const CorrectionMap& map, const std::string& digest);

  /// The layer is handed over by its coasting map, or as planned, having been waited for. A map that comes
  /// later is used for what is left of it.
  void giveUp(std::size_t layer, double waited_s);
  /// The plan is not gone on with: its first layer is reported as not deposited, with the reason.
  void refusePlan(const std::string& plan_id, const std::string& reason);
  /// All was handed over: what has no map by now was driven as planned.
  void end();

  const std::string& toolpathId() const { return driven_.id; }
  std::size_t layers() const { return driven_.toolpath.layers.size(); }
  /// Whether a layer has a map.
  bool isKnown(std::size_t layer) const { return maps_.count(layer) > 0; }

  /// The next chunk, corrected. Where a height cannot be reached, or would lead a joint out of its limits, it
  /// stays as it was.
  TrajectoryChunk corrected(TrajectoryChunk chunk);

  /// The first height of the last chunk that stayed as it was, in words: layer, path, joint, value and
  /// limits. Empty if there was none, or once it was taken.
  std::string takeRefusal() { return std::exchange(refusal_, {}); }

  /// Since the last call, each change of what a layer is driven by: its map came, none came in time (with
  /// the digest of its coasting map if it is driven by that), all of it was handed over without one, or a
  /// later map of it is not used. Later maps that are used change nothing: the layer is driven by its maps.
  /// Layers that the toolpath does not have are left out.
  std::vector<DrivenLayer> takeLayers() { return std::exchange(layers_, {}); }

 private:
  /// What is asked for at a point of the trajectory.
  struct Asked {
    double amount = 0.0;
    double dz_mm = 0.0;
  };

  /// What was reported to drive a layer.
  struct Reported {
    std::string digest;
    std::optional<PlaceOnLayer> held_from;
    bool is_coasting = false;  ///< whether it is driven by its coasting map
  };
  struct CoastingMap {
    CorrectionMap led;
    std::string digest;
  };

  void miss(std::size_t layer, const std::string& reason, double waited_s = 0.0);
  void missUnreported(std::size_t end);
  void tellMapOf(std::size_t layer, const std::string& digest);
  std::string keepCoasting(const CorrectionMap& map, const std::string& digest, const std::string& defect);
  void noteHandedOver(const TrajectoryChunk& chunk);
  bool isTravel(const WaypointIndex& heading_for) const;
  const PathCorrection* find(const WaypointIndex& heading_for) const;
  Asked askedAt(const JointState& state) const;
  double alongAt(const JointState& state) const;
  double followAmount(const JointState& state, double present, double wanted, double span_s);
  std::string defectOf(const JointValues& position) const;
  std::optional<JointValues> movedBack(const JointValues& position, double height_mm) const;
  double follow(const JointState& state, double present_mm, double wanted_mm);

  DrivenToolpath driven_;
  LoopSettings settings_;
  const KinematicModel& model_;
  Eigen::Isometry3d part_from_bed_;
  std::map<std::size_t, CorrectionMap> maps_;       ///< by layer, led
  std::map<std::size_t, CoastingMap> coasting_;     ///< by layer
  std::vector<std::pair<double, double>> heights_;  ///< time and height of the last chunk [s, mm]
  std::vector<std::pair<double, double>> amounts_;  ///< its times and amounts; on travels the last amount
  std::optional<std::size_t> late_;                 ///< layer that goes over to a map that came late
  std::string refusal_;
  std::optional<std::size_t> handed_layer_;   ///< of which something was deposited by what was handed over
  PlaceOnLayer handed_;                       ///< the last of it
  std::map<std::size_t, Reported> reported_;  ///< by layer
  std::vector<DrivenLayer> layers_;
};

}  // namespace lamina
