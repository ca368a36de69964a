// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/gcode/path_builder.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "lamina/program/gcode/toolpath_from_gcode.hpp"
#include "program/motion_values.hpp"

namespace lamina {
namespace {

constexpr double kSamePoint = 1e-6;         // mm: below what programs resolve
constexpr double kFilamentRounding = 1e-5;  // mm: last decimal of E
constexpr double kLengthRounding = 1.5e-3;  // mm: diagonal of the last decimals of X and Y at both ends

bool deposits(const GcodeMotion& motion) { return motion.extrusion_mm > 0.0 && motion.start != motion.end; }

}  // namespace

double beadWidth(double area_mm2, double height_mm) {
  const double disc = 0.25 * M_PI * height_mm * height_mm;
  if (area_mm2 >= disc) return height_mm + (area_mm2 - disc) / height_mm;
  // An upright stadium of width w: (h - w) w + pi w² / 4 = area.
  constexpr double kMissing = 1.0 - 0.25 * M_PI;
  return (height_mm - std::sqrt(height_mm * height_mm - 4.0 * kMissing * area_mm2)) / (2.0 * kMissing);
}

PathBuilder::PathBuilder(const GcodeMotion& motion, bool is_retracted)
    : deposits_(lamina::deposits(motion)),
      is_retracted_(is_retracted && !deposits_),
      role_(motion.role),
      layer_height_mm_(motion.layer_height_mm),
      section_(motion.section),
      points_{motion.start} {
  add(motion);
}

bool PathBuilder::accepts(const GcodeMotion& motion, bool is_retracted) const {
  if (lamina::deposits(motion) != deposits_ || motion.start != points_.back()) return false;
  if (!deposits_) return is_retracted == is_retracted_;
  return motion.section == section_ && motion.role == role_;
}

void PathBuilder::add(const GcodeMotion& motion) {
  points_.push_back(motion.end);
  filament_mm_.push_back(motion.extrusion_mm);
  feed_mm_s_.push_back(motion.feed_mm_s);
  height_mm_.push_back(motion.height_mm);
}

void PathBuilder::addEvents(std::vector<ToolpathEvent> events) {
  for (ToolpathEvent& event : events) events_.push_back({feed_mm_s_.size() - 1, std::move(event)});
}

bool PathBuilder::isClosed() const {
  return deposits_ && points_.size() > 2 && (points_.back() - points_.front()).norm() < kSamePoint;
}

AlongPath<Bead> PathBuilder::beads(double layer_height_mm, double volume_per_filament) const {
  std::vector<double> lengths(filament_mm_.size());
  for (std::size_t m = 0; m < lengths.size(); ++m) lengths[m] = (points_[m + 1] - points_[m]).norm();
  const double mean = std::accumulate(filament_mm_.begin(), filament_mm_.end(), 0.0) /
                      std::accumulate(lengths.begin(), lengths.end(), 0.0);
  const auto bead = [&](double filament_per_length, std::size_t motion) {
    const double height_mm = height_mm_[motion].value_or(layer_height_mm);
    return Bead{beadWidth(filament_per_length * volume_per_filament, height_mm), height_mm};
  };
  bool is_common = true;
  for (std::size_t m = 0; m < lengths.size(); ++m)
    is_common &= height_mm_[m] == height_mm_.front() &&
                 std::abs(filament_mm_[m] - mean * lengths[m]) <= kFilamentRounding + mean * kLengthRounding;
  if (is_common) return bead(mean, 0);
  std::vector<Bead> each(lengths.size());
  for (std::size_t m = 0; m < lengths.size(); ++m) each[m] = bead(filament_mm_[m] / lengths[m], m);
  return perWaypoint(each, isClosed() ? PathClosure::Closed : PathClosure::Open);
}

Path PathBuilder::build(double layer_height_mm, double volume_per_filament) const {
  Path path;
  path.role = deposits_ ? role_.value_or(PathRole::Infill) : PathRole::Travel;
  path.is_closed = isClosed();
  path.process.is_retracted = is_retracted_;
  path.tool = tool_;
  path.events = events_;
  path.points = points_;
  if (path.is_closed) path.points.pop_back();
  path.feed_mm_s = perWaypoint(feed_mm_s_, path.is_closed ? PathClosure::Closed : PathClosure::Open);
  if (deposits_) path.bead = beads(layer_height_mm, volume_per_filament);
  return path;
}

}  // namespace lamina
