// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "lamina/base/settings_schema.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// A place on a toolpath. Places are in the order in which the nozzle comes by.
struct PathPlace {
  std::size_t path = 0;    ///< counted through all layers; as many as there are at the end
  std::size_t motion = 0;  ///< of the path
  double fraction = 0.0;   ///< of the motion, 0 to 1

  friend bool operator==(const PathPlace& a, const PathPlace& b) {
    return a.path == b.path && a.motion == b.motion && a.fraction == b.fraction;
  }
};

/// How the nozzle's reported positions are taken for places on a toolpath.
struct FollowingSettings {
  double tolerance_mm = 0.15;     ///< greatest distance of the nozzle from the toolpath to be on it
  double look_ahead_mm = 1000.0;  ///< of the toolpath, from one report to the next
};

/// Adds the keys following.tolerance_mm and following.look_ahead_mm.
void describe(SettingsSchema& schema, FollowingSettings& settings);

/// Derives from reported positions how far along a toolpath the nozzle is. The place never goes back, and all
/// motions between two places count as run.
///
/// A position is taken for the nearest place of the first stretch ahead that passes within the tolerance. The
/// place counts at once if the nozzle has come there along the toolpath, as it does where reports are dense
/// or include every corner. Otherwise the place is a guess. A guess counts once `kSureOnTheWay` reports in a
/// row have gone on from it along the toolpath. It also counts once `kSureAhead` reports in a row were found
/// at places ahead, however far, each at least a tolerance apart. So no crossing, neighbouring line, stray
/// report or foreign motion leads ahead. Positions off the toolpath change nothing. Until the nozzle was
/// found for the first time, only paths that deposit count, because the way to the start may lead along
/// travels of later layers.
///
/// Cost of a report is that of the motions up to its place; off the toolpath, of those within the look-ahead.
class PathFollower {
 public:
  static constexpr int kSureOnTheWay = 3;
  static constexpr int kSureAhead = 20;

  /// @param toolpath  in the frame of the positions; must outlive this
  /// @throws InvalidInput as `validate`
  PathFollower(const Toolpath& toolpath, const FollowingSettings& settings);

  /// States that the nozzle is at the beginning of a path or after it. The nozzle is looked for that far
  /// ahead until it is found.
  /// @param path  counted through all layers; as many as there are for the end
  void begin(std::size_t path, double look_ahead_mm);

  /// Returns the place after a report of the nozzle at `tip` [mm]. A tip that is not finite changes nothing.
  PathPlace observe(const Point3& tip);

  const PathPlace& place() const { return place_; }
  bool isAtEnd() const { return place_.path == paths_.size(); }
  /// All paths in the order they are run.
  const std::vector<const Path*>& paths() const { return paths_; }

 private:
  /// A place ahead, and how far [mm].
  struct Found {
    PathPlace place;
    double way_mm = 0.0;
  };
  /// A place that a report may have been at.
  struct Guess {
    PathPlace place;
    Point3 tip = Point3::Zero();
    int on_the_way = 1;  ///< reports in a row
    int ahead = 1;       ///< reports in a row
  };

  std::optional<Found> firstNear(const PathPlace& from, const Point3& tip) const;
  bool isOnTheWay(const Found& found, const Point3& from, const Point3& tip) const;
  bool goesOn(const Point3& tip);
  void accept(const PathPlace& place, const Point3& tip);
  void skipEmptyPaths();
  PathPlace endIfNear(const PathPlace& place) const;

  std::vector<const Path*> paths_;
  FollowingSettings settings_;
  PathPlace place_;
  Point3 tip_ = Point3::Zero();  ///< where the nozzle was at `place_`
  std::optional<Guess> guess_;
  double look_ahead_mm_;
  bool is_found_ = false;  ///< since its beginning
};

}  // namespace lamina
