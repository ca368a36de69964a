// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "drawing/drawn_part.hpp"
#include "drawing/layer_display.hpp"

namespace lamina {

/// The original and the inclined part side by side as markers. The original stands where its program puts it;
/// once there is an inclined part it moves beside that, towards -y, for the two would stand in each other.
///
/// Publishes `source_layers`, `inclined_layers` (visualization_msgs/MarkerArray): what changes, and to
/// newcomers everything
class PartView {
 public:
  PartView();

  void showSource(DrawnPart part);
  void showInclined(DrawnPart part);
  void removeInclined();
  /// Shows the first layers of both.
  void showLayers(std::size_t layers);
  /// Of the part with more of them.
  std::size_t layerCount() const;
  /// Of what is shown, as it stands in the frame [mm]; none if nothing is.
  std::optional<Box3> box() const;

  /// Serves newcomers; returns at once.
  void poll();

 private:
  Point3 sourceShift() const;

  LayerDisplay source_;
  LayerDisplay inclined_;
};

}  // namespace lamina
