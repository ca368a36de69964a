// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Height of the nozzle [mm, frame of the layers] while a sensor beside it scans a finished layer. It is at
/// least `clearance_mm` above the layer's top, and half a layer off every height at which layers of this
/// thickness are printed, which distinguishes a scan from printing by the height alone.
double scanHeight(const ToolpathLayer& layer, double clearance_mm);

/// Whether the layer has a travel with a waypoint at its scan height.
/// @param normal  normal of the layers, in the frame of the toolpath, of unit length
bool isScanned(const ToolpathLayer& layer, double clearance_mm, const Point3& normal = Point3::UnitZ());

}  // namespace lamina
