// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "control/program/deposit_cursor.hpp"

#include <algorithm>

namespace lamina {
namespace {

constexpr std::size_t kRunsAhead = 64;  // that a program may leave out
constexpr double kDetour = 1.1;         // way along the path over the chord

}  // namespace

DepositCursor::DepositCursor(const Toolpath& toolpath, double tolerance_mm) : tolerance_mm_(tolerance_mm) {
  for (std::size_t k = 0; k < toolpath.layers.size(); ++k)
    for (std::size_t p = 0; p < toolpath.layers[k].paths.size(); ++p) {
      const Path& path = toolpath.layers[k].paths[p];
      const bool deposits =
          path.role != PathRole::Travel && path.deposit == Deposit::Bead && path.motionCount() > 0;
      if (deposits) runs_.push_back({&path, k, p});
    }
  if (!runs_.empty()) last_length_mm_ = length(*runs_.back().path);
}

bool DepositCursor::isAtEnd() const {
  return runs_.empty() ||
         (place_.run + 1 == runs_.size() && place_.along_mm >= last_length_mm_ - tolerance_mm_);
}

bool DepositCursor::hasBegun(std::size_t layer) const {
  return !runs_.empty() && (place_.run > 0 || place_.along_mm > 0.0) && runs_[place_.run].layer >= layer;
}

Point3 DepositCursor::pointAt(const Place& place) const {
  const Path& path = *runs_[place.run].path;
  const Point3& start = path.points[place.motion];
  const Point3 way = path.points[path.motionEnd(place.motion)] - start;
  const double way_mm = way.norm();
  return way_mm > 0.0 ? Point3(start + way * (place.into_mm / way_mm)) : start;
}

bool DepositCursor::isAt(const Place& place, const Point3& point) const {
  return (pointAt(place) - point).norm() <= tolerance_mm_;
}

/// The nearest place to the end of a motion within its length along the path.
std::optional<DepositCursor::Place> DepositCursor::placeAhead(const Place& from, const Point3& start,
                                                              const Point3& end) const {
  const Path& path = *runs_[from.run].path;
  const double reach = from.along_mm + kDetour * (end - start).norm() + tolerance_mm_;
  std::optional<Place> nearest;
  double least = tolerance_mm_;
  double begin_mm = from.along_mm - from.into_mm;
  for (std::size_t m = from.motion; m < path.motionCount() && begin_mm <= reach; ++m) {
    const Point3& a = path.points[m];
    const Point3 way = path.points[path.motionEnd(m)] - a;
    const double length = way.norm();
    const double earliest = m == from.motion ? from.into_mm : 0.0;
    const double latest = std::max(earliest, std::min(length, reach - begin_mm));
    const double into = length > 0.0 ? std::clamp((end - a).dot(way) / length, earliest, latest) : 0.0;
    const Point3 near = length > 0.0 ? Point3(a + way * (into / length)) : a;
    const double off = (near - end).norm();
    // Of places that are equally near the later one: the way there has been run.
    if (off <= least) {
      least = off;
      nearest = Place{from.run, m, into, begin_mm + into};
    }
    begin_mm += length;
  }
  return nearest;
}

std::optional<DepositedStretch> DepositCursor::follow(const Point3& start, const Point3& end) {
  const std::size_t last = std::min(runs_.size(), place_.run + kRunsAhead);
  for (std::size_t r = place_.run; r < last; ++r) {
    const Place from = r == place_.run ? place_ : Place{r, 0, 0.0, 0.0};
    if (!isAt(from, start)) continue;
    const auto to = placeAhead(from, start, end);
    if (!to || (to->along_mm <= from.along_mm && (end - start).norm() > tolerance_mm_)) continue;
    place_ = *to;
    return DepositedStretch{runs_[r].layer, runs_[r].index, from.along_mm, to->along_mm};
  }
  return std::nullopt;
}

std::optional<DepositedStretch> DepositCursor::startingAt(const Point3& point) const {
  const std::size_t last = std::min(runs_.size(), place_.run + kRunsAhead);
  for (std::size_t r = place_.run + (place_.along_mm > 0.0 ? 1 : 0); r < last; ++r)
    if (isAt({r, 0, 0.0, 0.0}, point)) return DepositedStretch{runs_[r].layer, runs_[r].index, 0.0, 0.0};
  return std::nullopt;
}

}  // namespace lamina
