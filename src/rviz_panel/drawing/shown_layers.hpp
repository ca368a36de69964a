// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <visualization_msgs/MarkerArray.h>

#include "markers/toolpath_markers.hpp"

namespace lamina {

/// The first layers of a part as markers. A change of their number sends only the markers that change: those
/// whose layers come or go, and of each role the one in which the last layer lies. That is some thousand
/// segments, however large the program.
class ShownLayers {
 public:
  /// Shows all layers of another part; no chunks show nothing.
  void load(std::vector<MarkerChunk> chunks, std::size_t layers);
  /// Moves the part [m].
  void moveTo(const geometry_msgs::Point& position);

  std::size_t layerCount() const { return layers_; }

  /// Everything that is shown, after a marker that deletes what was before.
  visualization_msgs::MarkerArray all() const;
  /// Shows as many layers, from the first on, or all there are if these are less.
  /// @return the markers that change
  visualization_msgs::MarkerArray show(std::size_t layers);

 private:
  struct Shown {
    MarkerChunk chunk;
    std::size_t points = 0;  ///< of it that are shown
  };

  std::vector<Shown> shown_;
  std::size_t layers_ = 0;
};

}  // namespace lamina
