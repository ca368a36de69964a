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
  /// Time, by time stamps, after which a scan that shows nothing new of its layer has ended.
  double quiet_s = 2.0;
};

/// Adds the keys monitor.*, scan.clearance_mm, pose_gap_mm and quiet_s.
void describe(SettingsSchema& schema, MonitorSettings& settings);

/// How complete the scan of a reported layer was.
enum class LayerSight : std::uint8_t {
  Seen,      ///< its scan came to an end
  CutShort,  ///< its scan was ended early; profiles that came later do not count
  NotSeen,   ///< its scan showed nothing of the layer; there are no statistics
};

/// `seen`, `cut_short` or `not_seen`.
const char* toString(LayerSight sight);

/// Result of measuring a layer.
struct LayerHeightReport {
  std::size_t layer = 0;
  double expected_height_mm = 0.0;  ///< top of the layer, along its normal
  HeightStatistics statistics;
  LayerSight sight = LayerSight::Seen;
  std::size_t profiles = 0;  ///< number of profiles of its scan
};

/// Reports of layers that turn out to be done at the same time, in the order of the layers.
using LayerHeightReports = std::vector<LayerHeightReport>;

/// Follows one print: fuses profiles into a surface, assigns the profiles of scan passes to layers, and
/// compares each scanned layer with the surface that the toolpath should have given. A layer whose scan was
/// missed is reported as not seen once a later layer is scanned. Time per profile and memory do not grow with
/// the number of profiles.
///
/// Calls must be made in the order of time; `StampedHeights` puts them in that order.
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

  /// Gives the height of the nozzle tip at the end of a straight motion [mm, along the layers' normal].
  /// @return the report of the layer whose scan has ended by this motion; empty if none has
  LayerHeightReports move(double nozzle_height);

  /// Adds a profile that was taken during that motion.
  /// @param points  [mm, bed frame]; those beyond the map are counted and left out
  /// @return reports of layers that are now known to have been missed
  LayerHeightReports add(const std::vector<Point3>& points);

  /// Calls `move` with the height of the nozzle tip, then `add` with the profile.
  LayerHeightReports insert(const std::vector<Point3>& points, double nozzle_height);

  /// Ends the scan under way, if there is one, even if the nozzle is still at its height.
  LayerHeightReports closeScan(LayerSight sight);

  /// Ends the print: ends the scan under way, and reports printed layers without a report as missed.
  LayerHeightReports finish();

  const MeasuredSurface& measured() const { return measured_; }
  /// Measured less expected [mm], each cell by the latest layer that had it among its top cells.
  const HeightMap& deviation() const { return deviation_; }
  const Toolpath& toolpath() const { return toolpath_; }

  /// Number of cells seen in the scan under way; 0 if there is none. When this number no longer grows, the
  /// scan has ended.
  std::size_t cellsInScan() const { return cells_in_scan_; }
  /// The layer that the nozzle was last seen to print; nothing before the first.
  std::optional<std::size_t> printed() const { return clock_.printed(); }
  bool isScanning() const { return scanned_.has_value(); }

  /// Number of profiles that belong to the scan of a layer.
  std::size_t profilesOfLayers() const { return profiles_of_layers_; }
  /// Number of all other profiles.
  std::size_t otherProfiles() const { return other_profiles_; }
  /// Number of points beyond the map, which were left out.
  std::size_t pointsOutside() const { return points_outside_; }

 private:
  void begin(std::size_t layer);
  /// Reports of layers below `layer` that have a scan pass and were not reported.
  LayerHeightReports missedBelow(std::size_t layer);
  LayerHeightReport close(LayerSight sight);
  LayerHeightReport reportOf(std::size_t layer) const;
  void fuse(const std::vector<Point3>& points);

  Toolpath toolpath_;
  Eigen::Isometry3d heights_from_part_;
  Eigen::Isometry3d heights_from_bed_;
  bool is_bed_frame_;  ///< whether the frame of the heights is that of the bed
  LayerClock clock_;
  MeasuredSurface measured_;
  ExpectedSurface expected_;
  HeightMap deviation_;
  std::size_t layers_expected_ = 0;     ///< number of layers added to the expected surface
  std::vector<std::size_t> to_report_;  ///< layers with a scan pass, ascending
  std::size_t reported_ = 0;            ///< number of the layers of `to_report_` that were reported
  /// Layer at whose scan height the nozzle is, even if nothing was seen yet.
  std::optional<std::size_t> at_scan_of_;
  std::optional<std::size_t> scanned_;
  std::size_t cells_in_scan_ = 0;
  std::size_t profiles_in_scan_ = 0;
  std::size_t profiles_of_layers_ = 0;
  std::size_t other_profiles_ = 0;
  std::size_t points_outside_ = 0;
};

}  // namespace lamina
