// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "lamina/toolpath/stamped_tip.hpp"

namespace lamina {

/// The points that the sensor saw at an instant.
struct SensedCloud {
  std::int64_t stamp_ns = 0;  ///< time of measurement: stamp of the cloud minus the sensor's time offset
  Eigen::Isometry3d bed_from_sensor = Eigen::Isometry3d::Identity();  ///< translation [mm]
  /// Points, one list per profile [mm, frame of the sensor]; a missing point is not finite.
  std::vector<std::vector<Point3>> profiles;
  std::string sensor = {};  ///< name of the sensor, such as its frame
};

/// A cloud, or a position of the nozzle tip if there is no cloud.
struct StampedEvent {
  std::int64_t stamp_ns = 0;
  Point3 tip = Point3::Zero();
  std::shared_ptr<const SensedCloud> cloud;
};

/// A queue of poses and clouds, whose order does not depend on when they arrive: by time stamp, poses before
/// clouds, then by content.
class StampedEvents {
 public:
  /// Whether an event of that time stamp comes too late, since a later one was already removed.
  bool isLate(std::int64_t stamp_ns) const { return taken_ns_ && stamp_ns < *taken_ns_; }
  void add(const StampedTip& pose);
  void add(SensedCloud cloud);

  /// Removes and returns the first event; nothing if its time stamp is later than `stamp_ns`.
  std::optional<StampedEvent> takeUntil(std::int64_t stamp_ns);
  /// Forgets the events that wait.
  void clear() { waiting_.clear(); }

  /// The latest time stamp of all events, and of poses alone; nothing before the first one.
  const std::optional<std::int64_t>& latest() const { return latest_ns_; }
  const std::optional<std::int64_t>& latestTip() const { return latest_tip_ns_; }

 private:
  struct Earlier {
    bool operator()(const StampedEvent& a, const StampedEvent& b) const;
  };

  void insert(StampedEvent event);

  std::multiset<StampedEvent, Earlier> waiting_;
  std::optional<std::int64_t> latest_ns_;
  std::optional<std::int64_t> latest_tip_ns_;
  std::optional<std::int64_t> taken_ns_;
};

}  // namespace lamina
