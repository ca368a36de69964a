// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/volumetric/head_lean.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lamina/base/angle.hpp"
#include "lamina/base/parallel.hpp"

namespace lamina {
namespace {

constexpr double kLookedAtMm = 2.0;
constexpr double kStepRad = toRadians(5.0);
constexpr float kNowhere = -1.0F;

}  // namespace

Point3 turnedUp(const Point3& direction, double angle_rad) {
  const double across = direction.head<2>().norm();
  const double tilt = std::atan2(across, direction.z());
  if (angle_rad <= 0.0) return direction;
  if (tilt <= angle_rad || across <= 0.0) return Point3::UnitZ();
  const double turned = tilt - angle_rad;
  Point3 result;
  result << direction.head<2>() * (std::sin(turned) / across), std::cos(turned);
  return result;
}

HeadLean::HeadLean(const CellGraph& cells, const GrowthLattice& lattice, const HeadRoom& room,
                   const LeanQuestion& question, Progress& progress)
    : cells_(cells) {
  const VoxelFrame& fine = cells.frame();
  const int ratio = std::max(1, static_cast<int>(std::lround(kLookedAtMm / fine.voxel_mm)));
  frame_.corner = fine.corner;
  frame_.voxel_mm = ratio * fine.voxel_mm;
  for (std::size_t axis = 0; axis < 3; ++axis) frame_.count[axis] = (fine.count[axis] + ratio - 1) / ratio;
  look(lattice, room, question, progress);
  evenOut();
}

std::size_t HeadLean::numberOf(int i, int j, int k) const {
  return (static_cast<std::size_t>(k) * static_cast<std::size_t>(frame_.count[1]) +
          static_cast<std::size_t>(j)) *
             static_cast<std::size_t>(frame_.count[0]) +
         static_cast<std::size_t>(i);
}

void HeadLean::look(const GrowthLattice& lattice, const HeadRoom& room, const LeanQuestion& question,
                    Progress& progress) {
  const auto count = static_cast<std::size_t>(frame_.voxelCount());
  std::vector<std::uint32_t> middle(count, CellGraph::kNone);
  std::vector<double> least(count, std::numeric_limits<double>::infinity());
  const double ratio = cells_.frame().voxel_mm / frame_.voxel_mm;
  for (std::uint32_t node = 0; node < cells_.nodeCount(); ++node) {
    if (!std::isfinite(lattice.samples()[node].growth_mm)) continue;
    const auto cell = cells_.cell(node);
    const auto coarse = [&](std::size_t axis) { return static_cast<int>((cell[axis] + 0.5) * ratio); };
    const std::size_t number = numberOf(coarse(0), coarse(1), coarse(2));
    const double squared =
        (cells_.middle(node) - frame_.centre(coarse(0), coarse(1), coarse(2))).squaredNorm();
    if (squared >= least[number]) continue;
    least[number] = squared;
    middle[number] = node;
  }
  lean_.assign(count, kNowhere);
  std::vector<char> is_shut(count, 0);
  const auto lookAt = [&](std::size_t number) {
    if (middle[number] == CellGraph::kNone) return;
    const GrowthSample& sample = lattice.samples()[middle[number]];
    const Point3 direction = sample.gradient.normalized();
    const Point3& tip = cells_.middle(middle[number]);
    const double growth_mm = sample.growth_mm + question.ahead_mm;
    lean_[number] = 0.0F;
    for (double lean = 0.0; lean <= question.greatest_rad + 1e-9; lean += kStepRad) {
      if (!room.isClear(tip, turnedUp(direction, lean), growth_mm)) continue;
      lean_[number] = static_cast<float>(lean);
      return;
    }
    is_shut[number] = 1;
  };
  constexpr std::size_t kBlock = 64;
  const auto lookAtBlock = [&](std::size_t block) {
    for (std::size_t i = block * kBlock; i < std::min(count, (block + 1) * kBlock); ++i) lookAt(i);
  };
  parallelFor((count + kBlock - 1) / kBlock, lookAtBlock, progress, "head");
  double places = 0.0;
  double shut = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    if (middle[i] != CellGraph::kNone) ++places;
    if (is_shut[i] != 0) ++shut;
  }
  if (places > 0.0) shut_ = shut / places;
}

/// The greatest of the neighbours first, then their mean: it is nowhere less than before.
void HeadLean::evenOut() {
  const auto visit = [&](const std::vector<float>& from, bool is_mean) {
    std::vector<float> to(from.size(), kNowhere);
    for (int k = 0; k < frame_.count[2]; ++k)
      for (int j = 0; j < frame_.count[1]; ++j)
        for (int i = 0; i < frame_.count[0]; ++i) {
          float greatest = kNowhere;
          float sum = 0.0F;
          int count = 0;
          for (int near = 0; near < 27; ++near) {
            const int x = i + near % 3 - 1;
            const int y = j + near / 3 % 3 - 1;
            const int z = k + near / 9 - 1;
            if (!frame_.contains(x, y, z) || from[numberOf(x, y, z)] < 0.0F) continue;
            greatest = std::max(greatest, from[numberOf(x, y, z)]);
            sum += from[numberOf(x, y, z)];
            ++count;
          }
          if (count > 0) to[numberOf(i, j, k)] = is_mean ? sum / static_cast<float>(count) : greatest;
        }
    return to;
  };
  if (std::all_of(lean_.begin(), lean_.end(), [](float lean) { return lean <= 0.0F; })) return;
  lean_ = visit(visit(lean_, false), true);
  for (const float lean : lean_) greatest_ = std::max(greatest_, static_cast<double>(lean));
}

Point3 HeadLean::direction(const Point3& place, const Point3& normal) const {
  if (greatest_ <= 0.0) return normal;
  const Point3 at = (place - frame_.corner) / frame_.voxel_mm - Point3::Constant(0.5);
  const Point3 low(std::floor(at.x()), std::floor(at.y()), std::floor(at.z()));
  const Point3 part = at - low;
  double sum = 0.0;
  double weights = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    const int i = static_cast<int>(low.x()) + corner % 2;
    const int j = static_cast<int>(low.y()) + corner / 2 % 2;
    const int k = static_cast<int>(low.z()) + corner / 4;
    if (!frame_.contains(i, j, k) || lean_[numberOf(i, j, k)] < 0.0F) continue;
    const double weight = (corner % 2 == 1 ? part.x() : 1.0 - part.x()) *
                          (corner / 2 % 2 == 1 ? part.y() : 1.0 - part.y()) *
                          (corner / 4 == 1 ? part.z() : 1.0 - part.z());
    sum += weight * static_cast<double>(lean_[numberOf(i, j, k)]);
    weights += weight;
  }
  return weights > 0.0 ? turnedUp(normal, sum / weights) : normal;
}

}  // namespace lamina
