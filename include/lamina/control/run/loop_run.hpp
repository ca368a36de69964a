// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "lamina/control/correction_map.hpp"
#include "lamina/control/height_loop.hpp"
#include "lamina/control/run/layer_progress.hpp"
#include "lamina/control/run/loop_memory.hpp"
#include "lamina/control/run/lump_watch.hpp"
#include "lamina/control/run/missed_map.hpp"
#include "lamina/control/run/offset_watch.hpp"
#include "lamina/control/run/run_settings.hpp"
#include "lamina/control/run/stuck_watch.hpp"
#include "lamina/control/run/taught_part.hpp"

namespace lamina {

class LayerTrim;

/// Where the nozzle tip is at an instant.
struct StampedTip {
  std::int64_t stamp_ns = 0;
  Point3 tip = Point3::Zero();  ///< [mm, bed frame]
};

/// What the sensor saw at an instant.
struct SensedCloud {
  std::int64_t stamp_ns = 0;  ///< the time at which it was taken: the offset of the sensor's clock is off
  Eigen::Isometry3d bed_from_sensor = Eigen::Isometry3d::Identity();  ///< translation [mm]
  /// Points along each line [mm, frame of the sensor]; not finite where there is none.
  std::vector<std::vector<Point3>> profiles;
};

/// A part on its bed.
struct PlacedPart {
  std::string toolpath_id;
  Eigen::Isometry3d bed_from_part = Eigen::Isometry3d::Identity();  ///< translation [mm]
  Toolpath toolpath;
  std::string machine = {};  ///< name of the machine it was planned for
};

/// A cell of a layer that is done.
struct CellOutcome {
  Point3 at = Point3::Zero();  ///< planned middle of its top [mm, part frame]
  double error_mm = 0.0;       ///< planned less measured: positive is too low
  double sigma_mm = 0.0;       ///< of that
  double amount = 0.0;         ///< relative correction that it was laid with
  bool is_seen = false;
};

/// A layer that is done.
struct LayerOutcome {
  LayerFigures figures;
  LoopState state = LoopState::Off;  ///< in which it was laid
  std::vector<RaisedAlarm> alarms;   ///< since the layer before was done
  std::vector<CellOutcome> cells;    ///< in the order in which the nozzle comes by
};

/// The layers left of a print, planned anew: a part that is to be laid in place of them.
struct PrintPlan {
  PlacedPart part;         ///< with an identity of its own that names its parent (`replannedId`)
  std::size_t layer = 0;   ///< of the toolpath before, in whose place its first layer comes
  double raised_mm = 0.0;  ///< its heights count from a plan that much higher than the one before
  double flow = 1.0;       ///< its beads have that many times the volume
  double short_mm = 0.0;   ///< by which it ends below the top of the toolpath that was begun with
  std::string reason;      ///< for which it was made
};

/// What has come since it was asked for last, each in its order. An alarm that holds the print stands before
/// the map of the layer that it holds.
struct LoopNews {
  std::vector<RaisedAlarm> alarms;
  std::vector<CorrectionMap> maps;
  std::vector<LayerOutcome> layers;
  std::optional<LoopMemory> memory;  ///< of the last of these, where it is kept
  std::vector<PrintPlan> plans;      ///< the latest holds, until the layer that it begins with is laid
};

/// What became of what came: clouds received are the sum of those read, dropped and waiting.
struct LoopCounts {
  std::uint64_t poses = 0;
  std::uint64_t poses_late = 0;  ///< older than what was worked off
  std::uint64_t clouds = 0;
  std::uint64_t clouds_read = 0;
  std::uint64_t clouds_late = 0;
  std::uint64_t clouds_stuck = 0;  ///< of a sensor that says the same all the time
  std::uint64_t clouds_waiting = 0;
  std::uint64_t readings_used = 0;
  std::uint64_t readings_contested = 0;
  std::uint64_t readings_believed = 0;
  std::uint64_t readings_below = 0;  ///< of a layer that is done
  std::uint64_t trims_refused = 0;   ///< further maps of a layer that the machine did not use
  PointCounts points;                ///< of the clouds read
};

/// One print under the loop, by stamps alone. Poses of the nozzle and clouds may come in any order within
/// `monitor.reorder_s`: they are worked off in the order of their stamps once something that much later has
/// come. So the same poses and clouds give the same maps to the last bit, however they are delayed.
///
/// Which cells are laid follows from how far along the toolpath the nozzle has come. A layer is done when the
/// nozzle has come to its end; then it is judged, and the next one gets its map. The first layer has its map
/// at once. With `loop.trim` a layer under way gets further maps, of higher sequence, for what is not laid.
class LoopRun {
 public:
  /// @throws InvalidInput as `validate` of a toolpath, as `metalSplit` for its speeds, and as `TaughtPart`
  /// for
  ///   the map that it is to be laid by; FileError if that cannot be read
  LoopRun(PlacedPart part, const LoopRunSettings& settings);
  ~LoopRun();
  LoopRun(const LoopRun&) = delete;
  LoopRun& operator=(const LoopRun&) = delete;

  /// Goes on after the layer that the memory is of, before anything was observed: the same poses and clouds
  /// give the same maps as if nothing had come between. Layers that the nozzle is found to have begun
  /// meanwhile count as laid as planned, as nobody told the machine otherwise.
  /// @throws InvalidInput if the memory is of another print, machine or material, or of other cells, naming
  /// what differs; the print is then at its beginning
  void resume(const LoopMemory& memory);
  /// What the memory of this print says it is of.
  PartIdentity identity() const { return {part_.toolpath_id, part_.machine, settings_.material}; }

  /// Takes effect with the next layer, as part of the layer under way may have been handed to the machine:
  /// of a loop that corrects no more, that layer fades from what the one before ended with.
  /// @return the status, `Blocked` with the reason where the loop may not start
  const LoopStatus& request(LoopRequest request);

  /// The sensor was calibrated anew: what comes from now on is taken by that. A loop that coasts until then,
  /// or is blocked, begins as requested if the check of stability allows it with the low-pass of this print.
  void recalibrate(const CellCalibration& known, LoopRequest request);

  void observe(const StampedTip& pose);
  void see(SensedCloud cloud);
  /// A cloud of that stamp has come, and no pose of the nozzle is known for it yet.
  void hear(std::int64_t stamp_ns);
  /// The machine lays a layer, or its beginning, as planned. The estimate of a layer that is under way, or
  /// still to come, takes that into account; that of one that is done, or that the toolpath does not have,
  /// does not. 6116 is raised where all of the layer is laid as planned that was to be laid otherwise, or was
  /// waited for. What is told of a layer later takes the place of what was told of it before.
  void missMap(const MissedMap& missed);
  /// The machine does not use a further map of a layer. It is counted, and 6116 raised as a warning with the
  /// reason, once a layer; the estimate takes the layer to be laid by it all the same. Of a layer that the
  /// toolpath does not have nothing happens.
  void refuseTrim(std::size_t layer, const std::string& reason);

  /// The machine goes on with the plan of that identity, from its first layer on: so does the loop, with what
  /// it has learnt. What waits is worked off before.
  /// @return whether that is the plan offered last; else nothing changes
  bool follow(const std::string& toolpath_id);
  /// The machine does not go on with the plan of that identity: 6113 is raised as a warning with the reason,
  /// and the layer that the plan was to begin with has its map once more, as it may have been withheld.
  /// @return whether that is the plan offered last; else nothing changes
  bool refusePlan(const std::string& toolpath_id, const std::string& reason);

  /// Works off what waits: nothing older comes.
  void passAll();
  /// Nothing more comes at all: judges the layer under way if all of it is laid.
  void finish();

  LoopNews takeNews();

  /// The map for the next part of this program (`TaughtPart::learnt`), for the caller to keep or not.
  std::optional<PartMap> learnt(PartEnd end) const { return taught_.learnt(part_.toolpath, end); }

  const LoopStatus& status() const { return status_; }
  /// Of the last alarm; none if there was none.
  const std::optional<RaisedAlarm>& lastAlarm() const { return last_alarm_; }
  const PrintPlace& place() const { return progress_.place(); }
  const LoopCounts& counts() const { return counts_; }
  const PlacedPart& part() const { return part_; }
  /// The check that allowed or refused the loop last.
  const StabilityReport& stability() const { return stability_; }

 private:
  /// A pose, or a cloud if there is one.
  struct Event {
    std::int64_t stamp_ns = 0;
    Point3 tip = Point3::Zero();
    std::shared_ptr<const SensedCloud> cloud;
  };
  /// Poses before clouds of the same stamp; equal ones by what is in them, so that arrival decides nothing.
  struct Earlier {
    bool operator()(const Event& a, const Event& b) const;
  };

  void insert(Event event);
  void passUntil(std::int64_t stamp_ns);
  void onTip(std::int64_t stamp_ns, const Point3& tip);
  void onCloud(const SensedCloud& cloud);
  void readCloud(const SensedCloud& cloud);
  void use(const LayerReading& reading);
  void senseMotion(const SensedCloud& cloud);
  void watchLump(const std::vector<Point3>& points, const Eigen::Isometry3d& toolpath_from_sensor);
  void watchOffset();
  void watch(double blind_s);
  LoopMemory memory(std::size_t layer) const;
  void beginLayer(std::size_t layer);
  void endLayer();
  StabilityReport checkNow() const;
  void checkAgain(const LayerFigures& figures);
  void planAnew(const LayerFigures& figures);
  void offerPlan(const LayerFigures& figures, const std::string& reason);
  std::string reasonToPlan(const LayerFigures& figures) const;
  void blockIfLump();
  LayerCorrection wanted() const;
  void layAsPlanned(const std::string& reason);
  void layMapFrom(std::size_t cell);
  void takeMissed();
  void shiftNozzle();
  CellCorrections asLaid() const;
  LayerOutcome outcomeOf(const LayerFigures& figures);
  std::size_t cellsLaid(double settle_mm) const;
  void leaveBehind(std::int64_t stamp_ns);
  std::size_t cellsSolid(std::int64_t stamp_ns);
  void publishMap();
  void trimLayer();
  void take(LoopStep step);
  bool isCorrecting() const;
  bool isDue(std::size_t layer, const LayerFigures& figures) const;
  Point3 correctedTip(const Point3& tip) const;

  PlacedPart part_;
  LoopRunSettings settings_;
  Eigen::Isometry3d part_from_bed_;
  Eigen::Vector3d normal_;
  LayerProgress progress_;
  TaughtPart taught_;
  StabilityReport stability_;
  double gain_at_check_ = 1.0;
  double gain_ratio_ = 1.0;  ///< growth as measured over growth as learnt, of the last layer
  std::optional<HeightLoop> loop_;
  CellAtlas atlas_;
  LoopStatus status_;
  double short_mm_ = 0.0;                ///< by which the plan under way ends below the first one's top
  std::optional<PrintPlan> plan_;        ///< offered
  std::optional<HeightLoop> plan_loop_;  ///< as it goes on by that plan
  std::optional<std::size_t> layer_;  ///< under way; none before the first and after the last one with cells
  LoopState laid_in_ = LoopState::Off;
  /// How the layer under way is to be laid by its last map.
  struct Mapped {
    LayerCorrection correction;
    std::vector<double> shift_mm;
    LoopState in = LoopState::Off;
  };
  Mapped mapped_;
  bool is_missed_ = false;  ///< it is not laid by all of that
  LayerCorrection laid_;
  std::vector<double> shift_mm_;             ///< of the nozzle, by cell
  double mean_shift_mm_ = 0.0;               ///< of the layer
  double last_amount_ = 0.0;                 ///< where the layer before ended
  std::unique_ptr<LayerTrim> trim_;          ///< of the layer under way; null if it is not trimmed
  std::uint64_t map_sequence_ = 0;           ///< of the layer's last map
  std::optional<std::size_t> trim_refused_;  ///< layer of which that was told last
  bool is_catching_up_ = false;              ///< resumed, and the nozzle was not found yet
  std::map<std::size_t, MissedMap> missed_;  ///< of layers to come
  std::vector<CellEstimate> below_;          ///< of the layer before
  std::size_t below_layer_ = 0;

  std::multiset<Event, Earlier> waiting_;
  std::optional<std::int64_t> latest_ns_;
  std::optional<std::int64_t> latest_tip_ns_;
  std::optional<std::int64_t> passed_ns_;
  std::optional<std::int64_t> tip_ns_;
  Point3 tip_ = Point3::Zero();
  bool is_moving_ = false;
  double silent_s_ = 0.0;  ///< of motion in the scan, without a cloud
  double settle_mm_ = 0.0;
  std::deque<std::pair<std::int64_t, std::size_t>> left_behind_;  ///< cells of the layer, and since when
  std::optional<std::int64_t> cloud_ns_;
  StuckWatch stuck_;
  OffsetWatch offset_;
  OffsetLeft offset_left_;          ///< of the layer that told it last
  LumpWatch lump_;                  ///< above the layer under way, as scanned
  Box3 ground_;                     ///< of that layer, without its height
  Point3 sensor_ = Point3::Zero();  ///< at the last cloud [toolpath]
  std::optional<std::int64_t> sensor_ns_;
  Eigen::Vector3d sensor_mm_s_ = Eigen::Vector3d::Zero();  ///< [toolpath]
  std::set<LoopAlarm> watched_;                            ///< alarms of the watch that are up
  std::vector<RaisedAlarm> layer_alarms_;
  std::optional<RaisedAlarm> last_alarm_;
  LoopNews news_;
  LoopCounts counts_;
};

}  // namespace lamina
