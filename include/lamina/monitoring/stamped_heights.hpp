// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "lamina/monitoring/height_monitor.hpp"
#include "lamina/toolpath/stamped_tip.hpp"

namespace lamina {

/// A profile, and when it was taken.
struct StampedProfile {
  std::int64_t stamp_ns = 0;
  std::vector<Point3> points;  ///< [mm, bed frame]
};

/// A number of profiles and of their points.
struct ProfileTally {
  std::uint64_t profiles = 0;
  std::uint64_t points = 0;

  void add(std::size_t point_count) {
    ++profiles;
    points += point_count;
  }
};

/// Profiles by their use. `received` is the sum of the five tallies after it, in profiles and in points.
struct ProfileUse {
  ProfileTally received;
  ProfileTally of_layers;
  ProfileTally of_no_layer;          ///< used in the map alone
  ProfileTally waiting;              ///< for poses of the nozzle
  ProfileTally late;                 ///< older than a profile that was already processed; not used
  ProfileTally in_gap;               ///< between poses of the nozzle that are too far apart; not used
  std::uint64_t points_outside = 0;  ///< points of the used profiles that lie beyond the map
};

/// Follows one print by time stamps alone. Poses of the nozzle and profiles may arrive in any order relative
/// to each other, and with any delay: profiles are processed in the order of their time stamps, each once a
/// pose of its time stamp or a later one is known. A profile belongs to a layer if the nozzle moves level at
/// the layer's scan height from the last pose before the profile to the next one. So the same poses and
/// profiles give the same reports, however they are delayed.
class StampedHeights {
 public:
  /// Parameters and errors are those of `HeightMonitor`.
  StampedHeights(Toolpath toolpath, const Eigen::Isometry3d& bed_from_part, const MonitorSettings& settings);

  /// Adds a pose of the nozzle, whose tip moves straight from one pose to the next.
  /// @return reports of layers that are now known to be done
  LayerHeightReports observe(const StampedTip& pose);
  /// Adds a profile; returns reports likewise.
  LayerHeightReports insert(StampedProfile profile);

  /// States that the clock of the time stamps has gone back. Profiles that wait for poses count as late; of
  /// the poses and profiles that arrive from now on none is late for the sake of the ones before. What was
  /// measured remains.
  LayerHeightReports restartClock();

  /// Gives up the scan under way: its layer is reported as cut short.
  LayerHeightReports cutShort();

  /// Ends the print: processes what is left, and reports layers that were printed and never seen.
  LayerHeightReports finish();

  const HeightMonitor& monitor() const { return monitor_; }
  /// How the profiles so far were used.
  ProfileUse use() const;

 private:
  void workOff();
  void step();
  void place(const StampedProfile& profile);
  std::int64_t passedUntil(std::int64_t stamp_ns);
  void report(LayerHeightReports more);

  double pose_gap_mm_;
  double quiet_ns_;
  HeightMonitor monitor_;
  std::multimap<std::int64_t, Point3> poses_;  ///< those that were not reached
  std::multimap<std::int64_t, std::vector<Point3>> waiting_;
  std::optional<StampedTip> reached_;  ///< end of the straight way that is looked at
  double way_mm_ = 0.0;                ///< its length
  std::optional<std::int64_t> worked_off_ns_;
  std::size_t cells_in_scan_ = 0;  ///< when the scan last showed something new
  bool was_moving_ = false;        ///< on the way that is looked at
  std::int64_t way_begin_ns_ = 0;  ///< of it
  std::int64_t moved_ns_ = 0;      ///< until it began, all times of motion together
  std::int64_t moved_at_profile_ns_ = 0;
  std::int64_t last_profile_ns_ = 0;  ///< of the scan
  std::int64_t quiet_for_ns_ = 0;     ///< since the scan last showed something new
  ProfileUse use_;
  LayerHeightReports done_;  ///< not yet given out
};

}  // namespace lamina
