// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <string>

#include "lamina/toolpath/toolpath.hpp"
#include "lamina/toolpath/waypoint_index.hpp"

namespace lamina {

/// Markers of a part while it is deposited: lines as wide as the beads, coloured by role. There is one marker
/// for each layer and role in namespace `deposited`, and only changed markers need to be sent. The toolpath
/// must outlive the object.
class GrowingPart {
 public:
  /// @param frame  frame of the markers: that of the part
  GrowingPart(const Toolpath& toolpath, std::string frame);

  /// The markers that change until all motions before the one to this waypoint are done. If the waypoint
  /// precedes that of the last call, everything begins anew. The first markers, and those of a new beginning,
  /// are preceded by a marker that deletes what was shown.
  visualization_msgs::MarkerArray upTo(const WaypointIndex& heading_for);
  /// All markers with everything deposited; the first deletes what was shown.
  visualization_msgs::MarkerArray whole();
  /// All markers in their present state, for a viewer that has not seen any; the first deletes what was
  /// shown.
  visualization_msgs::MarkerArray soFar() const;

 private:
  void begin(visualization_msgs::MarkerArray& markers);
  bool isBefore(const WaypointIndex& at) const;
  void lay(const WaypointIndex& at, visualization_msgs::MarkerArray& markers);
  void addMotion(const WaypointIndex& at);
  void publishLayer(visualization_msgs::MarkerArray& markers);

  const Toolpath& toolpath_;
  std::string frame_;
  bool has_begun_ = false;
  WaypointIndex next_;                     ///< layer, path and motion that is deposited next
  visualization_msgs::MarkerArray layer_;  ///< markers of the layer being deposited, by role
  bool has_changed_ = false;
};

}  // namespace lamina
