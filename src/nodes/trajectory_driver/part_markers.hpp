// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <mutex>
#include <optional>

#include "markers/growing_part.hpp"

namespace lamina {

/// Publishes a growing part on part_markers: changes to all subscribers, and to a later subscriber the part
/// so far. Its calls may come from several threads.
class PartMarkers {
 public:
  explicit PartMarkers(ros::NodeHandle& node);

  /// Begins a part; its toolpath must exist until `complete` or `end`.
  void begin(const Toolpath& toolpath);
  /// Shows the part as it is on the way to a waypoint; without effect if there is none.
  void growTo(const WaypointIndex& heading_for);
  /// Ends the part with all of its toolpath.
  void complete();
  /// Ends the part, if it has not ended yet, as it is.
  void end();

 private:
  void welcome(const ros::SingleSubscriberPublisher& newcomer) const;

  mutable std::mutex mutex_;  ///< guards what follows; also held during publication, to keep the order
  std::optional<GrowingPart> growing_;
  ros::Publisher publisher_;
};

}  // namespace lamina
