// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "passes.hpp"

#include <algorithm>
#include <cmath>

namespace lamina {
namespace {

constexpr double kSpeedTolerance = 0.5;               // of the usual one
constexpr double kAcross = 0.1;                       // of a step along the travel that may lead aside or up
constexpr double kAlongCosines[] = {0.0, 0.9, 0.99};  // to the travel, of what shows it ever better
constexpr double kLeastLength = 0.2;                  // of the longest pass

/// From one pose to the next.
struct Leg {
  double begin_s = 0.0;
  double end_s = 0.0;
  Point3 step = Point3::Zero();

  double seconds() const { return end_s - begin_s; }
};

std::vector<Leg> legsOf(const std::vector<RecordedPose>& poses) {
  std::vector<Leg> legs;
  for (std::size_t i = 1; i < poses.size(); ++i)
    legs.push_back({poses[i - 1].time_s, poses[i].time_s,
                    poses[i].bed_from_nozzle.translation() - poses[i - 1].bed_from_nozzle.translation()});
  return legs;
}

/// Main axis of the directions of level motion, weighted by time, of those within an angle of an axis.
Point2 mainAxis(const std::vector<Leg>& legs, const Point2& near, double least_cosine) {
  Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
  for (const Leg& leg : legs) {
    const Point2 level = leg.step.head<2>();
    if (level.norm() > std::abs(leg.step.z()) && std::abs(level.normalized().dot(near)) >= least_cosine)
      sum += leg.seconds() * level.normalized() * level.normalized().transpose();
  }
  if (sum.isZero(0.0)) return near;
  const double angle = 0.5 * std::atan2(2.0 * sum(0, 1), sum(0, 0) - sum(1, 1));
  return {std::cos(angle), std::sin(angle)};
}

/// Ways from pass to pass must not turn it.
Point2 travelOf(const std::vector<Leg>& legs) {
  Point2 travel = Point2::UnitY();
  for (const double cosine : kAlongCosines) travel = mainAxis(legs, travel, cosine);
  return travel.y() < 0.0 || (travel.y() == 0.0 && travel.x() < 0.0) ? Point2(-travel) : travel;
}

bool isAlong(const Leg& leg, const Point2& travel) {
  const double along = leg.step.head<2>().dot(travel);
  const Point2 across(-travel.y(), travel.x());
  return along != 0.0 && std::abs(leg.step.head<2>().dot(across)) <= kAcross * std::abs(along) &&
         std::abs(leg.step.z()) <= kAcross * std::abs(along);
}

/// Median over time of the speed along the travel.
double usualSpeed(const std::vector<Leg>& legs, const Point2& travel) {
  std::vector<std::pair<double, double>> speeds;
  double whole_s = 0.0;
  for (const Leg& leg : legs) {
    if (!isAlong(leg, travel) || !(leg.seconds() > 0.0)) continue;
    speeds.emplace_back(std::abs(leg.step.head<2>().dot(travel)) / leg.seconds(), leg.seconds());
    whole_s += leg.seconds();
  }
  std::sort(speeds.begin(), speeds.end());
  double before_s = 0.0;
  for (const auto& [speed, seconds] : speeds) {
    before_s += seconds;
    if (before_s >= 0.5 * whole_s) return speed;
  }
  return 0.0;
}

}  // namespace

Passes passesOf(const std::vector<RecordedPose>& poses) {
  const std::vector<Leg> legs = legsOf(poses);
  Passes passes;
  passes.travel = travelOf(legs);
  passes.speed_mm_s = usualSpeed(legs, passes.travel);
  bool goes_on = false;
  for (const Leg& leg : legs) {
    const double along = leg.step.head<2>().dot(passes.travel);
    const double speed = std::abs(along) / leg.seconds();
    const bool counts = isAlong(leg, passes.travel) &&
                        std::abs(speed - passes.speed_mm_s) <= kSpeedTolerance * passes.speed_mm_s;
    const double sense = along < 0.0 ? -1.0 : 1.0;
    if (counts && goes_on && passes.runs.back().sense == sense)
      passes.runs.back().end_s = leg.end_s;
    else if (counts)
      passes.runs.push_back({leg.begin_s, leg.end_s, sense});
    goes_on = counts;
  }
  double longest_s = 0.0;
  for (const Pass& pass : passes.runs) longest_s = std::max(longest_s, pass.end_s - pass.begin_s);
  const auto isShort = [&](const Pass& pass) { return pass.end_s - pass.begin_s < kLeastLength * longest_s; };
  passes.runs.erase(std::remove_if(passes.runs.begin(), passes.runs.end(), isShort), passes.runs.end());
  return passes;
}

}  // namespace lamina
