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

/// A toolpath and its pose on the bed.
struct DrivenToolpath {
  std::string id;
  Toolpath toolpath;  ///< as timed: states refer to its waypoints [mm, part frame]
  Eigen::Isometry3d bed_from_part = Eigen::Isometry3d::Identity();  ///< translation [mm]
};

/// Outcome of a layer's map.
struct DrivenLayer {
  std::string toolpath_id;
  std::string digest;  ///< of the map; empty if the layer is driven as planned
  MissedMap missed;    ///< part of the layer handed over before the map, and why a map is not used
};

/// Corrects a trajectory by the maps that arrive before it is handed over: the flow by the amount, the nozzle
/// back along its tool axis by the height, through the machine's inverse kinematics on the present branch.
/// Times stay. Chunks handed over stay, too: from there heights change at `kHeightSpeed` at most, to avoid
/// jumps of joints, and amounts no faster than the feeder follows. They change to a map that comes late, to
/// the coasting map of a layer whose map did not come, or to 0 without any map.
class ChunkCorrection {
 public:
  static constexpr double kHeightSpeed = 5.0;  ///< of the nozzle along its axis, by corrections [mm/s]

  /// @param settings  its feeder's delay and limits are used; amounts are advanced by the delay
  /// @param model     must outlive this
  ChunkCorrection(DrivenToolpath toolpath, const LoopSettings& settings, const KinematicModel& model);

  /// @param digest  under which the map is reported
  /// @return why the map is not used, in words; empty if it is used from now on
  std::string hear(const CorrectionMap& map, const std::string& digest);

  /// Ends the wait for a layer's map: the layer is handed over by its coasting map, or as planned. A later
  /// map is used for the rest of the layer.
  void giveUp(std::size_t layer, double waited_s);
  /// States that a plan is not followed: its first layer is reported as not deposited, with the reason.
  void refusePlan(const std::string& plan_id, const std::string& reason);
  /// States that everything was handed over: layers without a map were driven as planned.
  void end();

  const std::string& toolpathId() const { return driven_.id; }
  std::size_t layers() const { return driven_.toolpath.layers.size(); }
  /// Whether a layer has a map.
  bool isKnown(std::size_t layer) const { return maps_.count(layer) > 0; }

  /// The next chunk, corrected. A height that cannot be reached, or would lead a joint out of its limits, is
  /// not applied.
  TrajectoryChunk corrected(TrajectoryChunk chunk);

  /// The first height of the last chunk that was not applied, in words: layer, path, joint, value and limits.
  /// Empty if there was none, or once it was taken.
  std::string takeRefusal() { return std::exchange(refusal_, {}); }

  /// Changes since the last call in how layers are driven: a layer's map came, none came in time (with the
  /// digest of the coasting map if that is used), the whole layer was handed over without one, or a later map
  /// is not used. Later maps that are used change nothing: the layer is driven by its maps. Layers that the
  /// toolpath does not have are left out.
  std::vector<DrivenLayer> takeLayers() { return std::exchange(layers_, {}); }

 private:
  /// Requested corrections at a point of the trajectory.
  struct Asked {
    double amount = 0.0;
    double dz_mm = 0.0;
  };

  /// The last report on how a layer is driven.
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
  std::vector<std::pair<double, double>> heights_;  ///< times and heights handed over, of late [s, mm]
  std::vector<std::pair<double, double>> amounts_;  ///< the same of amounts; on travels the last amount
  std::optional<std::size_t> late_;                 ///< layer that goes over to a map that came late
  std::string refusal_;
  std::optional<std::size_t> handed_layer_;   ///< layer of the last deposition that was handed over
  PlaceOnLayer handed_;                       ///< place of that deposition
  std::map<std::size_t, Reported> reported_;  ///< by layer
  std::vector<DrivenLayer> layers_;
};

}  // namespace lamina
