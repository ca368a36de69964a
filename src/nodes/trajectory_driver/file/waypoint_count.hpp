// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "lamina/toolpath/toolpath.hpp"
#include "lamina/toolpath/waypoint_index.hpp"

namespace lamina {

/// Progress on a toolpath, in waypoints in the order of its file: each row that `writeCsv` writes is a
/// waypoint, and a closed path ends at its first waypoint again. The count never goes back.
class WaypointCount {
 public:
  explicit WaypointCount(const Toolpath& toolpath);

  std::uint64_t total() const { return total_; }
  std::uint64_t reached() const { return reached_; }
  /// Number of waypoints handed over to the controller, which may be driven without further orders.
  std::uint64_t handedOver() const { return handed_over_; }

  /// @param heading_for  [of the toolpath] the waypoint that is driven to; those before it are reached
  /// @param handed_over_for  the same at the end of what is handed over
  void see(const WaypointIndex& heading_for, const WaypointIndex& handed_over_for);
  void complete();

 private:
  std::uint64_t before(const WaypointIndex& waypoint) const;

  std::vector<std::vector<std::uint64_t>> first_;  ///< number of waypoints before each path of each layer
  std::uint64_t total_ = 0;
  std::uint64_t reached_ = 0;
  std::uint64_t handed_over_ = 0;
};

}  // namespace lamina
