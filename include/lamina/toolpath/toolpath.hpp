// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "lamina/geometry/vector.hpp"
#include "lamina/toolpath/toolpath_event.hpp"

namespace lamina {

/// Purpose of a path.
enum class PathRole : std::uint8_t {
  Skirt = 0,
  OuterWall = 1,
  InnerWall = 2,
  Infill = 3,
  GapFill = 4,
  Travel = 5,
  TopSkin = 6,            ///< solid, visible from above
  Skin = 7,               ///< solid, hidden
  BottomSkin = 8,         ///< solid, visible from below
  Bridge = 9,             ///< spans a gap in the layer below
  Support = 10,           ///< holds up the part, and is removed afterwards
  SupportInterface = 11,  ///< between support and part
  Brim = 12,
  Raft = 13,
  Prime = 14,   ///< fills the nozzle, or a prime tower
  Ironing = 15  ///< passes over a top skin again
};

/// Kinds of roles, by whether and where the deposited material stays.
enum class RoleKind : std::uint8_t {
  Travel,   ///< none
  Wall,     ///< stays, along the part's surface
  Infill,   ///< stays, within walls: skins and bridges too
  BuildAid  ///< does not belong to the part: skirt, brim, raft, supports, priming
};
RoleKind kindOf(PathRole role);

inline constexpr std::size_t kPathRoles = 16;

/// The role as written in files and shown to people: "outer_wall".
const char* toString(PathRole role);
/// @throws InvalidInput if the name is unknown
PathRole pathRoleFromString(const std::string& name);

/// Cross-section of deposited material [mm]. A width of 0 deposits nothing.
struct Bead {
  double width_mm = 0.0;
  double height_mm = 0.0;

  friend bool operator==(const Bead& a, const Bead& b) {
    return a.width_mm == b.width_mm && a.height_mm == b.height_mm;
  }
};

/// How a path deposits.
enum class Deposit : std::uint8_t {
  Bead = 0,   ///< a bead from waypoint to waypoint
  Drops = 1,  ///< a drop at each waypoint, a disc as wide and high as its `Bead`; nothing between them
};

/// As written in files: "bead", "drops".
const char* toString(Deposit deposit);

/// A quantity along a path: one value for all waypoints, or one per waypoint where it varies.
template <class Value>
class AlongPath {
 public:
  AlongPath() : values_(1) {}
  AlongPath(Value common)
      : values_(1, std::move(common)) {}  // NOLINT: a single value is a quantity along a path
  /// @param each one value per waypoint of the path
  explicit AlongPath(std::vector<Value> each) : values_(std::move(each)) {}

  const Value& at(std::size_t waypoint) const { return values_.size() == 1 ? values_[0] : values_[waypoint]; }
  bool isCommon() const { return values_.size() == 1; }
  /// One value, or as many as the path has waypoints.
  const std::vector<Value>& values() const { return values_; }

 private:
  std::vector<Value> values_;
};

/// State of the process along a path besides depositing.
struct ProcessFlags {
  /// Material is retracted before the first motion of this path and extruded again after the last one.
  bool is_retracted = false;
};

/// A quantity of the process by name, such as "laser_power_w", besides bead and feed.
struct ProcessValue {
  std::string name;
  AlongPath<double> value{0.0};
};

/// One run of the nozzle. Waypoint i states a pose of the nozzle in the part frame, and bead, feed and
/// process values of the motion to it from waypoint i-1. In an open path no motion leads to waypoint 0, and
/// its bead, feed and values are not used. A closed path returns from its last waypoint to its first, which
/// is not repeated: bead, feed and values of waypoint 0 are those of that return.
struct Path {
  PathRole role = PathRole::Infill;
  bool is_closed = false;
  Deposit deposit = Deposit::Bead;
  ProcessFlags process;
  std::vector<Point3> points;  ///< nozzle tip [mm, part frame]; at least two, or one drop
  AlongPath<Eigen::Quaterniond> orientation{Eigen::Quaterniond(0, 1, 0, 0)};  ///< part_from_nozzle
  AlongPath<Bead> bead;                                                       ///< width 0 on travel
  AlongPath<double> feed_mm_s{0.0};  ///< speed of the nozzle tip [mm/s]
  std::uint32_t tool = 0;            ///< number of the tool that runs the path, from 0
  std::vector<PathEvent> events;     ///< in the order of their motions
  std::vector<ProcessValue> values;  ///< each name at most once

  /// Number of motions: points.size(), less one if open.
  std::size_t motionCount() const;
  /// Waypoint index at which motion m (0 based) ends. Motion m starts at waypoint m.
  std::size_t motionEnd(std::size_t motion) const { return motion + 1 == points.size() ? 0 : motion + 1; }
  const Point3& firstPoint() const { return points.front(); }
  /// Position of the nozzle at the end of the path: the first point if it is closed.
  const Point3& lastPoint() const { return is_closed ? points.front() : points.back(); }
};

/// Paths of one layer in the order in which they are run. Each path begins where the one before ends; where
/// nothing is deposited in between, there is a Travel path.
struct ToolpathLayer {
  double z_mm = 0.0;       ///< height of the nozzle tip [frame of the layers]: the top of the layer
  double height_mm = 0.0;  ///< thickness of the layer
  std::vector<Path> paths;
};

/// All motions of the nozzle for one part, in the part frame: made by slicers and planners, and read by
/// program writers, simulators and metrics.
struct Toolpath {
  std::string part_name;
  std::vector<ToolpathLayer> layers;
  /// Rotation of the frame of the layers about the part's origin; in that frame a layer lies at the height
  /// `z_mm`. Waypoints are nevertheless in the part frame.
  Eigen::Quaterniond part_from_layers = Eigen::Quaterniond::Identity();
  std::vector<ToolpathEvent> events_at_end = {};  ///< events after all paths
};

/// Nozzle pointing straight down: its z (the tool axis) along -z of the part, its x along x of the part.
Eigen::Quaterniond nozzleDown();

/// Length of the path including the return of a closed one [mm].
double length(const Path& path);

/// Cross-sectional area of a bead [mm²], a stadium: (w - h) h + pi h² / 4 for width w >= height h, otherwise
/// (h - w) w + pi w² / 4.
double crossSection(const Bead& bead);

/// Plan width [mm] that a bead fills: its area over its height. Beads at this pitch fill a layer exactly.
double planWidth(const Bead& bead);

/// The bead of that area [mm²] and height. An area of 0 gives a width of 0.
Bead beadOfArea(double area_mm2, double height_mm);

/// Volume of the material deposited along the path [mm³].
double depositedVolume(const Path& path);

/// Lengths and counts of a toolpath.
struct ToolpathTotals {
  std::size_t layers = 0;
  std::size_t waypoints = 0;
  std::size_t deposition_runs = 0;  ///< paths that deposit
  double deposition_mm = 0.0;
  double travel_mm = 0.0;
  double deposited_mm3 = 0.0;
};
ToolpathTotals totals(const Toolpath& toolpath);

/// Bounding box of the waypoints of all paths that deposit; the width of beads is not added.
Box3 depositionBox(const Toolpath& toolpath);

/// 16 hexadecimal digits that depend on every value of the toolpath and nothing else (FNV-1a).
std::string toolpathId(const Toolpath& toolpath);

/// The first fault of a path's events: an event out of order, at a motion that the path does not have, or
/// invalid (`defectOf`). Empty if there is none.
std::string faultOfEvents(const Path& path);

/// Checks a toolpath: finite numbers, at least two points per path (one for drops), one value per quantity or
/// one per waypoint, positive feeds, unit quaternions, distinct names of process values, joins of consecutive
/// paths within 1e-6 mm, valid events (`faultOfEvents`).
/// @throws InvalidInput naming layer and path, and the waypoint of a point that is not finite
void validate(const Toolpath& toolpath);

}  // namespace lamina
