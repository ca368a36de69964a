// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "output/layer_overlay.hpp"

#include <cstdio>

namespace lamina::cli {

LayerOverlay overlayOf(const VoidReport& report, std::size_t layer) {
  const LayerVoids& voids = report.layers[layer];
  LayerOverlay overlay;
  overlay.contour = report.part.contours[layer];
  overlay.overfills = voids.overfills;
  for (const Void& each : voids.voids) overlay.voids.push_back(each.outline);
  const double whole = voids.area_mm2 > 0.0 ? voids.area_mm2 : 1.0;
  char text[96];
  std::snprintf(text, sizeof text, "%.2f %% uncovered  ·  %.2f %% overfill",
                100.0 * voids.uncovered_mm2 / whole, 100.0 * voids.overfill_mm2 / whole);
  overlay.remark = text;
  return overlay;
}

}  // namespace lamina::cli
