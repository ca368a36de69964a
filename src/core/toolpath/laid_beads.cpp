// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/toolpath/laid_beads.hpp"

#include <algorithm>
#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/toolpath/waypoint_text.hpp"

namespace lamina {
namespace {

constexpr double kSameLength = 1e-6;  // mm: what sums of lengths may differ by
constexpr double kAsNear = 0.02;      // mm
constexpr double kApart = 1.0;        // mm of bead by which two places differ

Point3 axisOf(const Path& path, std::size_t waypoint) {
  return path.orientation.at(waypoint) * Point3::UnitZ();
}

/// Share of the way from one point to another that is nearest to a place.
double nearestShare(const Point3& from, const Point3& to, const Point3& place) {
  const Point3 way = to - from;
  const double length2 = way.squaredNorm();
  return length2 > 0.0 ? std::clamp((place - from).dot(way) / length2, 0.0, 1.0) : 0.0;
}

}  // namespace

LaidBeads::LaidBeads(const Toolpath& toolpath) {
  double sum_mm = 0.0;
  for (std::size_t l = 0; l < toolpath.layers.size(); ++l)
    for (std::size_t p = 0; p < toolpath.layers[l].paths.size(); ++p) {
      const Path& path = toolpath.layers[l].paths[p];
      for (std::size_t m = 0; m < path.motionCount(); ++m) {
        const std::size_t end = path.motionEnd(m);
        const double area_mm2 = crossSection(path.bead.at(end));
        motions_.push_back(
            {{l, p, end}, path.points[m], path.points[end], axisOf(path, m), axisOf(path, end), area_mm2});
        if (area_mm2 > 0.0) {
          sum_mm += (path.points[end] - path.points[m]).norm();
          greatest_feed_mm_s_ = std::max(greatest_feed_mm_s_, path.feed_mm_s.at(end));
        }
        laid_.push_back(sum_mm);
      }
    }
}

double LaidBeads::before(const WaypointIndex& waypoint) const {
  for (std::size_t i = 0; i < motions_.size(); ++i) {
    const WaypointIndex& end = motions_[i].end;
    if (end.layer != waypoint.layer || end.path != waypoint.path) continue;
    if (waypoint.waypoint == 0) return i == 0 ? 0.0 : laid_[i - 1];
    if (end.waypoint == waypoint.waypoint) return laid_[i];
  }
  throw InvalidInput("the toolpath has no " + toText(waypoint));
}

/// The first motion by whose end more is laid; the one past the last if there is none.
std::size_t LaidBeads::motionAt(double length_mm) const {
  return static_cast<std::size_t>(std::upper_bound(laid_.begin(), laid_.end(), length_mm + kSameLength) -
                                  laid_.begin());
}

double LaidBeads::volume(double length_mm) const {
  double sum_mm3 = 0.0;
  double begin_mm = 0.0;
  for (std::size_t i = 0; i < motions_.size() && begin_mm < length_mm; ++i) {
    sum_mm3 += motions_[i].area_mm2 * (std::min(length_mm, laid_[i]) - begin_mm);
    begin_mm = laid_[i];
  }
  return sum_mm3;
}

double LaidBeads::beadStart(double length_mm) const {
  std::size_t i = motionAt(length_mm);
  if (i >= motions_.size()) return total();
  while (i > 0 && motions_[i - 1].area_mm2 > 0.0) --i;
  return i == 0 ? 0.0 : laid_[i - 1];
}

WaypointIndex LaidBeads::headingFor(double length_mm) const {
  if (motions_.empty()) return {};
  return motions_[std::min(motionAt(length_mm), motions_.size() - 1)].end;
}

std::vector<LaidBeads::Candidate> LaidBeads::candidates(const Eigen::Isometry3d& nozzle,
                                                        const LaidSearch& search) const {
  const Point3 tip = nozzle.translation();
  const Point3 axis = nozzle.linear() * Point3::UnitZ();
  const double from_mm = search.reported_mm - search.behind_mm - kSameLength;
  const double to_mm = search.reported_mm + search.ahead_mm + kSameLength;
  std::vector<Candidate> near;
  if (motions_.empty()) return near;
  const std::size_t last = std::min(motionAt(search.reported_mm), motions_.size() - 1);
  const Motion& reported = motions_[last];
  const double begin_mm = last == 0 ? 0.0 : laid_[last - 1];
  const double length_mm = laid_[last] - begin_mm;
  const double part =
      length_mm > 0.0 ? std::clamp((search.reported_mm - begin_mm) / length_mm, 0.0, 1.0) : 1.0;
  const Point3 reported_at = reported.from + part * (reported.to - reported.from);
  const auto first = std::lower_bound(laid_.begin(), laid_.end(), from_mm);
  for (auto i = static_cast<std::size_t>(first - laid_.begin()); i < motions_.size(); ++i) {
    const Motion& motion = motions_[i];
    const double start_mm = i == 0 ? 0.0 : laid_[i - 1];
    if (start_mm > to_mm) break;
    const double share = nearestShare(motion.from, motion.to, tip);
    const Point3 at = motion.from + share * (motion.to - motion.from);
    if ((at - tip).norm() > search.tolerance_mm) continue;
    if (std::abs((at - reported_at).dot(axis)) > search.most_rise_mm) continue;
    const Point3 wanted = (motion.axis_from + share * (motion.axis_to - motion.axis_from)).normalized();
    if (std::acos(std::clamp(wanted.dot(axis), -1.0, 1.0)) > kAxisTolerance) continue;
    const double place_mm = start_mm + (motion.area_mm2 > 0.0 ? share * (laid_[i] - start_mm) : 0.0);
    if (place_mm >= from_mm && place_mm <= to_mm) near.push_back({place_mm, (at - tip).norm()});
  }
  return near;
}

std::optional<double> LaidBeads::find(const Eigen::Isometry3d& nozzle, const LaidSearch& search) const {
  const std::vector<Candidate> near = candidates(nozzle, search);
  if (near.empty()) return std::nullopt;
  const Candidate nearest = *std::min_element(
      near.begin(), near.end(), [](const Candidate& a, const Candidate& b) { return a.off_mm < b.off_mm; });
  for (const Candidate& other : near)
    if (std::abs(other.laid_mm - nearest.laid_mm) >= kApart && other.off_mm < 2.0 * nearest.off_mm + kAsNear)
      return std::nullopt;
  return nearest.laid_mm;
}

}  // namespace lamina
