// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/gcode/path_arcs.hpp"

#include <cmath>

namespace lamina {
namespace {

constexpr double kSameFeed = 0.01;
constexpr double kSameLevel = 1e-4;  // mm: a tenth of the last decimal

/// Whether a motion can be in an arc that another one begins.
bool isAlike(const Path& path, std::size_t first, std::size_t motion) {
  const std::size_t a = path.motionEnd(first);
  const std::size_t b = path.motionEnd(motion);
  const auto events = eventsBefore(path.events, motion);
  return path.bead.at(a) == path.bead.at(b) &&
         std::abs(path.feed_mm_s.at(b) - path.feed_mm_s.at(a)) <= kSameFeed * path.feed_mm_s.at(a) &&
         events.begin() == events.end();
}

}  // namespace

PathArcs::PathArcs(const Path& path, const std::vector<Point3>& places, double tolerance_mm)
    : alike_up_to_(path.motionCount()), tolerance_mm_(tolerance_mm) {
  places_.reserve(places.size());
  for (const Point3& place : places) places_.push_back(place.head<2>());
  for (std::size_t first = 0; first < alike_up_to_.size();) {
    const auto is_level = [&](std::size_t motion) {
      return std::abs(places[motion + 1].z() - places[first].z()) <= kSameLevel;
    };
    std::size_t end = first;
    if (is_level(first))
      for (++end; end < alike_up_to_.size() && is_level(end) && isAlike(path, first, end);) ++end;
    const std::size_t next = std::max(end, first + 1);
    for (; first < next; ++first) alike_up_to_[first] = end;
  }
}

std::optional<FittedArc> PathArcs::from(std::size_t motion) const {
  if (alike_up_to_[motion] < motion + 3) return std::nullopt;
  return longestArc(places_, motion, alike_up_to_[motion], tolerance_mm_);
}

}  // namespace lamina
