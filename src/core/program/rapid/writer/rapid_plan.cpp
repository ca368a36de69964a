// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/rapid/writer/rapid_plan.hpp"

#include <cmath>
#include <optional>
#include <string>

#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/toolpath/process_support.hpp"

namespace lamina {
namespace {

constexpr double kFarthest = 1e5;     // mm: beyond any robot
constexpr double kSamePose = 1e-6;    // mm and rad: under what targets resolve
constexpr double kUnitLength = 1e-6;  // of a quaternion

/// Refuses what no program can express, naming the place.
class PathChecks {
 public:
  PathChecks(const RapidPath& at, RapidVariant variant) : at_(at), path_(*at.path), variant_(variant) {}

  void requireWritable() const {
    if (path_.deposit == Deposit::Drops) refuse(0, "drops are laid; a robot's program lays beads only");
    if (path_.points.size() < 2) refuse(path_.points.size(), "a path needs at least 2 waypoints");
    for (std::size_t i = 0; i < path_.points.size(); ++i)
      if (path_.points[i].hasNaN() || path_.points[i].cwiseAbs().maxCoeff() >= kFarthest)
        refuse(i, "the position is not a number within 100 m");
    requireWritableFeeds(at_);
    for (std::size_t i = 0; i < path_.orientation.values().size(); ++i)
      if (!(std::abs(path_.orientation.at(i).norm() - 1.0) <= kUnitLength))
        refuse(i, "the orientation is no quaternion of unit length");
    if (at_.deposits()) requireBeads();
  }

  void requireToolAxis(const Point3& tool_axis) const {
    for (std::size_t i = 0; i < path_.orientation.values().size(); ++i) {
      const Point3 wanted = path_.orientation.at(i) * Point3::UnitZ();
      const double turn = std::atan2(tool_axis.cross(wanted).norm(), tool_axis.dot(wanted));
      if (!(turn <= kSamePose))
        refuse(i, "the nozzle would have to turn by " + std::to_string(toDegrees(turn)) +
                      " deg; a program of rapid.variant " + toString(variant_) +
                      " holds it as at the first waypoint");
    }
  }

 private:
  void requireBeads() const {
    for (std::size_t i = 0; i < path_.bead.values().size(); ++i) {
      const Bead& bead = path_.bead.at(i);
      if (!(bead.width_mm >= 0.0 && bead.height_mm >= 0.0 && std::isfinite(crossSection(bead))))
        refuse(i, "bead width and height must be finite and not negative");
    }
  }

  [[noreturn]] void refuse(std::size_t waypoint, const std::string& what) const {
    refuseWaypoint(at_, waypoint, what);
  }

  const RapidPath& at_;
  const Path& path_;
  RapidVariant variant_;
};

std::vector<RapidPath> pathsOf(const Toolpath& toolpath) {
  std::vector<RapidPath> paths;
  for (const ListedPath& listed : listedPaths(toolpath)) {
    RapidPath path;
    static_cast<ListedPath&>(path) = listed;
    paths.push_back(path);
  }
  return paths;
}

const Eigen::Quaterniond& lastOrientation(const Path& path) {
  return path.orientation.at(path.is_closed ? 0 : path.points.size() - 1);
}

void addSwitches(std::vector<RapidPath>& paths, RapidVariant variant) {
  const bool turns = variant == RapidVariant::Powder5Axes;
  paths.front().is_turned = true;
  for (std::size_t p = 0; p < paths.size(); ++p) {
    RapidPath& path = paths[p];
    const RapidPath* before = p > 0 ? &paths[p - 1] : nullptr;
    if (before != nullptr && turns)
      path.is_turned =
          lastOrientation(*before->path).angularDistance(path.path->orientation.at(0)) > kSamePose;
    const bool goes_on = before != nullptr && before->deposits() && path.deposits() && !path.is_turned;
    path.switches_on = path.deposits() && !goes_on;
    if (before != nullptr) paths[p - 1].switches_off = before->deposits() && !goes_on;
  }
  paths.back().switches_off = paths.back().deposits();
}

/// Paths that a split should not come between: travels up to a run, and the run.
struct Stretch {
  std::size_t begin = 0;  ///< path
  std::size_t end = 0;
  std::size_t points = 0;
};

std::vector<Stretch> stretchesOf(const std::vector<RapidPath>& paths) {
  std::vector<Stretch> stretches;
  for (std::size_t p = 0; p < paths.size(); ++p) {
    if (p == 0 || paths[p - 1].switches_off) stretches.push_back({p, p, 0});
    stretches.back().end = p + 1;
    stretches.back().points += paths[p].moveCount();
  }
  return stretches;
}

class Splitter {
 public:
  Splitter(const std::vector<RapidPath>& paths, const RapidSettings& settings)
      : paths_(paths), most_(static_cast<std::size_t>(settings.max_points)), loading_(settings.loading) {}

  std::vector<RapidChunk> split() {
    for (const Stretch& stretch : stretchesOf(paths_)) {
      if (open_.points > 0 && most_ > 0 && open_.points + stretch.points > most_) close();
      if (most_ > 0 && stretch.points > most_)
        cutUp(stretch);
      else
        open_.points += stretch.points, open_.end = {stretch.end, 0};
    }
    if (open_.points > 0) close();
    return std::move(chunks_);
  }

 private:
  void close() {
    chunks_.push_back(open_);
    open_ = {open_.end, open_.end, 0};
  }

  /// A stretch that fits no module: between two moves, wherever the module is full.
  void cutUp(const Stretch& stretch) {
    const RapidPath& first = paths_[stretch.begin];
    if (loading_ == RapidLoading::InTurn)
      throw InvalidConfig("rapid.max_points is " + std::to_string(most_) + ", but the run from layer " +
                          std::to_string(first.layer) + ", path " + std::to_string(first.index) + " has " +
                          std::to_string(stretch.points) +
                          " points; modules that are loaded in turn must hold whole runs");
    for (std::size_t p = stretch.begin; p < stretch.end; ++p) {
      for (std::size_t left = paths_[p].moveCount(); left > 0;) {
        const std::size_t taken = std::min(left, most_ - open_.points);
        left -= taken;
        open_.points += taken;
        open_.end = left > 0 ? RapidPlace{p, paths_[p].moveCount() - left} : RapidPlace{p + 1, 0};
        if (open_.points == most_) close();
      }
    }
  }

  const std::vector<RapidPath>& paths_;
  std::size_t most_;
  RapidLoading loading_;
  RapidChunk open_;
  std::vector<RapidChunk> chunks_;
};

}  // namespace

RapidPlan planRapid(const Toolpath& toolpath, const RapidSettings& settings) {
  requireSupported(toolpath, {}, "RAPID");
  RapidPlan plan;
  plan.paths = pathsOf(toolpath);
  for (const RapidPath& path : plan.paths) PathChecks(path, settings.variant).requireWritable();
  const Point3 tool_axis = plan.paths.front().path->orientation.at(0) * Point3::UnitZ();
  if (settings.variant != RapidVariant::Powder5Axes)
    for (const RapidPath& path : plan.paths) PathChecks(path, settings.variant).requireToolAxis(tool_axis);
  addSwitches(plan.paths, settings.variant);
  plan.chunks = Splitter(plan.paths, settings).split();
  return plan;
}

}  // namespace lamina
