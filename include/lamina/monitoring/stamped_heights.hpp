// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
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
/// to each other, and with any delay. Profiles are processed in the order of their time stamps, each once a
/// pose of the same or a later time stamp is known. A profile belongs to a layer if the nozzle moves level at
/// the layer's scan height from the last pose before the profile to the next one. Therefore the same poses
/// and profiles give the same reports, whatever their delays.
///
/// Of the poses not yet reached by a profile, the latest `kMostPoses` are kept: poses also come without a
/// sensor. A profile older than the dropped poses is late.
class StampedHeights {
 public:
  static constexpr std::size_t kMostPoses = 500'000;

  /// Parameters and errors are those of `HeightMonitor`.
  StampedHeights(Toolpath toolpath, const Eigen::Isometry3d& bed_from_part, const MonitorSettings& settings);

  /// Adds a pose of the nozzle, whose tip moves straight from one pose to the next.
  /// @return reports of layers that are now known to be done
  LayerHeightReports observe(const StampedTip& pose);
  /// Adds a profile.
  /// @return reports of layers that are now known to be done
  LayerHeightReports insert(StampedProfile profile);

  /// States that the clock of the time stamps has gone back. Profiles that wait for poses count as late.
  /// Poses and profiles that arrive from now on are not compared with the earlier time stamps, so that none
  /// of them counts as late for that reason. The measured surface remains.
  LayerHeightReports restartClock();

  /// Ends the scan under way early: its layer is reported as cut short.
  LayerHeightReports cutShort();

  /// Ends the print: processes the profiles that wait, and reports printed layers that were never seen.
  LayerHeightReports finish();

  const HeightMonitor& monitor() const { return monitor_; }
  /// How the profiles so far were used.
  ProfileUse use() const;

 private:
  void workOff();
  void step();
  void passBy();
  void place(const StampedProfile& profile);
  std::int64_t passedUntil(std::int64_t stamp_ns);
  void report(LayerHeightReports more);

  double pose_gap_mm_;
  double quiet_ns_;
  HeightMonitor monitor_;
  std::multimap<std::int64_t, Point3> poses_;  ///< poses of the nozzle that are not processed yet
  std::multimap<std::int64_t, std::vector<Point3>> waiting_;
  std::optional<StampedTip> reached_;  ///< end of the straight motion under consideration
  double way_mm_ = 0.0;                ///< length of that motion
  std::optional<std::int64_t> worked_off_ns_;
  std::size_t cells_in_scan_ = 0;  ///< number of cells seen when the scan last showed something new
  bool was_moving_ = false;        ///< whether the nozzle moved in the motion under consideration
  std::int64_t way_begin_ns_ = 0;  ///< begin of that motion
  std::int64_t moved_ns_ = 0;      ///< sum of all times of motion until it began
  std::int64_t moved_at_profile_ns_ = 0;
  std::int64_t last_profile_ns_ = 0;  ///< time stamp of the scan's last profile
  std::int64_t quiet_for_ns_ = 0;     ///< time of motion since the scan last showed something new
  ProfileUse use_;
  LayerHeightReports done_;  ///< reports not yet returned
};

}  // namespace lamina
