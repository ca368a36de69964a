// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/cooling/fan_switch.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "planning/overhangs/overhanging_path.hpp"

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

void FanSwitch::addTo(std::vector<Path>& paths, double share) {
  change(paths.front(), 0, share);
  for (Path& path : paths)
    if (path.role != PathRole::Travel) addTo(path, share);
}

void FanSwitch::addTo(Path& path, double share) {
  const bool spans = path.role == PathRole::Bridge || path.role == PathRole::Skin;
  if (path.role != PathRole::Bridge && unsupportedOf(path) == nullptr) return change(path, 0, share);
  const HangingMotions hangs(path);
  for (std::size_t m = 0; m < path.motionCount(); ++m)
    change(path, m, !hangs.at(m) ? share : spans ? settings_.bridge : settings_.overhang);
}

void FanSwitch::change(Path& path, std::size_t motion, double share) {
  constexpr double kSteps = 255.0;
  const std::int64_t steps = std::llround(share * kSteps);
  if (std::exchange(steps_, steps) == steps) return;
  PathEvent event;
  event.motion = motion;
  event.event.emplace<FanShare>(FanShare{share});
  const auto at = std::find_if(path.events.begin(), path.events.end(),
                               [motion](const PathEvent& other) { return other.motion >= motion; });
  path.events.insert(at, std::move(event));
}

}  // namespace lamina
