// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gcode_rewrite/filament_words.hpp"

#include <cmath>

namespace lamina {
namespace {

constexpr double kNoLength = 1e-9;  // mm

/// Length after over length before; 1 where there is none.
double ratio(double after, double before) { return before > kNoLength ? after / before : 1.0; }

}  // namespace

double FilamentWords::extrusion(const ProgramTracker& tracker, double pushed, const Point3& from,
                                const Point3& to) {
  double factor = 1.0;
  if (rule_ == ExtrusionRule::ByVolume)
    factor = transform_.map.volumeRatio(0.5 * (from + to));
  else if (rule_ == ExtrusionRule::ByLength)
    factor = ratio((transform_.overBed(to) - transform_.overBed(from)).norm(), (to - from).norm());
  return push(tracker, factor * pushed);
}

double FilamentWords::extrusionAlone(const ProgramTracker& tracker, double pushed) {
  return push(tracker, pushed);
}

double FilamentWords::push(const ProgramTracker& tracker, double pushed) {
  written_filament_ += pushed;
  return tracker.isExtrusionRelative() ? pushed : written_filament_;
}

std::optional<double> FilamentWords::feed(const ProgramTracker& tracker, const Point3& from,
                                          const Point3& to) {
  const Point3 mapped_from = transform_.coordinates(transform_.overBed(from));
  const Point3 mapped_to = transform_.coordinates(transform_.overBed(to));
  return newFeed(tracker, tracker.feed() * ratio((mapped_to - mapped_from).norm(), (to - from).norm()));
}

std::optional<double> FilamentWords::feedAlone(const ProgramTracker& tracker) {
  return newFeed(tracker, tracker.feed());
}

std::optional<double> FilamentWords::newFeed(const ProgramTracker& tracker, double feed) {
  constexpr double kSame = 5e-3;                                // mm/min: the last decimal written
  const bool is_told = tracker.command().find('F') != nullptr;  // the source's own F must not stay there
  if (feed == 0.0 || (std::abs(feed - written_feed_) < kSame && !is_told)) return std::nullopt;
  written_feed_ = feed;
  return feed;
}

}  // namespace lamina
