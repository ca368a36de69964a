// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/kinematics/model/toolpath_reach.hpp"

#include <algorithm>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

#include "geometry/space_vectors.hpp"
#include "kinematics/model/link_motion.hpp"
#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/parallel.hpp"
#include "lamina/base/text.hpp"

namespace lamina {
namespace {

constexpr double kReachedToolAxis = toRadians(0.01);  // far below what a head is built to
constexpr double kReachTolerance = 1e-6;              // mm: rounding of transforms

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3f", value);
  return text;
}

/// Why the tool axis is out of reach; empty if it is not.
std::string toolAxisFault(const BuildSpace& space, const Point3& tool_axis) {
  const Point3 own = toolAxis(space);
  const double angle = angleBetween(own, tool_axis);
  if (angle <= kReachedToolAxis) return "";
  const std::string turn = "the nozzle would have to turn by " + number(toDegrees(angle)) + " deg; ";
  if (!canTurnToolAxis(space)) return turn + "the head of " + space.name + " is fixed";
  return turn + "the linear axes of " + space.name + " alone hold it as it is with joints " +
         listed(space.rotary_joints, " and ") + " at zero";
}

enum class Checked { Pose, Tip };

/// Checks the paths of one layer with what it needs once.
class ReachCheck {
 public:
  ReachCheck(const BuildSpace& space, const Eigen::Isometry3d& bed_from_part, Checked checked,
             const std::vector<Point3>& tool_offsets_mm = {})
      : space_(space),
        bed_from_part_(bed_from_part),
        offsets_(tool_offsets_mm),
        values_from_bed_(Eigen::Matrix3d(space.bed_from_axes.linear()).inverse()),
        checked_(checked) {}

  /// Whether all that lies in a box is within the limits, which bound a convex space.
  bool hasWithinLimits(const Box3& box) const {
    for (int corner = 0; corner < 8; ++corner) {
      const Point3 point((corner & 1) != 0 ? box.high.x() : box.low.x(),
                         (corner & 2) != 0 ? box.high.y() : box.low.y(),
                         (corner & 4) != 0 ? box.high.z() : box.low.z());
      if (!rangeFault(space_, valuesAt(point), kReachTolerance).empty()) return false;
    }
    return true;
  }

  /// Offset of the tip that the path is run with, in the part frame.
  Point3 offsetOf(const Path& path) const {
    if (path.tool >= offsets_.size()) return Point3::Zero();
    return bed_from_part_.linear().transpose() * offsets_[path.tool];
  }

  std::string fault(const Path& path, std::size_t waypoint) const {
    const Point3 offset = offsetOf(path);
    std::string found = rangeFault(space_, valuesAt(path.points[waypoint] - offset), kReachTolerance);
    if (!found.empty() && !offset.isZero())
      found = "with the offset of tool " + std::to_string(path.tool) + ", " + found;
    if (checked_ == Checked::Pose && found.empty() && (waypoint == 0 || !path.orientation.isCommon()))
      found =
          toolAxisFault(space_, bed_from_part_.linear() * (path.orientation.at(waypoint) * Point3::UnitZ()));
    return found;
  }

 private:
  Point3 valuesAt(const Point3& point) const {
    const Point3 position = bed_from_part_ * point;
    return values_from_bed_ * (position - space_.bed_from_axes.translation());
  }

  const BuildSpace& space_;
  const Eigen::Isometry3d& bed_from_part_;
  std::vector<Point3> offsets_;
  Eigen::Matrix3d values_from_bed_;
  Checked checked_;
};

std::string firstFault(const ToolpathLayer& layer, const ReachCheck& check) {
  Box3 box;
  Point3 sum = Point3::Zero();
  for (const Path& path : layer.paths) {
    const Point3 offset = check.offsetOf(path);
    for (const Point3& point : path.points) box.include(point - offset), sum += point;
  }
  // No box shows a point that is not a number.
  const bool is_within = sum.allFinite() && !box.isEmpty() && check.hasWithinLimits(box);
  for (std::size_t p = 0; p < layer.paths.size(); ++p) {
    const Path& path = layer.paths[p];
    for (std::size_t w = 0; w < path.points.size(); ++w) {
      if (is_within && w > 0 && path.orientation.isCommon()) break;
      const std::string fault = check.fault(path, w);
      if (!fault.empty())
        return "path " + std::to_string(p) + ", waypoint " + std::to_string(w) + ": " + fault;
    }
  }
  return "";
}

/// @throws Unreachable with the first fault
void requireNoFault(const Toolpath& toolpath, const ReachCheck& check) {
  std::vector<std::string> faults(toolpath.layers.size());
  NoProgress nobody;
  parallelFor(
      faults.size(), [&](std::size_t l) { faults[l] = firstFault(toolpath.layers[l], check); }, nobody,
      "check");
  for (std::size_t l = 0; l < faults.size(); ++l)
    if (!faults[l].empty()) throw Unreachable("layer " + std::to_string(l) + ", " + faults[l]);
}

}  // namespace

std::string rangeFault(const BuildSpace& space, const Point3& values, double tolerance_mm) {
  for (int i = 0; i < 3; ++i) {
    const double low_mm = space.range.low[i];
    const double high_mm = space.is_endless[static_cast<std::size_t>(i)] ? std::numeric_limits<double>::max()
                                                                         : space.range.high[i];
    if (values[i] >= low_mm - tolerance_mm && values[i] <= high_mm + tolerance_mm) continue;
    return std::string("axis ") + kAxisNames[i] + " would be at " + number(values[i]) + " mm; " + space.name +
           " reaches " + number(low_mm) +
           (space.is_endless[static_cast<std::size_t>(i)] ? " mm and on"
                                                          : " to " + number(space.range.high[i]) + " mm");
  }
  return "";
}

void requireReachable(const Toolpath& toolpath, const Eigen::Isometry3d& bed_from_part,
                      const BuildSpace& space, const std::vector<Point3>& tool_offsets_mm) {
  requireNoFault(toolpath, ReachCheck(space, bed_from_part, Checked::Pose, tool_offsets_mm));
}

void requireTipsReachable(const Toolpath& toolpath, const Eigen::Isometry3d& bed_from_part,
                          const BuildSpace& space) {
  requireNoFault(toolpath, ReachCheck(space, bed_from_part, Checked::Tip));
}

double greatestToolAxisTurn(const Toolpath& toolpath, const Eigen::Isometry3d& bed_from_part,
                            const BuildSpace& space) {
  const Point3 own = bed_from_part.linear().transpose() * toolAxis(space);
  double greatest = 0.0;
  for (const ToolpathLayer& layer : toolpath.layers)
    for (const Path& path : layer.paths)
      for (const Eigen::Quaterniond& orientation : path.orientation.values()) {
        const Point3 tool_axis = orientation * Point3::UnitZ();
        greatest = std::max(greatest, angleBetween(own, tool_axis));
      }
  return greatest;
}

}  // namespace lamina
