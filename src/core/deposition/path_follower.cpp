// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/deposition/path_follower.hpp"

#include <algorithm>

namespace lamina {
namespace {

constexpr double kDetour = 1.1;  // ways of the toolpath over those of the nozzle: a chord over its arc

/// What is left of the motion that a place is on.
struct Stretch {
  Point3 start;
  Point3 end;
  double length_mm;
};

/// Paths without motions are left out on the way.
PathPosition nextMotion(const std::vector<const Path*>& paths, const PathPosition& place) {
  PathPosition next{place.path, place.motion + 1, 0.0};
  while (next.path < paths.size() && next.motion >= paths[next.path]->motionCount())
    next = {next.path + 1, 0, 0.0};
  return next;
}

Stretch stretchFrom(const Path& path, const PathPosition& place) {
  const Point3& start = path.points[place.motion];
  const Point3& end = path.points[path.motionEnd(place.motion)];
  const Point3 from = start + place.fraction * (end - start);
  return {from, end, (end - from).norm()};
}

/// Fraction of the stretch at which it is nearest to a point.
double nearestFraction(const Stretch& stretch, const Point3& point) {
  if (stretch.length_mm <= 0.0) return 0.0;
  const Point3 way = stretch.end - stretch.start;
  return std::clamp((point - stretch.start).dot(way) / way.squaredNorm(), 0.0, 1.0);
}

}  // namespace

void describe(SettingsSchema& schema, FollowingSettings& settings) {
  schema.number("following.tolerance_mm", settings.tolerance_mm, {0.001, 100.0},
                "Distance from the toolpath up to which a reported nozzle is on it.");
  schema.number("following.look_ahead_mm", settings.look_ahead_mm, {1.0, 1e6},
                "How far along the toolpath the nozzle is looked for from one report to the next.");
}

PathFollower::PathFollower(const Toolpath& toolpath, const FollowingSettings& settings)
    : settings_(settings), look_ahead_mm_(settings.look_ahead_mm) {
  validate(toolpath);
  for (const ToolpathLayer& layer : toolpath.layers)
    for (const Path& path : layer.paths) paths_.push_back(&path);
  skipEmptyPaths();
}

void PathFollower::skipEmptyPaths() {
  while (!isAtEnd() && paths_[place_.path]->motionCount() == 0) ++place_.path;
  if (!isAtEnd()) tip_ = paths_[place_.path]->firstPoint();
}

void PathFollower::begin(std::size_t path, double look_ahead_mm) {
  place_ = {std::min(path, paths_.size()), 0, 0.0};
  guess_.reset();
  is_found_ = false;
  look_ahead_mm_ = std::max(look_ahead_mm, settings_.look_ahead_mm);
  skipEmptyPaths();
}

PathPosition PathFollower::observe(const Point3& tip) {
  if (isAtEnd() || !tip.allFinite()) return place_;
  const auto found = firstNear(place_, tip);
  if (found && isOnTheWay(*found, tip_, tip)) {
    accept(found->place, tip);
  } else if (guess_ && goesOn(tip)) {
    if (guess_->on_the_way >= kSureOnTheWay || guess_->ahead >= kSureAhead) accept(guess_->place, tip);
  } else {
    guess_.reset();
    if (found) guess_ = Guess{found->place, tip};
  }
  return place_;
}

std::optional<PathFollower::Found> PathFollower::firstNear(const PathPosition& from,
                                                           const Point3& tip) const {
  std::optional<Found> nearest;
  double least = settings_.tolerance_mm;
  double way_mm = 0.0;
  for (PathPosition at = from; at.path < paths_.size() && way_mm <= look_ahead_mm_;
       at = nextMotion(paths_, at)) {
    const Stretch stretch = stretchFrom(*paths_[at.path], at);
    // On its way to the start the nozzle may come by any travel.
    const bool counts = is_found_ || paths_[at.path]->role != PathRole::Travel;
    if (!counts && nearest) break;
    if (!counts) {
      way_mm += stretch.length_mm;
      continue;
    }
    const double part = nearestFraction(stretch, tip);
    const double distance = (stretch.start + part * (stretch.end - stretch.start) - tip).norm();
    if (nearest && (stretch.start - tip).norm() > settings_.tolerance_mm) break;
    if (distance < least || (!nearest && distance <= least)) {
      least = distance;
      nearest = Found{{at.path, at.motion, at.fraction + part * (1.0 - at.fraction)},
                      way_mm + part * stretch.length_mm};
    }
    way_mm += stretch.length_mm;
  }
  return nearest;
}

bool PathFollower::isOnTheWay(const Found& found, const Point3& from, const Point3& tip) const {
  return found.way_mm <= kDetour * (tip - from).norm() + 2.0 * settings_.tolerance_mm;
}

/// Whether the toolpath leads from the guess to the tip.
bool PathFollower::goesOn(const Point3& tip) {
  const auto found = firstNear(guess_->place, tip);
  if (!found) return false;
  if ((tip - guess_->tip).norm() < settings_.tolerance_mm) return true;  // a rest proves nothing
  guess_->on_the_way = isOnTheWay(*found, guess_->tip, tip) ? guess_->on_the_way + 1 : 1;
  ++guess_->ahead;
  guess_->place = found->place;
  guess_->tip = tip;
  return true;
}

void PathFollower::accept(const PathPosition& place, const Point3& tip) {
  is_found_ = true;
  place_ = endIfNear(place.fraction < 1.0 ? place : nextMotion(paths_, place));
  tip_ = tip;
  guess_.reset();
  look_ahead_mm_ = settings_.look_ahead_mm;
}

/// The end, if no more than the tolerance is left up to it.
PathPosition PathFollower::endIfNear(const PathPosition& place) const {
  double left_mm = 0.0;
  for (PathPosition at = place; at.path < paths_.size(); at = nextMotion(paths_, at)) {
    left_mm += stretchFrom(*paths_[at.path], at).length_mm;
    if (left_mm > settings_.tolerance_mm) return place;
  }
  return {paths_.size(), 0, 0.0};
}

}  // namespace lamina
