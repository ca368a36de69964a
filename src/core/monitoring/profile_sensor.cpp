// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/monitoring/profile_sensor.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"

namespace lamina {
namespace {

constexpr double kHour = 3600.0;                    // s
constexpr std::uint64_t kDefects = 0x5DEECE66DULL;  // other numbers than those of the noise

/// Part of a ray within the measuring range [mm, bed frame].
struct Ray {
  Point3 near;
  Point3 far;
};

/// Part of the ray, as a fraction of its length, that lies above all of the surface.
double clearPart(const Ray& ray, double highest) {
  const double fall = ray.near.z() - ray.far.z();
  return fall > 0.0 ? std::clamp((ray.near.z() - highest) / fall, 0.0, 1.0) : 0.0;
}

/// Where a ray crosses from column to column of a grid along one axis, as fractions of its length.
struct Crossings {
  Crossings(double start, double along, double from)
      : step(along < 0.0 ? -1 : 1), index(static_cast<int>(std::floor(start + from * along))) {
    if (along == 0.0) return;
    each = std::abs(1.0 / along);
    next = (index + (step > 0 ? 1 : 0) - start) / along;
  }
  void cross() {
    index += step;
    next += each;
  }

  int step;
  int index;
  double each = std::numeric_limits<double>::infinity();
  double next = std::numeric_limits<double>::infinity();
};

/// Where the ray meets the columns of the map, as a fraction of its length, from a fraction on. A column
/// higher than the ray's entry is met at its side.
std::optional<double> firstHit(const HeightSource& surface, const Ray& ray, double from) {
  const HeightGrid& grid = surface.grid;
  const Point3 along = ray.far - ray.near;
  const Point2 start = (ray.near.head<2>() - grid.origin) / grid.cell_mm;
  Crossings x(start.x(), along.x() / grid.cell_mm, from);
  Crossings y(start.y(), along.y() / grid.cell_mm, from);
  double entry = from;
  while (entry < 1.0) {
    const double exit = std::min({x.next, y.next, 1.0});
    if (grid.contains(x.index, y.index)) {
      const double height = surface.height(x.index, y.index);
      if (ray.near.z() + entry * along.z() <= height) return entry;
      if (ray.near.z() + exit * along.z() <= height) return (height - ray.near.z()) / along.z();
    }
    entry = exit;
    (x.next < y.next ? x : y).cross();
  }
  return std::nullopt;
}

/// Where the sensor is that is thought to be at a pose.
Eigen::Isometry3d movedPose(const Eigen::Isometry3d& thought, const ProfileSensorSettings& settings,
                            double now_s) {
  if (settings.moved_mm.size() != 3 || now_s < settings.moved_at_s) return thought;
  return thought * Eigen::Translation3d(settings.moved_mm[0], settings.moved_mm[1], settings.moved_mm[2]);
}

bool isChosen(Random& random, double rate) { return rate > 0.0 && random.uniform(0.0, 1.0) < rate; }

}  // namespace

ProfileSensor::ProfileSensor(const ProfileSensorSettings& settings)
    : settings_(settings),
      random_(static_cast<std::uint64_t>(settings.seed)),
      defects_(static_cast<std::uint64_t>(settings.seed) ^ kDefects) {
  if (!(settings.range_mm < 2.0 * settings.stand_off_mm))
    throw InvalidConfig("sensor.range_mm is " + numberText(settings.range_mm) +
                        "; must be below twice sensor.stand_off_mm, " +
                        numberText(2.0 * settings.stand_off_mm));
}

/// Along a profile a process of first order, so that neighbours correlate as set.
double ProfileSensor::noise() {
  if (!(settings_.noise_mm > 0.0)) return 0.0;
  const double fresh = random_.normal(0.0, settings_.noise_mm);
  const double rho = settings_.noise_correlation;
  if (rho == 0.0) return fresh;
  last_noise_mm_ = last_noise_mm_ ? rho * *last_noise_mm_ + std::sqrt(1.0 - rho * rho) * fresh : fresh;
  return *last_noise_mm_;
}

std::vector<Point3> ProfileSensor::measure(const HeightSource& surface,
                                           const Eigen::Isometry3d& thought_from_sensor, double highest,
                                           double now_s) {
  const Eigen::Isometry3d bed_from_sensor = movedPose(thought_from_sensor, settings_, now_s);
  std::vector<Point3> points;
  points.reserve(static_cast<std::size_t>(settings_.points));
  last_noise_mm_.reset();
  const double nearest = settings_.stand_off_mm - 0.5 * settings_.range_mm;
  const double farthest = settings_.stand_off_mm + 0.5 * settings_.range_mm;
  const double shift = settings_.bias_mm + settings_.drift_mm_h * now_s / kHour;
  for (int i = 0; i < settings_.points; ++i) {
    const double across = settings_.points == 1 ? 0.0 : double(i) / (settings_.points - 1) - 0.5;
    const Point3 per_mm(across * settings_.width_mm / settings_.stand_off_mm, 0.0, 1.0);
    const Ray ray{bed_from_sensor * Point3(nearest * per_mm), bed_from_sensor * Point3(farthest * per_mm)};
    const auto hit = firstHit(surface, ray, clearPart(ray, highest));
    const double noise_mm = noise();
    if (!hit) continue;
    const double depth = nearest + *hit * (farthest - nearest);
    if (!(*hit > 0.0) || isChosen(defects_, settings_.dropout_rate)) continue;
    if (isChosen(defects_, settings_.spray_rate)) {
      points.push_back(defects_.uniform(nearest, depth) * per_mm);
    } else {
      points.push_back(depth * per_mm + Point3(0.0, 0.0, noise_mm));
      if (shift != 0.0) points.back().z() += shift;
      if (settings_.lateral_noise_mm > 0.0)
        points.back().x() += defects_.normal(0.0, settings_.lateral_noise_mm);
    }
    if (isChosen(defects_, settings_.mirror_rate))
      points.push_back(defects_.uniform(depth, farthest) * per_mm);
  }
  return points;
}

double ProfileSensor::stampError() {
  const double jitter = settings_.stamp_jitter_s > 0.0 ? defects_.normal(0.0, settings_.stamp_jitter_s) : 0.0;
  return settings_.time_offset_s + jitter;
}

namespace {

void describeDefects(SettingsSchema& schema, ProfileSensorSettings& settings) {
  const Bounds share{0.0, 1.0};
  schema.number("sensor.noise_correlation", settings.noise_correlation, {0.0, 0.999},
                "Correlation of the noise from one point of a profile to the next.");
  schema.number("sensor.lateral_noise_mm", settings.lateral_noise_mm, {0.0, 10.0},
                "Standard deviation of points along the line of light.");
  schema.number("sensor.time_offset_s", settings.time_offset_s, {-10.0, 10.0}, "Stamp less true time.");
  schema.number("sensor.stamp_jitter_s", settings.stamp_jitter_s, {0.0, 1.0},
                "Standard deviation of stamps.");
  schema.number("sensor.spray_rate", settings.spray_rate, share,
                "Share of points that show spray above the surface.");
  schema.number("sensor.mirror_rate", settings.mirror_rate, share,
                "Share of points with a second return behind them.");
  schema.number("sensor.dropout_rate", settings.dropout_rate, share, "Share of points that are missing.");
  schema.number("sensor.bias_mm", settings.bias_mm, {-100.0, 100.0}, "Added to depths.");
  schema.number("sensor.drift_mm_h", settings.drift_mm_h, {-100.0, 100.0}, "Added to depths per hour.");
  schema.numbers(
      "sensor.moved_mm", settings.moved_mm, 3,
      "Where the sensor is, off where it is thought to be: along its line, across it, along its beam.");
  schema.number("sensor.moved_at_s", settings.moved_at_s, {0.0, 1e6}, "Time from which on it is there.");
}

}  // namespace

void describe(SettingsSchema& schema, ProfileSensorSettings& settings) {
  const Bounds length = Bounds::above(0.0, 1000.0);
  schema.number("sensor.width_mm", settings.width_mm, length, "Width of the line of light at the stand-off.");
  schema.integer("sensor.points", settings.points, {1, 100000}, "Points of a profile.");
  schema.number("sensor.stand_off_mm", settings.stand_off_mm, length, "Distance of the middle of the range.");
  schema.number("sensor.range_mm", settings.range_mm, length,
                "Depth of the measuring range around the stand-off.");
  schema.number("sensor.noise_mm", settings.noise_mm, {0.0, 10.0}, "Standard deviation of a point's depth.");
  schema.integer("sensor.seed", settings.seed, {0, 2147483647}, "Seed of the noise.");
  describeDefects(schema, settings);
}

}  // namespace lamina
