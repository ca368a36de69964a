// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/program/corrected_toolpath.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "control/program/corrected_pieces.hpp"
#include "geometry/space_vectors.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/control/program/correction_files.hpp"

namespace lamina {
namespace {

constexpr double kJoinMm = 1e-6;  // that consecutive paths may be apart (`validate`)

std::string pathName(std::size_t layer, std::size_t path) {
  return "layer " + std::to_string(layer) + ", path " + std::to_string(path);
}

/// The waypoints of a path, one by one.
struct WaypointValues {
  std::vector<Point3> points;
  std::vector<Eigen::Quaterniond> orientations;
  std::vector<Bead> beads;
  std::vector<double> feeds_mm_s;
  std::vector<std::vector<double>> process;  ///< by value of the path

  /// @param like  waypoint of the path whose bead and process values hold on the way
  void add(const Point3& point, const Eigen::Quaterniond& orientation, double feed_mm_s, const Path& path,
           std::size_t like) {
    points.push_back(point);
    orientations.push_back(orientation);
    beads.push_back(path.bead.at(like));
    feeds_mm_s.push_back(feed_mm_s);
    process.resize(path.values.size());
    for (std::size_t v = 0; v < path.values.size(); ++v) process[v].push_back(path.values[v].value.at(like));
  }
};

Point3 movedBack(const Point3& point, const Eigen::Quaterniond& orientation, double height_mm) {
  return point - height_mm * (orientation * Eigen::Vector3d::UnitZ());
}

void addMotion(WaypointValues& waypoints, const Path& path, std::size_t motion,
               const std::vector<CorrectedPiece>& pieces) {
  const std::size_t end = path.motionEnd(motion);
  const Point3 way = path.points[end] - path.points[motion];
  double done = 0.0;
  for (const CorrectedPiece& piece : pieces) {
    done = &piece == &pieces.back() ? 1.0 : std::min(1.0, done + piece.share);
    const Eigen::Quaterniond orientation = path.orientation.at(motion).slerp(done, path.orientation.at(end));
    const double feed = path.feed_mm_s.at(end) / (1.0 + piece.mean.amount);
    waypoints.add(movedBack(path.points[motion] + done * way, orientation, piece.end_dz_mm), orientation,
                  feed, path, end);
  }
}

Path correctedPath(const Path& path, const PathCorrection& correction, double split_change) {
  WaypointValues waypoints;
  waypoints.add(movedBack(path.points[0], path.orientation.at(0), correctionAt(correction, 0.0).dz_mm),
                path.orientation.at(0), path.feed_mm_s.at(0), path, 0);
  double along = 0.0;
  for (std::size_t m = 0; m < path.motionCount(); ++m) {
    const double length = (path.points[path.motionEnd(m)] - path.points[m]).norm();
    const DepositedStretch stretch{0, correction.path, along, along + length};
    addMotion(waypoints, path, m, correctedPieces(correction, stretch, split_change));
    along += length;
  }
  Path corrected = path;
  corrected.is_closed = false;
  corrected.points = std::move(waypoints.points);
  corrected.orientation = AlongPath<Eigen::Quaterniond>(std::move(waypoints.orientations));
  corrected.bead = AlongPath<Bead>(std::move(waypoints.beads));
  corrected.feed_mm_s = AlongPath<double>(std::move(waypoints.feeds_mm_s));
  for (std::size_t v = 0; v < path.values.size(); ++v)
    corrected.values[v].value = AlongPath<double>(std::move(waypoints.process[v]));
  for (PathEvent& placed : corrected.events)
    if (placed.motion > 0) placed.motion = corrected.motionCount();
  return corrected;
}

void requireCorrectable(const Path& path, const std::string& name) {
  if (path.deposit == Deposit::Drops) throw InvalidInput(name + " has drops; expected a bead, to correct it");
  for (const PathEvent& placed : path.events)
    if (placed.motion > 0 && placed.motion < path.motionCount())
      throw InvalidInput(name + " has an event before motion " + std::to_string(placed.motion) + " of " +
                         std::to_string(path.motionCount()) +
                         "; expected events before its first or behind its last, to correct it");
}

/// Travels end where the paths beside them begin and end now.
void joinPaths(Toolpath& toolpath) {
  const Path* before = nullptr;
  for (std::size_t k = 0; k < toolpath.layers.size(); ++k) {
    std::vector<Path>& paths = toolpath.layers[k].paths;
    for (std::size_t p = 0; p < paths.size(); ++p) {
      Path& path = paths[p];
      if (path.role == PathRole::Travel) {
        if (before != nullptr) path.points.front() = before->lastPoint();
        if (p + 1 < paths.size() && !path.is_closed) path.points.back() = paths[p + 1].firstPoint();
      } else if (p > 0 && (before->lastPoint() - path.firstPoint()).norm() > kJoinMm) {
        throw InvalidInput(
            pathName(k, p) + " begins " + numberText((before->lastPoint() - path.firstPoint()).norm()) +
            " mm from where the path before it ends once heights are corrected; expected a travel between");
      }
      before = &path;
    }
  }
}

void requireMaps(const std::vector<CorrectionMap>& maps, const Toolpath& toolpath) {
  const ProgrammedToolpath planned{toolpathId(toolpath), toolpath};
  for (const CorrectionMap& map : maps) {
    const std::string defect = defectOf(map, planned);
    if (!defect.empty()) throw InvalidInput("the correction map " + defect);
  }
}

/// Programs whose joints are led have waypoints of their own between those that were planned.
void requireSamePath(const Path& read, const Path& planned, const std::string& name, double tolerance_mm) {
  if (read.role != planned.role || read.is_closed != planned.is_closed ||
      read.points.size() < planned.points.size())
    throw InvalidInput(name + " is of role " + toString(read.role) + " with " +
                       std::to_string(read.points.size()) + " waypoints; the maps are of a toolpath with " +
                       toString(planned.role) + " and " + std::to_string(planned.points.size()) + " there");
  std::size_t next = 0;
  for (std::size_t i = 0; i < read.points.size(); ++i) {
    const bool has_more = next < planned.points.size();
    const Point3& to = has_more ? planned.points[next] : planned.lastPoint();
    double off_mm = (read.points[i] - to).norm();
    if (has_more && off_mm <= tolerance_mm) {
      ++next;
      continue;
    }
    if (next > 0 && read.points.size() > planned.points.size())
      off_mm = distanceToSegment(read.points[i], planned.points[next - 1], to);
    if (!(off_mm <= tolerance_mm))
      throw InvalidInput(name + ", waypoint " + std::to_string(i) + " is " + numberText(off_mm) +
                         " mm off that of the toolpath that the maps are of; expected at most " +
                         numberText(tolerance_mm) + " mm");
  }
  if (next < planned.points.size())
    throw InvalidInput(name + " does not come to waypoint " + std::to_string(next) +
                       " of the toolpath that the maps are of; expected all " +
                       std::to_string(planned.points.size()) + " of its waypoints");
}

}  // namespace

Toolpath correctedToolpath(const Toolpath& toolpath, const std::vector<CorrectionMap>& maps,
                           double split_change) {
  if (!(split_change > 0.0))
    throw InvalidInput("motions are split where the amount changes by " + numberText(split_change) +
                       "; expected a positive change");
  requireMaps(maps, toolpath);
  CorrectionsByPath corrections;
  for (const CorrectionMap& map : maps) corrections.add(map);
  Toolpath corrected = toolpath;
  bool is_changed = false;
  for (const CorrectionMap& map : maps)
    for (const PathCorrection& of_path : map.paths) {
      Path& path = corrected.layers[map.layer].paths[of_path.path];
      if (path.role == PathRole::Travel || isNone(of_path)) continue;
      requireCorrectable(path, pathName(map.layer, of_path.path));
      path = correctedPath(path, of_path, split_change);
      is_changed = true;
    }
  if (is_changed) joinPaths(corrected);
  return corrected;
}

void requireSamePaths(const Toolpath& read, const Toolpath& planned, double tolerance_mm) {
  if (read.layers.size() != planned.layers.size())
    throw InvalidInput("the program has " + std::to_string(read.layers.size()) +
                       " layers; the toolpath that the maps are of has " +
                       std::to_string(planned.layers.size()));
  for (std::size_t k = 0; k < read.layers.size(); ++k) {
    const std::vector<Path>& paths = read.layers[k].paths;
    if (paths.size() != planned.layers[k].paths.size())
      throw InvalidInput("layer " + std::to_string(k) + " of the program has " +
                         std::to_string(paths.size()) + " paths; the toolpath that the maps are of has " +
                         std::to_string(planned.layers[k].paths.size()));
    for (std::size_t p = 0; p < paths.size(); ++p)
      requireSamePath(paths[p], planned.layers[k].paths[p], pathName(k, p), tolerance_mm);
  }
}

}  // namespace lamina
