// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/toolpath/toolpath.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

constexpr std::array<const char*, kPathRoles> kRoleNames = {
    "skirt",    "outer_wall", "inner_wall",  "infill", "gap_fill", "travel",
    "top_skin", "skin",       "bottom_skin", "bridge", "support",  "support_interface",
    "brim",     "raft",       "prime",       "ironing"};

double discVolume(const Bead& drop) { return 0.25 * M_PI * drop.width_mm * drop.width_mm * drop.height_mm; }

double dropVolume(const Path& path) {
  if (path.bead.isCommon()) return static_cast<double>(path.points.size()) * discVolume(path.bead.at(0));
  double sum = 0.0;
  for (const Bead& drop : path.bead.values()) sum += discVolume(drop);
  return sum;
}

}  // namespace

const char* toString(PathRole role) { return kRoleNames.at(static_cast<std::size_t>(role)); }

const char* toString(Deposit deposit) { return deposit == Deposit::Drops ? "drops" : "bead"; }

PathRole pathRoleFromString(const std::string& name) {
  for (std::size_t i = 0; i < kRoleNames.size(); ++i)
    if (name == kRoleNames[i]) return static_cast<PathRole>(i);
  std::string known;
  for (const char* const role : kRoleNames) known += (known.empty() ? "" : ", ") + std::string(role);
  throw InvalidInput("path role is '" + name + "'; must be one of " + known);
}

RoleKind kindOf(PathRole role) {
  switch (role) {
    case PathRole::Travel:
      return RoleKind::Travel;
    case PathRole::OuterWall:
    case PathRole::InnerWall:
      return RoleKind::Wall;
    case PathRole::Skirt:
    case PathRole::Support:
    case PathRole::SupportInterface:
    case PathRole::Brim:
    case PathRole::Raft:
    case PathRole::Prime:
      return RoleKind::BuildAid;
    case PathRole::Infill:
    case PathRole::GapFill:
    case PathRole::TopSkin:
    case PathRole::Skin:
    case PathRole::BottomSkin:
    case PathRole::Bridge:
    case PathRole::Ironing:
      break;
  }
  return RoleKind::Infill;
}

std::size_t Path::motionCount() const {
  if (points.empty()) return 0;
  return is_closed ? points.size() : points.size() - 1;
}

Eigen::Quaterniond nozzleDown() { return Eigen::Quaterniond(0.0, 1.0, 0.0, 0.0); }

double length(const Path& path) {
  double sum = 0.0;
  const std::size_t count = path.motionCount();
  for (std::size_t m = 0; m < count; ++m) sum += (path.points[path.motionEnd(m)] - path.points[m]).norm();
  return sum;
}

double crossSection(const Bead& bead) {
  const double high = std::max(bead.width_mm, bead.height_mm);
  const double low = std::min(bead.width_mm, bead.height_mm);
  return (high - low) * low + 0.25 * M_PI * low * low;
}

double planWidth(const Bead& bead) {
  return bead.height_mm > 0.0 ? crossSection(bead) / bead.height_mm : bead.width_mm;
}

Bead beadOfArea(double area_mm2, double height_mm) {
  constexpr double kCorners = 1.0 - 0.25 * M_PI;
  const double h = height_mm;
  if (area_mm2 >= 0.25 * M_PI * h * h) return {area_mm2 / h + kCorners * h, h};
  // Higher than wide: h w - (1 - pi/4) w² = area.
  return {2.0 * area_mm2 / (h + std::sqrt(std::max(0.0, h * h - 4.0 * kCorners * area_mm2))), h};
}

namespace {

double depositedVolume(const Path& path, double length_mm) {
  if (path.role == PathRole::Travel) return 0.0;
  if (path.deposit == Deposit::Drops) return dropVolume(path);
  if (path.bead.isCommon()) return length_mm * crossSection(path.bead.at(0));
  double sum = 0.0;
  for (std::size_t m = 0; m < path.motionCount(); ++m) {
    const std::size_t end = path.motionEnd(m);
    sum += (path.points[end] - path.points[m]).norm() * crossSection(path.bead.at(end));
  }
  return sum;
}

}  // namespace

double depositedVolume(const Path& path) { return depositedVolume(path, length(path)); }

ToolpathTotals totals(const Toolpath& toolpath) {
  ToolpathTotals sum;
  sum.layers = toolpath.layers.size();
  for (const ToolpathLayer& layer : toolpath.layers) {
    for (const Path& path : layer.paths) {
      sum.waypoints += path.points.size();
      const bool is_travel = path.role == PathRole::Travel;
      const double length_mm = length(path);
      (is_travel ? sum.travel_mm : sum.deposition_mm) += length_mm;
      sum.deposition_runs += is_travel ? 0 : 1;
      sum.deposited_mm3 += depositedVolume(path, length_mm);
    }
  }
  return sum;
}

Box3 depositionBox(const Toolpath& toolpath) {
  Box3 box;
  for (const ToolpathLayer& layer : toolpath.layers)
    for (const Path& path : layer.paths)
      if (path.role != PathRole::Travel)
        for (const Point3& point : path.points) box.include(point);
  return box;
}

}  // namespace lamina
