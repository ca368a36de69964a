// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/run/pose_watches.hpp"

#include <algorithm>

#include "control/run/stamps.hpp"

namespace lamina {

void PoseWatches::hear(const std::string& sensor, std::int64_t stamp_ns,
                       const std::optional<std::int64_t>& tip_ns) {
  Sensor& heard = sensors_.try_emplace(sensor, Sensor{{}, stamp_ns, {}}).first->second;
  heard.watch.hear(stamp_ns, tip_ns);
  for (const auto& [name, other] : sensors_)
    if (name != sensor) heard.others_ns[name] = *other.watch.last();
}

/// Time of the other sensors since it was heard, by their own stamps: of one that came up since from its
/// first cloud on.
bool PoseWatches::counts(const std::string& name, const Sensor& sensor) const {
  return std::all_of(sensors_.begin(), sensors_.end(), [&](const auto& other) {
    const auto then = sensor.others_ns.find(other.first);
    const std::int64_t since = then == sensor.others_ns.end() ? other.second.first_ns : then->second;
    return other.first == name || secondsFrom(since, *other.second.watch.last()) <= silence_s_;
  });
}

double PoseWatches::blind(const std::optional<std::int64_t>& tip_ns) const {
  std::optional<double> least_s;
  for (const auto& [name, sensor] : sensors_) {
    if (!counts(name, sensor)) continue;
    const double blind_s = sensor.watch.blind(tip_ns);
    least_s = std::min(least_s.value_or(blind_s), blind_s);
  }
  return least_s.value_or(0.0);
}

bool PoseWatches::isWithoutPose(const std::optional<std::int64_t>& tip_ns) const {
  bool is_any = false;
  for (const auto& [name, sensor] : sensors_) {
    if (!counts(name, sensor)) continue;
    if (!sensor.watch.isWithoutPose(tip_ns)) return false;
    is_any = true;
  }
  return is_any;
}

bool PoseWatches::isHeard(std::int64_t stamp_ns) const {
  return std::any_of(sensors_.begin(), sensors_.end(), [&](const auto& named) {
    return secondsFrom(*named.second.watch.last(), stamp_ns) < silence_s_;
  });
}

}  // namespace lamina
