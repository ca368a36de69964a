// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/run/sensor_motion.hpp"

#include "control/run/stamps.hpp"

namespace lamina {

void SensorMotion::see(std::int64_t stamp_ns, const Point3& at) {
  constexpr double kSteady = 0.5;  // s
  const double span_s = stamp_ns_ ? secondsFrom(*stamp_ns_, stamp_ns) : 0.0;
  const bool is_steady = span_s > 0.0 && span_s <= kSteady;
  velocity_ = is_steady ? Eigen::Vector3d((at - at_) / span_s) : Eigen::Vector3d::Zero();
  at_ = at;
  stamp_ns_ = stamp_ns;
}

}  // namespace lamina
