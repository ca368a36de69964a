// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/run/sensor_watches.hpp"

namespace lamina {

void SensorWatches::see(const SensedCloud& cloud, std::size_t layer) {
  Sensor& sensor = sensors_[cloud.sensor];
  sensor.layer = layer;
  for (const auto& profile : cloud.profiles) sensor.watch.see(profile);
}

bool SensorWatches::isStuck(const std::string& sensor) const {
  const auto known = sensors_.find(sensor);
  return known != sensors_.end() &&
         lamina::isStuck(known->second.watch.profiles(), known->second.watch.variance());
}

void SensorWatches::judge(std::size_t layer, SensorWatch& seen) const {
  for (const auto& [name, sensor] : sensors_) {
    const bool measures = !isStuck(name) && sensor.layer + 1 >= layer;
    if (measures) seen.is_seen_otherwise = true;
    if (sensor.watch.profiles() <= seen.profiles) continue;
    seen.profiles = sensor.watch.profiles();
    seen.variance_mm2 = sensor.watch.variance();
    seen.sensor = name;
  }
}

}  // namespace lamina
