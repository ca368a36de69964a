// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <optional>
#include <vector>

#include "lamina/base/settings.hpp"
#include "lamina/monitoring/height_comparison.hpp"
#include "lamina/monitoring/layer_clock.hpp"

namespace lamina {

/// How measured heights are kept.
struct MonitorSettings {
  double cell_mm = 0.1;    ///< of the maps; beads have a flat top only some tenths of a millimetre wide
  double margin_mm = 3.0;  ///< of the maps around what the toolpath deposits
  double scan_clearance_mm = 1.0;  ///< that the toolpath's scan passes were planned with
};

/// Adds the keys monitor.* and scan.clearance_mm.
void describe(SettingsSchema& schema, MonitorSettings& settings);

/// What a layer measured.
struct LayerHeightReport {
  std::size_t layer = 0;
  double expected_height_mm = 0.0;  ///< top of the layer [bed frame]
  HeightStatistics statistics;
};

/// Follows one print: fuses profiles into a surface, attributes those of scan passes to layers, and compares
/// each scanned layer with what the toolpath should have given. Time and memory do not grow with the number
/// of profiles.
class HeightMonitor {
 public:
  /// @param bed_from_part translation [mm]
  /// @throws InvalidInput if the toolpath deposits nothing or is too large for the cell size; names one that
  /// fits
  HeightMonitor(Toolpath toolpath, const Eigen::Isometry3d& bed_from_part, const MonitorSettings& settings);

  /// Adds one profile.
  ///
  /// @param points         [mm, bed frame]; those beyond the map are counted and left out
  /// @param nozzle_height  of the nozzle tip when the profile was taken [mm, bed frame], if it is known
  /// @return the report of the layer that this profile shows to be done, if it does
  std::optional<LayerHeightReport> insert(const std::vector<Point3>& points,
                                          std::optional<double> nozzle_height);

  /// The report of the layer being scanned, if one is: it is taken to be done.
  std::optional<LayerHeightReport> finish();

  const MeasuredSurface& measured() const { return measured_; }
  /// Measured less expected [mm], each cell by the latest layer that had it among its top cells.
  const HeightMap& deviation() const { return deviation_; }
  const Toolpath& toolpath() const { return toolpath_; }

  /// Cells seen in the scan under way; 0 if there is none. A scan that sees no further ones has come to its
  /// end.
  std::size_t cellsInScan() const { return cells_in_scan_; }

  std::size_t profilesOfLayers() const { return profiles_of_layers_; }
  std::size_t otherProfiles() const { return other_profiles_; }
  std::size_t pointsOutside() const { return points_outside_; }

 private:
  void begin(std::size_t layer);
  std::optional<LayerHeightReport> close();
  void fuse(const std::vector<Point3>& points);

  Toolpath toolpath_;
  Eigen::Isometry3d bed_from_part_;
  LayerClock clock_;
  MeasuredSurface measured_;
  ExpectedSurface expected_;
  HeightMap deviation_;
  std::size_t layers_expected_ = 0;  ///< added to the expected surface
  std::optional<std::size_t> scanned_;
  std::size_t cells_in_scan_ = 0;
  std::size_t profiles_of_layers_ = 0;
  std::size_t other_profiles_ = 0;
  std::size_t points_outside_ = 0;
};

}  // namespace lamina
