// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "lamina/planning/cooling/cooling_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"
#include "lamina/toolpath/waypoint_index.hpp"

namespace lamina {

/// Shares of roles in `fan.by_role`; none for the others.
/// @throws InvalidConfig if it is no list of roles and shares, or names a role that has a setting of its own
std::array<std::optional<double>, kPathRoles> roleSharesOf(const FanSettings& settings);

/// A change of the fan's share before a motion.
struct FanChange {
  WaypointIndex before;  ///< the motion that begins at that waypoint
  double share = 0.0;
};

/// A layer as the fan takes it.
struct FanLayer {
  std::size_t index = 0;     ///< in the toolpath
  std::size_t from_bed = 0;  ///< layer number from 0; in each part if parts are printed one after the other
  double share = 0.0;        ///< of roles without a share of their own
};

/// Finds the changes of the fan's share by 1/255 or more.
class FanSchedule {
 public:
  /// @param settings  must outlive this
  explicit FanSchedule(const FanSettings& settings) : settings_(settings), by_role_(roleSharesOf(settings)) {}

  /// Adds the changes of the next layer: at its start, at roles with shares of their own, and before and
  /// after unsupported stretches. Stretches shorter than 2 mm, and gaps shorter than 2 mm between stretches,
  /// are ignored: no fan reacts that fast.
  void add(const std::vector<Path>& paths, const FanLayer& layer);

  bool isOn() const { return steps_ != 0; }
  /// The changes in the order of motion.
  const std::vector<FanChange>& changes() const { return changes_; }

 private:
  double shareOf(PathRole role, const FanLayer& layer) const;
  void addPath(const Path& path, const WaypointIndex& begin, double share);
  void change(const WaypointIndex& before, double share);

  const FanSettings& settings_;
  std::array<std::optional<double>, kPathRoles> by_role_;
  std::vector<FanChange> changes_;
  std::int64_t steps_ = 0;
};

/// Adds the event before its motion.
void addEvent(Path& path, std::size_t motion, double share);

}  // namespace lamina
