// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <optional>
#include <vector>

#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Frame in which the heights of a toolpath's layers are measured. If the layers are level on the bed, this
/// is the frame of the bed. Otherwise it is that of the layers: z is their normal, and the origin is the
/// part's. The rule also holds for belt printers, since the frame of the bed moves with the belt.
/// @param bed_from_part  translation [mm]
Eigen::Isometry3d heightsFromPart(const Toolpath& toolpath, const Eigen::Isometry3d& bed_from_part);

/// Determines from the heights of the nozzle which layer is being scanned. Only layers of the toolpath that
/// have a scan pass count, each once and in ascending order.
class LayerClock {
 public:
  /// @param heights_from_part  frame whose z is the layers' normal (`heightsFromPart`); translation [mm]
  /// @param clearance_mm  clearance with which the scan passes were planned
  LayerClock(const Toolpath& toolpath, const Eigen::Isometry3d& heights_from_part, double clearance_mm);

  /// The layer being scanned while the nozzle is at that height [mm, along the layers' normal]; nothing if
  /// there is none. At first the nozzle must be at the layer's scan height, to within a quarter of the layer
  /// height, and at the same height as at the previous observation. The layer must be the next one to be
  /// scanned, or the one that the nozzle was last seen to print, or the one below that. Therefore a nozzle
  /// that passes through other heights, or is parked at one of them, scans nothing. Once the nozzle has left
  /// the scan height of a layer that was seen, that layer is finished.
  std::optional<std::size_t> observe(double nozzle_height_mm);

  /// Records that a profile shows the layer being scanned. Does nothing if none is being scanned.
  void see() { is_seen_ = scanned_.has_value(); }

  /// Ends the current scan: its layer counts as finished if it was seen, even if the nozzle is still at its
  /// scan height.
  void finish();

  /// Layers that have a scan pass, ascending.
  std::vector<std::size_t> scannedLayers() const;

  /// The layer that the nozzle was last seen to print.
  std::optional<std::size_t> printed() const { return printed_; }

 private:
  struct Mark {
    double height_mm;
    double tolerance_mm;
    std::size_t layer;
  };
  static std::optional<std::size_t> layerAt(const std::vector<Mark>& marks, double height_mm);
  bool isDue(std::size_t layer) const;
  void notePrinting(double nozzle_height_mm);

  std::vector<Mark> scans_;     ///< ascending
  std::vector<Mark> prints_;    ///< ascending
  std::size_t first_open_ = 0;  ///< index of the first unfinished layer
  std::optional<std::size_t> scanned_;
  bool is_seen_ = false;  ///< whether a profile shows the layer being scanned
  std::optional<std::size_t> printed_;
  std::optional<double> last_height_mm_;
};

}  // namespace lamina
