// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "lamina/base/settings_schema.hpp"
#include "lamina/monitoring/height_comparison.hpp"
#include "lamina/monitoring/layer_clock.hpp"

namespace lamina {

/// How measured heights are mapped and attributed to layers.
struct MonitorSettings {
  /// Size of cells of the maps; flat tops of beads are only some tenths of a millimetre wide.
  double cell_mm = 0.1;
  double margin_mm = 3.0;          ///< by which the maps extend beyond what the toolpath deposits
  double scan_clearance_mm = 1.0;  ///< with which the toolpath's scan passes were planned
  /// Profiles between two poses of the nozzle that are farther apart than this are not used.
  double pose_gap_mm = 10.0;
  /// A scan that shows nothing new of its layer for that long, by time stamps, has ended.
  double quiet_s = 2.0;
};

/// Adds the keys monitor.*, scan.clearance_mm, pose_gap_mm and quiet_s.
void describe(SettingsSchema& schema, MonitorSettings& settings);

/// How the scan of a reported layer went.
enum class LayerSight : std::uint8_t {
  Seen,      ///< its scan came to an end
  CutShort,  ///< its scan was given up before that; profiles that came later do not count
  NotSeen,   ///< its scan showed nothing of it; there are no statistics
};

/// `seen`, `cut_short` or `not_seen`.
const char* toString(LayerSight sight);

/// What was measured of a layer.
struct LayerHeightReport {
  std::size_t layer = 0;
  double expected_height_mm = 0.0;  ///< top of the layer, along its normal
  HeightStatistics statistics;
  LayerSight sight = LayerSight::Seen;
  std::size_t profiles = 0;  ///< number of profiles of its scan
};

/// Reports of layers that turn out to be done at the same time, in the order of the layers.
using LayerHeightReports = std::vector<LayerHeightReport>;

/// Follows one print: fuses profiles into a surface, attributes those of scan passes to layers, and compares
/// each scanned layer with what the toolpath should have given. A layer whose scan was missed is reported as
/// not seen, once a later one is scanned. Time and memory do not grow with the number of profiles.
///
/// Calls must be made in the order of time; `StampedHeights` takes care of that.
class HeightMonitor {
 public:
  /// Maps and heights are those of `heightsFromPart`.
  /// @param bed_from_part translation [mm]
  /// @throws InvalidInput if the toolpath deposits nothing or is too large for the cell size, naming a size
  ///   that fits
  HeightMonitor(Toolpath toolpath, const Eigen::Isometry3d& bed_from_part, const MonitorSettings& settings);

  /// Height of a place over the bed [mm], along the layers' normal.
  double heightOf(const Point3& on_bed) const { return (heights_from_bed_ * on_bed).z(); }
  /// Where the maps lie on the bed: the identity for layers that are level on it.
  Eigen::Isometry3d bedFromHeights() const { return heights_from_bed_.inverse(); }

  /// To be called when the nozzle tip has moved straight to a height [mm, along the layers' normal].
  /// @return the report of the layer whose scan this motion shows to have ended, if it does
  LayerHeightReports move(double nozzle_height);

  /// Adds a profile that was taken during that motion.
  /// @param points  [mm, bed frame]; those beyond the map are counted and left out
  /// @return reports of layers that are now known to have been missed
  LayerHeightReports add(const std::vector<Point3>& points);

  /// Both calls: `move` to the height where the nozzle tip was, then `add` the profile.
  LayerHeightReports insert(const std::vector<Point3>& points, double nozzle_height);

  /// Ends the scan under way, if there is one, though the nozzle may still be at its height.
  LayerHeightReports closeScan(LayerSight sight);

  /// Ends the print: ends the scan under way, and reports printed layers without a report as missed.
  LayerHeightReports finish();

  const MeasuredSurface& measured() const { return measured_; }
  /// Measured less expected [mm], each cell by the latest layer that had it among its top cells.
  const HeightMap& deviation() const { return deviation_; }
  const Toolpath& toolpath() const { return toolpath_; }

  /// Cells seen in the scan under way; 0 if there is none. A scan in which this number no longer grows has
  /// come to its end.
  std::size_t cellsInScan() const { return cells_in_scan_; }
  bool isScanning() const { return scanned_.has_value(); }

  /// Number of profiles that belong to the scan of a layer.
  std::size_t profilesOfLayers() const { return profiles_of_layers_; }
  /// Number of all other profiles.
  std::size_t otherProfiles() const { return other_profiles_; }
  /// Number of points beyond the map, which were left out.
  std::size_t pointsOutside() const { return points_outside_; }

 private:
  void begin(std::size_t layer);
  /// Those with a scan pass below `layer` that were not reported.
  LayerHeightReports missedBelow(std::size_t layer);
  LayerHeightReport close(LayerSight sight);
  LayerHeightReport reportOf(std::size_t layer) const;
  void fuse(const std::vector<Point3>& points);

  Toolpath toolpath_;
  Eigen::Isometry3d heights_from_part_;
  Eigen::Isometry3d heights_from_bed_;
  bool is_bed_frame_;  ///< that of the heights
  LayerClock clock_;
  MeasuredSurface measured_;
  ExpectedSurface expected_;
  HeightMap deviation_;
  std::size_t layers_expected_ = 0;        ///< added to the expected surface
  std::vector<std::size_t> to_report_;     ///< layers with a scan pass, ascending
  std::size_t reported_ = 0;               ///< of those
  std::optional<std::size_t> at_scan_of_;  ///< the nozzle, though nothing may have been seen yet
  std::optional<std::size_t> scanned_;
  std::size_t cells_in_scan_ = 0;
  std::size_t profiles_in_scan_ = 0;
  std::size_t profiles_of_layers_ = 0;
  std::size_t other_profiles_ = 0;
  std::size_t points_outside_ = 0;
};

}  // namespace lamina
