// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/run/sensor_watches.hpp"

#include <algorithm>

namespace lamina {

bool SensorWatches::Sensor::isStuck() const { return lamina::isStuck(watch.profiles(), watch.variance()); }

bool SensorWatches::see(const SensedCloud& cloud, std::size_t layer) {
  Sensor& sensor = sensors_[cloud.sensor];
  const bool was_stuck = sensor.isStuck();
  sensor.layer = layer;
  for (const auto& profile : cloud.profiles) sensor.watch.see(profile);
  return !was_stuck && sensor.isStuck();
}

bool SensorWatches::isStuck(const std::string& sensor) const {
  const auto known = sensors_.find(sensor);
  return known != sensors_.end() && known->second.isStuck();
}

bool SensorWatches::isAnyLive(std::size_t layer) const {
  return std::any_of(sensors_.begin(), sensors_.end(), [layer](const auto& named) {
    return !named.second.isStuck() && named.second.layer + 1 >= layer;
  });
}

void SensorWatches::judge(std::size_t layer, SensorWatch& seen) const {
  seen.is_seen_otherwise = isAnyLive(layer);
  for (const auto& [name, sensor] : sensors_) {
    if (sensor.watch.profiles() <= seen.profiles) continue;
    seen.profiles = sensor.watch.profiles();
    seen.variance_mm2 = sensor.watch.variance();
    seen.sensor = name;
  }
}

}  // namespace lamina
