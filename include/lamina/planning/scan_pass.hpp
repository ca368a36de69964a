// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/settings_schema.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// When and how finished layers are scanned.
struct ScanSettings {
  int every_layers = 0;       ///< every n-th layer and the last one are scanned; 0: none
  double clearance_mm = 1.0;  ///< least distance of the nozzle above the finished layer (`scanHeight`)
  double feed_mm_s = 100.0;
  double swath_mm = 28.0;  ///< length of the sensor's line on the layer
  double margin_mm = 1.0;  ///< width scanned beyond the layer's deposition on each side
};

/// Position of the middle of the sensor's line of light relative to the nozzle, in x and y of the layers.
struct ScanSight {
  Point2 offset_mm = Point2::Zero();  ///< on a surface as high as the nozzle
  /// Shift of this position per millimetre by which the surface lies lower; zero for a sensor that looks
  /// along the layers' normal.
  Point2 lean = Point2::Zero();
};

/// Adds the keys scan.*.
void describe(SettingsSchema& schema, ScanSettings& settings);

/// The toolpath with a scan pass at the end of every n-th layer, and of the last one that deposits. A scan
/// pass is a retracted travel that carries the sensor's line over the whole box of the layer's deposition,
/// without the skirt, back and forth along y in swaths side by side. It lifts the nozzle straight up, keeps
/// `scanHeight` and ends at the start of the next layer, whose first travel it replaces.
///
/// The sensor moves with the nozzle; its line of light lies along x of the layers. If the sensor leans, the
/// pass is shifted by the lean over the height from the layer to the nozzle, and widened to show a layer up
/// to one layer height too high or too low.
///
/// @param toolpath  in the frame of its layers, which are plane; satisfies `validate`, and so does the result
/// @throws InvalidConfig if the swath is not longer than 0; InvalidInput if layers are to be scanned and are
///   inclined
Toolpath withScanPasses(Toolpath toolpath, const ScanSettings& settings, const ScanSight& sight);

}  // namespace lamina
