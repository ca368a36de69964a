// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/cooling/fan_schedule.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "lamina/base/error.hpp"
#include "planning/overhangs/overhanging_path.hpp"
#include "planning/role_values.hpp"

namespace lamina {
namespace {

constexpr double kShortestChange = 2.0;  // mm

/// Motions of a path that lie over nothing.
class HangingMotions {
 public:
  explicit HangingMotions(const Path& path) : hangs_(path.motionCount(), path.role == PathRole::Bridge) {
    const ProcessValue* unsupported = unsupportedOf(path);
    if (unsupported == nullptr) return;
    for (std::size_t m = 0; m < hangs_.size(); ++m) {
      const std::size_t end = path.motionEnd(m);
      hangs_[m] = unsupported->value.at(end) > 0.0;
      length_mm_.push_back((path.points[end] - path.points[m]).norm());
    }
    if (unsupported->value.isCommon()) return;
    overwriteShort(false);
    overwriteShort(true);
  }

  bool at(std::size_t motion) const { return hangs_[motion]; }

 private:
  /// Stretches that are of that kind, between others of the other kind, but too short.
  void overwriteShort(bool kind) {
    for (std::size_t begin = 0; begin < hangs_.size();) {
      std::size_t end = begin;
      double length = 0.0;
      for (; end < hangs_.size() && hangs_[end] == hangs_[begin]; ++end) length += length_mm_[end];
      const bool is_gap_at_end = !kind && (begin == 0 || end == hangs_.size());
      if (hangs_[begin] == kind && length < kShortestChange && !is_gap_at_end)
        std::fill(hangs_.begin() + static_cast<std::ptrdiff_t>(begin),
                  hangs_.begin() + static_cast<std::ptrdiff_t>(end), !kind);
      begin = end;
    }
  }

  std::vector<bool> hangs_;
  std::vector<double> length_mm_;
};

}  // namespace

std::array<std::optional<double>, kPathRoles> roleSharesOf(const FanSettings& settings) {
  auto shares = roleValues(settings.by_role, {"fan.by_role", 1.0, "a share in [0, 1]",
                                              "a role, '=' and a share, as support_interface=1"});
  const auto refuse = [&shares](PathRole role, const std::string& expected) {
    if (shares[static_cast<std::size_t>(role)])
      throw InvalidConfig("fan.by_role names " + std::string(toString(role)) + "; expected " + expected);
  };
  refuse(PathRole::Travel, "a role that is deposited");
  refuse(PathRole::Bridge, "the share of bridges as fan.bridge");
  return shares;
}

void FanSchedule::add(const std::vector<Path>& paths, const FanLayer& layer) {
  const auto first = std::find_if(paths.begin(), paths.end(),
                                  [](const Path& path) { return path.role != PathRole::Travel; });
  change({layer.index, 0, 0}, first == paths.end() ? layer.share : shareOf(first->role, layer));
  for (std::size_t p = 0; p < paths.size(); ++p)
    if (paths[p].role != PathRole::Travel)
      addPath(paths[p], {layer.index, p, 0}, shareOf(paths[p].role, layer));
}

double FanSchedule::shareOf(PathRole role, const FanLayer& layer) const {
  if (layer.from_bed < static_cast<std::size_t>(settings_.off_layers)) return layer.share;
  return by_role_[static_cast<std::size_t>(role)].value_or(layer.share);
}

void FanSchedule::addPath(const Path& path, const WaypointIndex& begin, double share) {
  const bool spans = path.role == PathRole::Bridge || path.role == PathRole::Skin;
  if (path.role != PathRole::Bridge && unsupportedOf(path) == nullptr) return change(begin, share);
  const HangingMotions hangs(path);
  for (std::size_t m = 0; m < path.motionCount(); ++m)
    change({begin.layer, begin.path, m}, !hangs.at(m) ? share
                                         : spans      ? settings_.bridge
                                                      : settings_.overhang);
}

void FanSchedule::change(const WaypointIndex& before, double share) {
  constexpr double kSteps = 255.0;
  const std::int64_t steps = std::llround(share * kSteps);
  if (std::exchange(steps_, steps) == steps) return;
  changes_.push_back({before, share});
}

void addEvent(Path& path, std::size_t motion, double share) {
  PathEvent event;
  event.motion = motion;
  event.event.emplace<FanShare>(FanShare{share});
  const auto at = std::find_if(path.events.begin(), path.events.end(),
                               [motion](const PathEvent& other) { return other.motion >= motion; });
  path.events.insert(at, std::move(event));
}

}  // namespace lamina
