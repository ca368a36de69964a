// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lamina/control/correction_map.hpp"
#include "lamina/control/height_loop.hpp"
#include "lamina/control/run/fallen_watch.hpp"
#include "lamina/control/run/layer_progress.hpp"
#include "lamina/control/run/loop_memory.hpp"
#include "lamina/control/run/loop_run_settings.hpp"
#include "lamina/control/run/lump_watch.hpp"
#include "lamina/control/run/missed_map.hpp"
#include "lamina/control/run/moved_watch.hpp"
#include "lamina/control/run/offset_watches.hpp"
#include "lamina/control/run/pose_watches.hpp"
#include "lamina/control/run/sensor_motion.hpp"
#include "lamina/control/run/sensor_watches.hpp"
#include "lamina/control/run/solid_cells.hpp"
#include "lamina/control/run/stamped_events.hpp"
#include "lamina/control/run/standing_alarms.hpp"
#include "lamina/control/run/standing_conditions.hpp"
#include "lamina/control/run/taught_part.hpp"
#include "lamina/control/section_contours.hpp"

namespace lamina {

class CoastingMaps;
class LaidLayer;
class LayerTrim;

/// A part on its bed.
struct PlacedPart {
  std::string toolpath_id;
  Eigen::Isometry3d bed_from_part = Eigen::Isometry3d::Identity();  ///< translation [mm]
  Toolpath toolpath;
  std::string machine = {};  ///< name of the machine for which the toolpath was planned
};

/// A cell of a layer that is done.
struct CellOutcome {
  Point3 at = Point3::Zero();  ///< planned middle of its top [mm, part frame]
  double error_mm = 0.0;       ///< planned less measured height: positive is too low
  double sigma_mm = 0.0;       ///< standard deviation of the error
  double amount = 0.0;         ///< relative change with which the cell was deposited
  bool is_seen = false;
  Eigen::Vector3d along_mm = Eigen::Vector3d::Zero();  ///< from its start to its end
  double width_mm = 0.0;                               ///< of its bead
  double gain = 1.0;                                   ///< actual over commanded growth, as learnt
};

/// A layer that is done.
struct LayerOutcome {
  LayerFigures figures;
  LoopState state = LoopState::Off;  ///< of the loop while the layer was deposited
  std::vector<RaisedAlarm> alarms;   ///< since the layer before was done
  std::vector<CellOutcome> cells;    ///< in the order of deposition
};

/// A new plan of the layers left of a print.
struct PrintPlan {
  PlacedPart part;         ///< its identity names its parent (`replannedId`)
  std::size_t layer = 0;   ///< layer of the present toolpath that the first layer of the plan replaces
  double raised_mm = 0.0;  ///< height of the plan above the present one
  double flow = 1.0;       ///< factor on the volume of beads
  double short_mm = 0.0;   ///< distance of its top below the top of the first toolpath of the print
  std::string reason;      ///< reason for which it was made
};

/// What has resulted since the last call of `takeNews`, each kind in its order. An alarm that holds the print
/// comes no later than the map of the layer before which it holds.
struct LoopNews {
  std::vector<RaisedAlarm> alarms;
  std::vector<CorrectionMap> coasting_maps;  ///< of sequence 0; each comes with the map of the layer below
  std::vector<CorrectionMap> maps;
  std::vector<LayerOutcome> layers;
  std::optional<LoopMemory> memory;  ///< after the last of these layers, if `keeps_memory` is set
  std::vector<PrintPlan> plans;      ///< the latest is valid, until the layer that it begins with is done
};

/// Numbers of poses, clouds and readings by their use. Clouds received are the sum of those read, late, stuck
/// and waiting.
struct LoopCounts {
  std::uint64_t poses = 0;
  std::uint64_t poses_late = 0;  ///< older than others that were already processed
  std::uint64_t clouds = 0;
  std::uint64_t clouds_read = 0;
  std::uint64_t clouds_late = 0;
  std::uint64_t clouds_stuck = 0;  ///< of a sensor that gives the same profile again and again
  std::uint64_t clouds_waiting = 0;
  std::uint64_t readings_used = 0;
  std::uint64_t readings_contested = 0;
  std::uint64_t readings_believed = 0;
  std::uint64_t readings_below = 0;  ///< of a layer that was already done
  std::uint64_t trims_refused = 0;   ///< further maps of a layer that the machine refused
  PointCounts points;                ///< of the clouds read
};

/// The loop over one print, driven by time stamps alone. Poses of the nozzle and clouds may arrive in any
/// order within `monitor.reorder_s`. They are processed in the order of their time stamps, each as soon as a
/// pose or cloud with a stamp later by `monitor.reorder_s` has arrived. Therefore the same poses and clouds
/// give the same maps to the last bit, whatever their delays.
///
/// Which cells are deposited follows from the progress of the nozzle along the toolpath. When the nozzle
/// reaches the end of a layer, the layer is judged and the next one gets its map; the first layer gets its
/// map at once. With `loop.trim` a layer under way gets further maps, of ascending sequence, for the cells
/// that are not deposited yet. The first map of a layer has sequence 1. With it a correcting loop of a free
/// process issues the coasting map of the next layer, of sequence 0: from the growth learnt by then, without
/// the error.
class LoopRun {
 public:
  /// @throws InvalidInput as `validate` of a toolpath; as `metalSplit` for its speeds; as `TaughtPart` for
  ///   the map learnt from previous parts
  /// @throws InvalidConfig as `timeOffsetSigmas`
  /// @throws FileError if that map cannot be read
  LoopRun(PlacedPart part, const LoopRunSettings& settings);
  ~LoopRun();
  LoopRun(const LoopRun&) = delete;
  LoopRun& operator=(const LoopRun&) = delete;

  /// Restores the state after a layer; to be called before any pose or cloud is given. From then on the same
  /// poses and clouds give the same maps as without the interruption. Layers that the nozzle has begun
  /// meanwhile count as deposited as planned, since the machine had no maps of them.
  /// @throws InvalidInput naming the difference if the memory is of another print, machine or material, or
  ///   has other cells; the print is then at its beginning
  void resume(const LoopMemory& memory);
  /// The identity of this print, as its memory states it.
  PartIdentity identity() const { return {part_.toolpath_id, part_.machine, settings_.material}; }

  /// Requests a state, from the next layer on, since the machine may already have part of the layer under
  /// way. If the loop then stops correcting, the amounts fade to 0 at the start of that layer, from the last
  /// one of the layer before.
  /// @return the status: `Blocked`, with the reason, if the loop may not start
  const LoopStatus& request(LoopRequest request);

  /// Sets a new calibration of the sensor, for all that arrives from now on, and checks stability again, with
  /// the low-pass of this print. A loop that is blocked, or coasts because a sensor or its time offset has
  /// moved, then starts as requested. A running loop that does not pass the check is blocked.
  void recalibrate(const CellCalibration& known, LoopRequest request);

  /// Adds a pose of the nozzle.
  void observe(const StampedTip& pose);
  /// Adds a cloud.
  void see(SensedCloud cloud);
  /// States that a cloud of a sensor with that time stamp (less the sensor's time offset) has arrived, for
  /// which no pose of the nozzle may be known yet.
  void hear(std::int64_t stamp_ns, const std::string& sensor = {});
  /// States that the clock of the time stamps has gone back. All poses and clouds that wait are processed.
  /// Those that arrive from now on are not compared with the earlier time stamps, so that none of them counts
  /// as late for that reason. All that was measured and learnt remains.
  void restartClock();
  /// States that the machine deposits a layer, or the beginning of it, as planned or by its coasting map
  /// instead of by its map. That the coasting map was used holds for the layer from then on. The
  /// estimate takes that into account if the layer is under way or still to come; for a layer that is done
  /// there is no effect. Alarm 6116 is raised if the whole layer is deposited as planned although its map has
  /// corrections, or the machine waited for the map. A later statement on a layer replaces an earlier one.
  void missMap(const MissedMap& missed);
  /// States that the machine does not use a further map of a layer. The refusal is counted, and alarm 6116 is
  /// raised as a warning with the reason, at most once a layer. The estimate still assumes that the layer is
  /// deposited by that map. For a layer that the toolpath does not have there is no effect.
  void refuseTrim(std::size_t layer, const std::string& reason);

  /// States that the machine continues with the plan of that identity, from its first layer on. All poses and
  /// clouds that wait are processed; then the loop continues with that plan, with all that it has learnt.
  /// @return whether that is the plan offered last; if not, the loop stays with the present toolpath
  bool follow(const std::string& toolpath_id);
  /// States that the machine does not continue with the plan of that identity. Alarm 6113 is raised as a
  /// warning with the reason. The map of the first layer that the plan was to replace is issued again, since
  /// it may have been withheld.
  /// @return whether that is the plan offered last; if not, nothing changes
  bool refusePlan(const std::string& toolpath_id, const std::string& reason);

  /// Processes all poses and clouds that wait, as nothing older will arrive.
  void passAll();
  /// Ends the print: judges the layer under way if all of it is deposited.
  void finish();
  /// States that the print has ended, or was cut off: until `goOn` nothing is expected of the sensors, and
  /// none of their conditions stands.
  void interrupt();
  /// States that a print that was cut off goes on.
  void goOn() { is_interrupted_ = false; }

  /// The coasting map of the layer under way or of the next one; null if it has none.
  const CorrectionMap* coastingMap(std::size_t layer) const;

  /// What has resulted since the last call.
  LoopNews takeNews();

  /// The map for the next part of this program, as `TaughtPart::learnt`.
  std::optional<PartMap> learnt(PartEnd end) const { return taught_.learnt(part_.toolpath, end); }

  const LoopStatus& status() const { return status_; }
  /// The last alarm, if there was one.
  const std::optional<RaisedAlarm>& lastAlarm() const { return last_alarm_; }
  /// The alarms raised so far whose cause lasts and is still present.
  const std::vector<RaisedAlarm>& standing() const { return standing_.all(); }
  const PrintPosition& place() const { return progress_.place(); }
  const LoopCounts& counts() const { return counts_; }
  const PlacedPart& part() const { return part_; }
  /// The last check of stability, which allowed or refused the loop.
  const StabilityReport& stability() const { return stability_; }

 private:
  void passDue();
  void passUntil(std::int64_t stamp_ns);
  void onTip(std::int64_t stamp_ns, const Point3& tip);
  void onCloud(const SensedCloud& cloud);
  void readCloud(const SensedCloud& cloud);
  void use(const std::string& sensor, const LayerReading& reading);
  void watchHeights(const std::string& sensor, const SensorProfile& profile);
  void watchOffset();
  void watchPlace();
  void forgetShifts();
  void watch();
  LoopMemory memory(std::size_t layer) const;
  void beginLayer(std::size_t layer);
  void endLayer();
  StabilityReport checkNow() const;
  void checkAgain(const LayerFigures& figures);
  void planAnew(const LayerFigures& figures);
  void offerPlan(const LayerFigures& figures, const std::string& reason);
  void blockIfLump();
  void layAsPlanned();
  void layMapFrom(std::size_t cell);
  void giveCoastingMap();
  void takeMissed();
  LayerOutcome outcomeOf(const LayerFigures& figures);
  std::size_t cellsDeposited(double settle_mm) const;
  void leaveBehind(std::int64_t stamp_ns);
  void publishMap();
  void trimLayer();
  void take(LoopStep step);
  bool isDue(std::size_t layer, const LayerFigures& figures) const;
  Point3 correctedTip(const Point3& tip) const;

  PlacedPart part_;
  LoopRunSettings settings_;
  TimeOffsetSigmas offset_sigmas_;
  Eigen::Isometry3d part_from_bed_;
  Eigen::Vector3d normal_;
  LayerProgress progress_;
  TaughtPart taught_;
  StabilityReport stability_;
  double gain_at_check_ = 1.0;
  double gain_ratio_ = 1.0;  ///< growth as measured over growth as learnt, in the last layer
  std::optional<HeightLoop> loop_;
  CellAtlas atlas_;
  LoopStatus status_;
  double short_mm_ = 0.0;                ///< by which the plan under way ends below the first one's top
  std::optional<PrintPlan> plan_;        ///< plan that was offered last
  std::optional<HeightLoop> plan_loop_;  ///< the loop as it continues if that plan is followed
  /// Layer under way; none before the first and after the last one with cells.
  std::optional<std::size_t> layer_;
  std::unique_ptr<LaidLayer> laid_;          ///< never null; of the layer under way
  std::unique_ptr<CoastingMaps> coasting_;   ///< never null
  std::unique_ptr<LayerTrim> trim_;          ///< of the layer under way; null if it is not trimmed
  std::uint64_t map_sequence_ = 0;           ///< sequence of the layer's last map
  std::optional<std::size_t> trim_refused_;  ///< layer of which a refused map was reported last
  bool is_catching_up_ = false;              ///< whether the print was resumed and the nozzle not found yet
  std::map<std::size_t, MissedMap> missed_;  ///< of layers to come
  std::vector<CellEstimate> below_;          ///< estimates of the layer before
  std::size_t below_layer_ = 0;

  StampedEvents events_;
  std::optional<std::int64_t> tip_ns_;
  Point3 tip_ = Point3::Zero();
  bool is_moving_ = false;
  double silent_s_ = 0.0;  ///< of motion in the scan, without a cloud
  double settle_mm_ = 0.0;
  SolidCells solid_;
  SectionContours sections_;  ///< of the layer under way, of a pressed process
  std::optional<std::int64_t> cloud_ns_;
  PoseWatches pose_watches_;  ///< by the clouds that came for the layer, placed or not
  SensorWatches sensors_;
  bool is_distrusted_ = false;  ///< whether a sensor is stuck, or has moved, in the layer under way
  OffsetWatches offset_;
  SensorOffset offset_left_;  ///< by the last layer that shows an offset
  MovedWatches moved_watches_;
  std::string moved_;                            ///< reason for which no cloud is believed; empty if none
  LumpWatch lump_;                               ///< highest lump above the layer under way, as scanned
  FallenWatch fallen_;                           ///< what came off that layer, as scanned
  Box3 ground_;                                  ///< of that layer, without its height
  std::map<std::string, SensorMotion> motions_;  ///< of each sensor, by its name [toolpath]
  Eigen::Vector3d velocity_ =
      Eigen::Vector3d::Zero();  ///< of the sensor of the cloud under way [mm/s, toolpath]
  StandingAlarms watched_;
  StandingConditions standing_;
  bool is_interrupted_ = false;
  std::vector<RaisedAlarm> layer_alarms_;
  std::optional<RaisedAlarm> last_alarm_;
  LoopNews news_;
  LoopCounts counts_;
};

}  // namespace lamina
