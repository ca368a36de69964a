// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/monitoring/profile_sensor.hpp"

#include <cmath>
#include <optional>
#include <string>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

/// Part of a ray within the measuring range [mm, bed frame].
struct Ray {
  Point3 near;
  Point3 far;
};

/// Where the ray meets the columns of the map, as a fraction of its length.
std::optional<double> firstHit(const HeightMap& surface, const Ray& ray) {
  const Point3 along = ray.far - ray.near;
  const double horizontal = along.head<2>().norm();
  const int steps = 1 + static_cast<int>(std::ceil(2.0 * horizontal / surface.grid().cell_mm));
  double before = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double after = (i + 1.0) / steps;
    const Point3 middle = ray.near + 0.5 * (before + after) * along;
    const double height = surface.nearest(middle.head<2>());
    const double low = ray.near.z() + after * along.z();
    if (low <= height) {
      const double fraction = along.z() < 0.0 ? (height - ray.near.z()) / along.z() : before;
      // A column higher than the ray's entry is met at its side.
      return std::max(fraction, before);
    }
    before = after;
  }
  return std::nullopt;
}

}  // namespace

ProfileSensor::ProfileSensor(const ProfileSensorSettings& settings)
    : settings_(settings), random_(static_cast<std::uint64_t>(settings.seed)) {
  if (!(settings.range_mm < 2.0 * settings.stand_off_mm))
    throw InvalidConfig("sensor.range_mm is " + std::to_string(settings.range_mm) +
                        "; must be below twice sensor.stand_off_mm, " +
                        std::to_string(2.0 * settings.stand_off_mm));
}

std::vector<Point3> ProfileSensor::measure(const HeightMap& surface,
                                           const Eigen::Isometry3d& bed_from_sensor) {
  std::vector<Point3> points;
  points.reserve(static_cast<std::size_t>(settings_.points));
  const double nearest = settings_.stand_off_mm - 0.5 * settings_.range_mm;
  const double farthest = settings_.stand_off_mm + 0.5 * settings_.range_mm;
  for (int i = 0; i < settings_.points; ++i) {
    const double across = settings_.points == 1 ? 0.0 : double(i) / (settings_.points - 1) - 0.5;
    const Point3 per_mm(across * settings_.width_mm / settings_.stand_off_mm, 0.0, 1.0);
    const auto hit = firstHit(
        surface, {bed_from_sensor * Point3(nearest * per_mm), bed_from_sensor * Point3(farthest * per_mm)});
    const double noise = settings_.noise_mm > 0.0 ? random_.normal(0.0, settings_.noise_mm) : 0.0;
    if (!hit) continue;
    const double depth = nearest + *hit * (farthest - nearest);
    if (*hit > 0.0) points.push_back(depth * per_mm + Point3(0.0, 0.0, noise));
  }
  return points;
}

void describe(SettingsSchema& schema, ProfileSensorSettings& settings) {
  const Bounds length{0.0, 1000.0, true};
  schema.number("sensor.width_mm", settings.width_mm, length, "Width of the line of light at the stand-off.");
  schema.integer("sensor.points", settings.points, {1, 100000}, "Points of a profile.");
  schema.number("sensor.stand_off_mm", settings.stand_off_mm, length, "Distance of the middle of the range.");
  schema.number("sensor.range_mm", settings.range_mm, length,
                "Depth of the measuring range around the stand-off.");
  schema.number("sensor.noise_mm", settings.noise_mm, {0.0, 10.0}, "Standard deviation of a point's depth.");
  schema.integer("sensor.seed", settings.seed, {0, 2147483647}, "Seed of the noise.");
}

}  // namespace lamina
