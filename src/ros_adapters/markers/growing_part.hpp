// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <string>

#include "lamina/toolpath/toolpath.hpp"
#include "lamina/toolpath/waypoint_index.hpp"

namespace lamina {

/// A part as RViz shows it while it is deposited: lines as wide as the beads, coloured by role, a marker for
/// each layer and role in namespace `deposited`, so that only what changed is sent. The toolpath must outlive
/// the value.
class GrowingPart {
 public:
  /// @param frame  that the markers are given in: the part frame
  GrowingPart(const Toolpath& toolpath, std::string frame);

  /// The markers that change until all motions before the one to this waypoint are done; going back to an
  /// earlier one begins anew. The first markers of all, and of a new beginning, delete what was shown.
  visualization_msgs::MarkerArray upTo(const WaypointIndex& heading_for);
  /// All markers with everything deposited; the first deletes what was shown.
  visualization_msgs::MarkerArray whole();
  /// All markers as they are by now, for who has seen none before; the first deletes what was shown.
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
  WaypointIndex next_;                     ///< layer, path and motion that is not deposited yet
  visualization_msgs::MarkerArray layer_;  ///< of the layer being deposited, by role
  bool has_changed_ = false;
};

}  // namespace lamina
