// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/deposition/toolpath_deposit.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "lamina/base/available_memory.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/deposition/strand.hpp"
#include "lamina/deposition/voxel_deposit.hpp"
#include "toolpath/deposited_segment.hpp"

namespace lamina {
namespace {

/// Counts the bricks of a voxel grid that motions come near to, before there is a grid.
class BrickWalk {
 public:
  explicit BrickWalk(const VoxelFrame& frame);

  void follow(const ToolAxisMotion& motion);
  /// Memory of a grid with those bricks [bytes]; of one with all bricks where there are too many to mark.
  double bytes() const;

 private:
  void mark(const Point3& middle, double around_mm);

  VoxelFrame frame_;
  std::array<std::int64_t, 3> bricks_{};
  std::vector<bool> is_met_;  ///< by brick; empty if there are too many
  std::int64_t met_ = 0;
};

constexpr std::array<int, 3> kVoxels{VoxelGrid::kWord, VoxelGrid::kBrick, VoxelGrid::kBrick};
constexpr double kMostBricks = 4e9;
constexpr double kTableEntry = 4.0;  // bytes
constexpr double kBrickBytes =
    8.0 * VoxelGrid::kBrick * VoxelGrid::kBrick + 32.0;  // and of its place in store
constexpr double kStride = 4.0;                          // voxels along a motion
constexpr double kAround = 1.3;                          // radii of the strand
constexpr double kStrideOfStrand = 0.5;                  // radii of the strand

BrickWalk::BrickWalk(const VoxelFrame& frame) : frame_(frame) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    bricks_[axis] = (std::int64_t{frame.count[axis]} + kVoxels[axis] - 1) / kVoxels[axis];
  const double bricks = double(bricks_[0]) * double(bricks_[1]) * double(bricks_[2]);
  if (bricks <= kMostBricks) is_met_.resize(static_cast<std::size_t>(bricks));
}

void BrickWalk::follow(const ToolAxisMotion& motion) {
  if (is_met_.empty()) return;
  const double length = (motion.end - motion.start).norm();
  const double stride_mm = std::max(kStride * frame_.voxel_mm, kStrideOfStrand * motion.radius_mm);
  const double strides = std::ceil(length / stride_mm);
  const double around = kAround * motion.radius_mm + frame_.voxel_mm;
  for (double stride = 0.0; stride <= strides; ++stride) {
    const double fraction = strides > 0.0 ? stride / strides : 0.0;
    const Eigen::Vector3d tool_axis =
        (1.0 - fraction) * motion.start_tool_axis + fraction * motion.end_tool_axis;
    mark(motion.start + fraction * (motion.end - motion.start) + motion.radius_mm * tool_axis, around);
  }
}

double BrickWalk::bytes() const {
  const double bricks = double(bricks_[0]) * double(bricks_[1]) * double(bricks_[2]);
  const double met = is_met_.empty() ? bricks : static_cast<double>(met_);
  return kTableEntry * bricks + kBrickBytes * met;
}

void BrickWalk::mark(const Point3& middle, double around_mm) {
  std::array<std::int64_t, 3> low{};
  std::array<std::int64_t, 3> high{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<Eigen::Index>(axis);
    const double brick_mm = kVoxels[axis] * frame_.voxel_mm;
    const double at = middle[a] - frame_.corner[a];
    const auto last = static_cast<double>(bricks_[axis] - 1);
    low[axis] = static_cast<std::int64_t>(std::clamp(std::floor((at - around_mm) / brick_mm), 0.0, last));
    high[axis] = static_cast<std::int64_t>(std::clamp(std::floor((at + around_mm) / brick_mm), 0.0, last));
  }
  for (std::int64_t k = low[2]; k <= high[2]; ++k)
    for (std::int64_t j = low[1]; j <= high[1]; ++j)
      for (std::int64_t i = low[0]; i <= high[0]; ++i) {
        auto is_met = is_met_[static_cast<std::size_t>((k * bricks_[1] + j) * bricks_[0] + i)];
        if (is_met) continue;
        is_met = true;
        ++met_;
      }
}

constexpr double kMargin = 5.0;  // radii of the strand
constexpr double kMegabyte = 1e6;
constexpr double kCoarser = 1.03;  // from one trial of a voxel size to the next
constexpr double kDigit = 1e-3;    // of a voxel size that is reported
constexpr std::size_t kPathsPerReport = 64;

void forEachPath(const Toolpath& toolpath, const DepositionSettings& settings,
                 const std::function<void(const Path&)>& visit) {
  for (const ToolpathLayer& layer : toolpath.layers)
    for (const Path& path : layer.paths)
      if (isDeposited(path, settings)) visit(path);
}

Eigen::Vector3d toolAxisOf(const Path& path, std::size_t waypoint) {
  return (path.orientation.at(waypoint) * Eigen::Vector3d::UnitZ()).normalized();
}

/// What the voxels may take [bytes].
double memoryLimit(const DepositionSettings& settings) {
  return settings.memory_limit_mb > 0.0 ? settings.memory_limit_mb * kMegabyte : availableMemory();
}

/// The smallest of a series of voxel sizes whose voxels fit into `limit` bytes, in microns rounded up.
double voxelThatFits(const Toolpath& toolpath, DepositionSettings settings, double bytes, double limit) {
  double voxel_mm = settings.voxel_mm * std::max(1.0, 0.9 * std::cbrt(bytes / limit));
  const double longest = depositBox(toolpath, settings).size().maxCoeff();
  for (; voxel_mm < longest; voxel_mm *= kCoarser) {
    settings.voxel_mm = std::ceil(voxel_mm / kDigit) * kDigit;
    if (depositBytes(toolpath, settings) <= limit) break;
  }
  return settings.voxel_mm;
}

void requireMemory(const Toolpath& toolpath, const DepositionSettings& settings) {
  const double limit = memoryLimit(settings);
  const double bytes = depositBytes(toolpath, settings);
  if (bytes <= limit) return;
  const double fits = voxelThatFits(toolpath, settings, bytes, limit);
  throw InvalidInput("deposition.voxel_mm is " + numberText(settings.voxel_mm) + " mm, which needs " +
                     numberText(bytes / kMegabyte) + " MB; " +
                     (settings.memory_limit_mb > 0.0 ? "deposition.memory_limit_mb allows " : "free are ") +
                     numberText(limit / kMegabyte) + " MB, into which voxels of " + numberText(fits) +
                     " mm fit");
}

}  // namespace

bool isDeposited(const Path& path, const DepositionSettings& settings) {
  if (path.role == PathRole::Travel) return false;
  return kindOf(path.role) != RoleKind::BuildAid || settings.are_build_aids_deposited;
}

ToolAxisMotion toolAxisMotion(const Path& path, std::size_t motion) {
  const std::size_t end = path.motionEnd(motion);
  const double area = crossSection(path.bead.at(end));
  const double volume = area * (path.points[end] - path.points[motion]).norm();
  return {path.points[motion],   path.points[end], toolAxisOf(path, motion),
          toolAxisOf(path, end), volume,           strandRadius(area)};
}

ToolAxisMotion toolAxisDrop(const Path& path, std::size_t waypoint) {
  const Bead& bead = path.bead.at(waypoint);
  const double volume = 0.25 * M_PI * bead.width_mm * bead.width_mm * bead.height_mm;
  const Eigen::Vector3d tool_axis = toolAxisOf(path, waypoint);
  return {path.points[waypoint], path.points[waypoint], tool_axis, tool_axis, volume, ballRadius(volume)};
}

std::vector<ToolAxisMotion> toolAxisMotions(const Path& path) {
  std::vector<ToolAxisMotion> motions;
  motions.reserve(path.points.size());
  forEachDepositedSegment(path, [&](const DepositedSegment& segment) {
    const ToolAxisMotion motion = path.deposit == Deposit::Drops ? toolAxisDrop(path, segment.waypoint)
                                                                 : toolAxisMotion(path, segment.from);
    if (motion.volume_mm3 > 0.0) motions.push_back(motion);
  });
  return motions;
}

Box3 depositBox(const Toolpath& toolpath, const DepositionSettings& settings) {
  Box3 box;
  double thickest = 0.0;
  forEachPath(toolpath, settings, [&](const Path& path) {
    for (const ToolAxisMotion& motion : toolAxisMotions(path)) {
      box.include(motion.start);
      box.include(motion.end);
      thickest = std::max(thickest, motion.radius_mm);
    }
  });
  if (box.isEmpty()) return box;
  const double margin = std::min(kMargin * thickest, settings.reach_mm) + settings.voxel_mm;
  box.low -= Point3::Constant(margin);
  box.high += Point3::Constant(margin);
  box.low.z() = std::max(box.low.z(), std::min(settings.bed_z_mm, box.high.z() - settings.voxel_mm));
  return box;
}

double depositBytes(const Toolpath& toolpath, const DepositionSettings& settings) {
  const Box3 box = depositBox(toolpath, settings);
  if (box.isEmpty()) return 0.0;
  BrickWalk walk(voxelFrame(box, settings.voxel_mm));
  forEachPath(toolpath, settings, [&](const Path& path) {
    for (const ToolAxisMotion& motion : toolAxisMotions(path)) walk.follow(motion);
  });
  return walk.bytes();
}

VoxelDeposit roomFor(const Toolpath& toolpath, const DepositionSettings& settings) {
  const Box3 box = depositBox(toolpath, settings);
  if (box.isEmpty()) throw InvalidInput("toolpath '" + toolpath.part_name + "' deposits nothing");
  requireMemory(toolpath, settings);
  return {voxelFrame(box, settings.voxel_mm), settings};
}

ToolpathDeposit depositedVoxels(const Toolpath& toolpath, const DepositionSettings& settings,
                                Progress& progress) {
  static const std::string kStage = "deposit";
  VoxelDeposit deposit = roomFor(toolpath, settings);
  std::size_t paths = 0;
  forEachPath(toolpath, settings, [&](const Path&) { ++paths; });
  std::size_t done = 0;
  forEachPath(toolpath, settings, [&](const Path& path) {
    if (done % kPathsPerReport == 0)
      progress.report(kStage, static_cast<double>(done) / static_cast<double>(paths));
    throwIfCancelled(progress, kStage);
    for (const ToolAxisMotion& motion : toolAxisMotions(path)) deposit.lay(motion);
    ++done;
  });
  progress.report(kStage, 1.0);
  const DepositTotals totals = deposit.totals();
  const double highest_mm = deposit.highest();
  return {deposit.takeGrid(), totals, highest_mm};
}

}  // namespace lamina
