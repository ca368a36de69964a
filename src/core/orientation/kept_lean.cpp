// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/orientation/kept_lean.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "lamina/base/angle.hpp"
#include "lamina/orientation/no_spin.hpp"
#include "lamina/orientation/orientation_limits.hpp"
#include "lamina/orientation/path_tangents.hpp"
#include "orientation/travel_turn.hpp"

namespace lamina {
namespace {

constexpr double kUpright = 1e-9;    // deg: no lean
constexpr double kMostLean = 179.0;  // deg: beyond it there is no plane in which to raise

double leanOf(const Path& path, std::size_t waypoint, const Point3& up) {
  return angleDeg(toolAxisOf(path.orientation.at(waypoint)), -up);
}

Eigen::Quaterniond raisedFrame(const Eigen::Quaterniond& held, double kept, const Point3& up) {
  const Point3 axis = toolAxisOf(held);
  const double lean_deg = angleDeg(axis, -up);
  if (kept == 1.0 || lean_deg <= kUpright || lean_deg >= kMostLean) return held;
  const Point3 about = axis.cross(-up).normalized();
  return Eigen::AngleAxisd(toRadians((1.0 - kept) * lean_deg), about) * held;
}

}  // namespace

KeptLean::KeptLean(const Toolpath& wanted, const RaiseLimits& limits) : wanted_(wanted), limits_(limits) {
  for (std::size_t l = 0; l < wanted.layers.size(); ++l) {
    first_run_.emplace_back();
    for (std::size_t p = 0; p < wanted.layers[l].paths.size(); ++p) {
      first_run_.back().push_back(runs_.size());
      if (wanted.layers[l].paths[p].role != PathRole::Travel) runs_.push_back({l, p, {}, {}});
    }
  }
}

void KeptLean::raiseAt(const WaypointIndex& at) {
  const std::size_t next = first_run_[at.layer][at.path];
  if (wanted_.layers[at.layer].paths[at.path].role != PathRole::Travel)
    return raise(runs_[next], at.waypoint);
  if (next < runs_.size()) raise(runs_[next], 0);
  if (next == 0) return;
  const Path& before = pathOf(runs_[next - 1]);
  raise(runs_[next - 1], before.is_closed ? 0 : before.points.size() - 1);
}

void KeptLean::raise(Run& run, std::size_t waypoint) {
  const Path& path = pathOf(run);
  const std::size_t count = path.points.size();
  beginRaising(run);
  const double kept = std::max(run.least[waypoint], run.kept[waypoint] - limits_.step);
  const auto lower = [&](std::size_t i) {
    const double lowered = std::max(run.least[i], kept);
    is_changed_ = is_changed_ || lowered < run.kept[i];
    run.kept[i] = std::min(run.kept[i], lowered);
  };
  lower(waypoint);
  const std::vector<double> lengths = motionLengths(path);
  // A closed run goes on over its start.
  const std::size_t ahead = path.is_closed ? count - 1 : lengths.size() - waypoint;
  const std::size_t behind = path.is_closed ? count - 1 : waypoint;
  double way_mm = 0.0;
  for (std::size_t n = 0; n < ahead && (way_mm += lengths[(waypoint + n) % count]) <= limits_.reach_mm; ++n)
    lower((waypoint + n + 1) % count);
  way_mm = 0.0;
  for (std::size_t n = 1; n <= behind; ++n) {
    const std::size_t before = (waypoint + count - n) % count;
    if ((way_mm += lengths[before]) > limits_.reach_mm) break;
    lower(before);
  }
}

void KeptLean::beginRaising(Run& run) const {
  if (!run.kept.empty()) return;
  const Path& path = pathOf(run);
  run.kept.assign(path.points.size(), 1.0);
  for (std::size_t i = 0; i < path.points.size(); ++i) {
    const double lean_deg = leanOf(path, i, limits_.up);
    const bool is_raised = lean_deg > kUpright && lean_deg < kMostLean;
    run.least.push_back(is_raised ? std::max(0.0, 1.0 - limits_.most_deg / lean_deg) : 1.0);
  }
}

void KeptLean::limit(const std::function<double(const Point3&)>& most_deg) {
  for (Run& run : runs_) {
    const Path& path = pathOf(run);
    for (std::size_t i = 0; i < path.points.size(); ++i) {
      const double lean_deg = leanOf(path, i, limits_.up);
      const double most = most_deg(path.points[i]);
      if (lean_deg <= most) continue;
      beginRaising(run);
      const double kept = std::max(run.least[i], most / lean_deg);
      is_changed_ = is_changed_ || kept < run.kept[i];
      run.kept[i] = std::min(run.kept[i], kept);
    }
  }
}

/// No part of the lean that is kept rises faster along the run than it may.
void KeptLean::even(Run& run) const {
  const Path& path = pathOf(run);
  const std::vector<double> lengths = motionLengths(path);
  const std::size_t count = path.points.size();
  const auto follow = [&](std::size_t from, std::size_t to, double length_mm) {
    const double lean_deg = std::max(1.0, leanOf(path, to, limits_.up));
    const double most = run.kept[from] + limits_.most_deg_per_mm * length_mm / lean_deg;
    run.kept[to] = std::max(run.least[to], std::min(run.kept[to], most));
  };
  // Twice, so that a closed run is even over its start as well.
  for (int pass = 0; pass < 2; ++pass) {
    for (std::size_t m = 0; m < lengths.size(); ++m) follow(m, (m + 1) % count, lengths[m]);
    for (std::size_t m = lengths.size(); m-- > 0;) follow((m + 1) % count, m, lengths[m]);
  }
}

Toolpath KeptLean::toolpath() {
  Toolpath toolpath = wanted_;
  for (Run& run : runs_) {
    if (run.kept.empty()) continue;
    even(run);
    Path& path = toolpath.layers[run.layer].paths[run.path];
    std::vector<Eigen::Quaterniond> each;
    each.reserve(run.kept.size());
    for (std::size_t i = 0; i < run.kept.size(); ++i)
      each.push_back(raisedFrame(path.orientation.at(i), run.kept[i], limits_.up));
    path.orientation = AlongPath<Eigen::Quaterniond>(std::move(each));
  }
  is_changed_ = false;
  return withTravelsOriented(std::move(toolpath));
}

double KeptLean::least() const {
  double least = 1.0;
  for (const Run& run : runs_)
    for (const double kept : run.kept) least = std::min(least, kept);
  return least;
}

std::size_t KeptLean::raised() const {
  std::size_t count = 0;
  for (const Run& run : runs_)
    count += static_cast<std::size_t>(
        std::count_if(run.kept.begin(), run.kept.end(), [](double kept) { return kept < 1.0; }));
  return count;
}

}  // namespace lamina
