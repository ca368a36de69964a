// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/deposition/voxel_deposit.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "column_tops.hpp"
#include "lamina/base/error.hpp"
#include "lamina/deposition/strand.hpp"
#include "nearest_room.hpp"

namespace lamina {
namespace {

constexpr double kFarthest = 1e6;       // mm
constexpr double kUnit = 1e-6;          // of the length of a tool axis
constexpr double kMostReach = 1 << 17;  // voxels: squares of distances stay exact
constexpr double kFinestStep = 0.25;    // voxels, for strands much thinner than one
constexpr double kWhole = 1e-9;         // voxels: rounding of sums of portions
constexpr double kSteepest = 0.1;       // z of a tool axis that irons a surface seen from above
constexpr double kIroned = 0.5 + 1e-6;  // voxels from a face to the plane that made it
constexpr double kRoundedPortions = 1e-9;

void requireUsable(const ToolAxisMotion& motion) {
  for (const Point3& tip : {motion.start, motion.end})
    if (!tip.allFinite() || tip.cwiseAbs().maxCoeff() > kFarthest)
      throw InvalidInput("motion of the nozzle from (" + std::to_string(motion.start.x()) + ", " +
                         std::to_string(motion.start.y()) + ", " + std::to_string(motion.start.z()) +
                         ") to (" + std::to_string(motion.end.x()) + ", " + std::to_string(motion.end.y()) +
                         ", " + std::to_string(motion.end.z()) + ") mm; expected to stay within 1 km");
  for (const Eigen::Vector3d& tool_axis : {motion.start_tool_axis, motion.end_tool_axis})
    if (!(std::abs(tool_axis.norm() - 1.0) <= kUnit))
      throw InvalidInput("tool axis of the nozzle is " + std::to_string(tool_axis.norm()) +
                         " long; expected 1");
  if (!(motion.volume_mm3 >= 0.0 && std::isfinite(motion.volume_mm3)))
    throw InvalidInput("volume of a motion is " + std::to_string(motion.volume_mm3) +
                       " mm3; expected 0 or more");
  if (!(motion.radius_mm >= 0.0 && motion.radius_mm <= VoxelDeposit::kThickestStrand))
    throw InvalidInput("radius of a strand is " + std::to_string(motion.radius_mm) + " mm; expected 0 to " +
                       std::to_string(VoxelDeposit::kThickestStrand) + " mm");
}

double radiusOf(const ToolAxisMotion& motion, double length_mm) {
  if (motion.radius_mm > 0.0) return motion.radius_mm;
  const double radius =
      length_mm > 0.0 ? strandRadius(motion.volume_mm3 / length_mm) : ballRadius(motion.volume_mm3);
  return std::min(radius, VoxelDeposit::kThickestStrand);
}

Eigen::Vector3d toolAxisAt(const ToolAxisMotion& motion, double fraction) {
  if (motion.start_tool_axis == motion.end_tool_axis) return motion.start_tool_axis;
  const Eigen::Vector3d between = (1.0 - fraction) * motion.start_tool_axis + fraction * motion.end_tool_axis;
  const double norm = between.norm();
  return norm > kUnit ? Eigen::Vector3d(between / norm) : motion.start_tool_axis;
}

/// First layer of voxels whose centres are not below the bed.
int lowestLayer(const VoxelFrame& frame, double bed_z_mm) {
  const double k = std::ceil((bed_z_mm - frame.corner.z()) / frame.voxel_mm - 0.5 - kUnit);
  return static_cast<int>(std::clamp(k, 0.0, static_cast<double>(frame.count[2])));
}

double reachInVoxels(const DepositionSettings& settings, double voxel_mm) {
  const double reach = settings.reach_mm / voxel_mm;
  if (!(reach > 0.0 && reach <= kMostReach))
    throw InvalidInput("deposition.reach_mm is " + std::to_string(settings.reach_mm) +
                       " mm; expected up to " + std::to_string(kMostReach * voxel_mm) + " mm for voxels of " +
                       std::to_string(voxel_mm) + " mm");
  return reach;
}

/// Height of the top of a voxel that was deposited at `outlet` [voxels above the corner].
double topOf(const OpenVoxel& voxel, const Outlet& outlet) {
  const double face = voxel.k + 1.0;
  if (outlet.tool_axis.z() > -kSteepest) return face;
  const double plane = outlet.tip.z() - (outlet.tool_axis.x() * (voxel.i + 0.5 - outlet.tip.x()) +
                                         outlet.tool_axis.y() * (voxel.j + 0.5 - outlet.tip.y())) /
                                            outlet.tool_axis.z();
  return std::abs(plane - face) <= kIroned ? plane : face;
}

}  // namespace

class VoxelDeposit::State {
 public:
  State(const VoxelFrame& frame, const DepositionSettings& settings, TopHeights tops)
      : grid_(frame),
        step_(settings.step),
        bed_z_mm_(settings.bed_z_mm),
        room_(lowestLayer(frame, settings.bed_z_mm), reachInVoxels(settings, frame.voxel_mm)) {
    if (tops == TopHeights::Kept) tops_.emplace(frame, settings.bed_z_mm);
  }

  void lay(const ToolAxisMotion& motion) {
    requireUsable(motion);
    if (motion.volume_mm3 == 0.0) return;
    const Point3 way = motion.end - motion.start;
    const double length = way.norm();
    const double radius = radiusOf(motion, length);
    const double step = std::max(step_ * radius, kFinestStep * frame().voxel_mm);
    const double portions = std::max(1.0, std::ceil(length / step - kRoundedPortions));
    path_mm_ += length;
    extruded_mm3_ += motion.volume_mm3;
    for (double portion = 0.5; portion < portions; ++portion) {
      owed_ += motion.volume_mm3 / portions / frame().voxelVolume();
      if (owed_ + kWhole < 1.0) continue;
      const double fraction = portion / portions;
      layPortion(motion.start + fraction * way, toolAxisAt(motion, fraction), radius);
    }
  }

  DepositTotals totals() const {
    const double voxel_mm3 = frame().voxelVolume();
    return {path_mm_,
            extruded_mm3_,
            static_cast<double>(deposited_) * voxel_mm3,
            static_cast<double>(excess_) * voxel_mm3,
            static_cast<double>(outside_) * voxel_mm3,
            owed_ * voxel_mm3};
  }

  double highest() const { return deposited_ == 0 ? bed_z_mm_ : zOf(highest_); }
  double surfaceHeight(double x, double y) const { return tops_ ? tops_->at(x, y) : bed_z_mm_; }
  const VoxelGrid& grid() const { return grid_; }
  VoxelGrid takeGrid() { return std::move(grid_); }

 private:
  const VoxelFrame& frame() const { return grid_.frame(); }
  double zOf(double voxels) const { return frame().corner.z() + frame().voxel_mm * voxels; }
  Point3 inVoxels(const Point3& point) const { return (point - frame().corner) / frame().voxel_mm; }

  /// Lays the whole voxels that are owed.
  void layPortion(const Point3& tip, const Eigen::Vector3d& tool_axis, double radius) {
    const auto count = static_cast<std::int64_t>(std::floor(owed_ + kWhole));
    owed_ = std::max(0.0, owed_ - static_cast<double>(count));
    const Outlet outlet{inVoxels(tip), tool_axis, inVoxels(tip + radius * tool_axis)};
    if (isBeyondFrame(outlet.middle)) {
      outside_ += count;
      return;
    }
    const std::vector<OpenVoxel>& room = room_.find(grid_, outlet, count);
    for (const OpenVoxel& voxel : room) {
      grid_.fill(voxel.i, voxel.j, voxel.k);
      if (tops_) tops_->raise(voxel.i, voxel.j, zOf(topOf(voxel, outlet)));
      if (voxel.k + 1.0 + kIroned > highest_) highest_ = std::max(highest_, topOf(voxel, outlet));
    }
    deposited_ += static_cast<std::int64_t>(room.size());
    excess_ += count - static_cast<std::int64_t>(room.size());
  }

  /// Seen along z: material may come out above the frame or, at the bed, below it.
  bool isBeyondFrame(const Point3& middle) const {
    return !(middle.x() >= 0.0 && middle.y() >= 0.0 && middle.x() <= frame().count[0] &&
             middle.y() <= frame().count[1]);
  }

  VoxelGrid grid_;
  double step_;
  double bed_z_mm_;
  NearestRoom room_;
  std::optional<ColumnTops> tops_;
  double path_mm_ = 0.0;
  double extruded_mm3_ = 0.0;
  double owed_ = 0.0;  ///< voxels extruded and not deposited yet
  std::int64_t deposited_ = 0;
  std::int64_t excess_ = 0;
  std::int64_t outside_ = 0;
  double highest_ = 0.0;  ///< [voxels above the corner]
};

VoxelDeposit::VoxelDeposit(const VoxelFrame& frame, const DepositionSettings& settings, TopHeights tops)
    : state_(std::make_unique<State>(frame, settings, tops)) {}
VoxelDeposit::~VoxelDeposit() = default;
VoxelDeposit::VoxelDeposit(VoxelDeposit&&) noexcept = default;
VoxelDeposit& VoxelDeposit::operator=(VoxelDeposit&&) noexcept = default;

void VoxelDeposit::lay(const ToolAxisMotion& motion) { state_->lay(motion); }
const VoxelGrid& VoxelDeposit::grid() const { return state_->grid(); }
DepositTotals VoxelDeposit::totals() const { return state_->totals(); }
double VoxelDeposit::highest() const { return state_->highest(); }
double VoxelDeposit::surfaceHeight(double x, double y) const { return state_->surfaceHeight(x, y); }
VoxelGrid VoxelDeposit::takeGrid() { return state_->takeGrid(); }

}  // namespace lamina
