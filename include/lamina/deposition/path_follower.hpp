// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "lamina/base/settings_schema.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// A position on a toolpath. Positions are ordered as the nozzle passes them.
struct PathPosition {
  std::size_t path = 0;    ///< number, counted through all layers; the number of paths at the end
  std::size_t motion = 0;  ///< number in the path
  double fraction = 0.0;   ///< share of the motion that is passed, 0 to 1

  friend bool operator==(const PathPosition& a, const PathPosition& b) {
    return a.path == b.path && a.motion == b.motion && a.fraction == b.fraction;
  }
};

/// Settings by which reported positions of the nozzle are assigned to a toolpath.
struct FollowingSettings {
  double tolerance_mm = 0.15;     ///< greatest distance from the toolpath at which the nozzle is on it
  double look_ahead_mm = 1000.0;  ///< greatest length of toolpath from one report to the next
};

/// Adds the keys following.tolerance_mm and following.look_ahead_mm.
void describe(SettingsSchema& schema, FollowingSettings& settings);

/// Determines from reported positions how far along a toolpath the nozzle is. The position never goes back,
/// and all motions before it count as run.
///
/// A reported position is assigned to the nearest point of the first stretch of toolpath ahead that passes
/// within the tolerance. The assignment is accepted at once if the nozzle has moved there along the toolpath,
/// as with dense reports or reports at every corner. Otherwise it is a guess. A guess is accepted when
/// `kSureOnTheWay` reports in a row have continued from it along the toolpath; or when `kSureAhead` reports
/// in a row, each at least a tolerance from the one before, were on the toolpath ahead of it, at any
/// distance. Therefore crossings, neighbouring lines, stray reports and motions that are not of the toolpath
/// do not lead ahead. Positions off the toolpath change nothing. Until the nozzle is found for the first
/// time, only paths that deposit are searched, because the way to the start may run along travels of later
/// layers.
///
/// The cost of a report is proportional to the number of motions up to the point found; off the toolpath, to
/// the number within the look-ahead.
class PathFollower {
 public:
  static constexpr int kSureOnTheWay = 3;
  static constexpr int kSureAhead = 20;

  /// @param toolpath  in the frame of the positions; must outlive this object
  /// @throws InvalidInput as `validate`
  PathFollower(const Toolpath& toolpath, const FollowingSettings& settings);

  /// States that the nozzle is at the beginning of a path or after it. Until the nozzle is found, it is
  /// searched for up to `look_ahead_mm` ahead (at least the distance of the settings).
  /// @param path  number, counted through all layers; the number of paths for the end
  void begin(std::size_t path, double look_ahead_mm);

  /// The position on the toolpath after the nozzle was reported at `tip` [mm]. A tip that is not finite
  /// changes nothing.
  PathPosition observe(const Point3& tip);

  const PathPosition& place() const { return place_; }
  bool isAtEnd() const { return place_.path == paths_.size(); }
  /// All paths in the order they are run.
  const std::vector<const Path*>& paths() const { return paths_; }

 private:
  /// A point of the toolpath ahead, and its distance along it [mm].
  struct Found {
    PathPosition place;
    double way_mm = 0.0;
  };
  /// A point of the toolpath to which a report was assigned, not accepted yet.
  struct Guess {
    PathPosition place;
    Point3 tip = Point3::Zero();
    int on_the_way = 1;  ///< number of reports in a row that continue along the toolpath
    int ahead = 1;       ///< number of reports in a row that are ahead
  };

  std::optional<Found> firstNear(const PathPosition& from, const Point3& tip) const;
  bool isOnTheWay(const Found& found, const Point3& from, const Point3& tip) const;
  bool goesOn(const Point3& tip);
  void accept(const PathPosition& place, const Point3& tip);
  void skipEmptyPaths();
  PathPosition endIfNear(const PathPosition& place) const;

  std::vector<const Path*> paths_;
  FollowingSettings settings_;
  PathPosition place_;
  Point3 tip_ = Point3::Zero();  ///< position of the nozzle when `place_` was accepted
  std::optional<Guess> guess_;
  double look_ahead_mm_;
  bool is_found_ = false;  ///< whether the nozzle was found since `begin`
};

}  // namespace lamina
