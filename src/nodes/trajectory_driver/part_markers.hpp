// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <mutex>
#include <optional>

#include "markers/growing_part.hpp"

namespace lamina {

/// Publishes a part as it grows, on part_markers: to everybody what changes, and to who subscribes later all
/// of it so far. Its calls may come from several threads.
class PartMarkers {
 public:
  explicit PartMarkers(ros::NodeHandle& node);

  /// Begins a part, whose toolpath must outlive it up to `complete` or `end`.
  void begin(const Toolpath& toolpath);
  /// Shows the part as it is on the way to a waypoint; without effect if there is none.
  void growTo(const WaypointIndex& heading_for);
  /// Ends the part with all of its toolpath.
  void complete();
  /// Ends the part, if it has not ended yet, as it is.
  void end();

 private:
  void welcome(const ros::SingleSubscriberPublisher& newcomer) const;

  mutable std::mutex
      mutex_;  ///< of what follows, and held while it is published: nobody gets it out of order
  std::optional<GrowingPart> growing_;
  ros::Publisher publisher_;
};

}  // namespace lamina
