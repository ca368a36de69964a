// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nearest_room.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace lamina {
namespace {

constexpr int kShift = 8;                  // kFine = 1 << kShift
constexpr std::int64_t kHalf = kFine / 2;  // a voxel's centre from its corner
constexpr double kOnPlane = 1e-6;          // voxels: a centre on the plane counts as behind it
constexpr double kParallel = 1e-12;
constexpr double kFarBorder = 2e9;       // voxels: beyond all frames, within whole numbers
constexpr std::int64_t kMostLikely = 3;  // times the ball that a portion would fill

/// Largest whole number whose square is not above. Exact below 2^53.
std::int64_t wholeRoot(std::int64_t square) {
  return static_cast<std::int64_t>(std::sqrt(static_cast<double>(square)));
}

std::int64_t centreOf(int index) { return (std::int64_t{index} << kShift) + kHalf; }

/// First voxel whose centre is not below, last one whose centre is not above.
int firstFrom(std::int64_t low) { return static_cast<int>((low - kHalf + kFine - 1) >> kShift); }
int lastUpTo(std::int64_t high) { return static_cast<int>((high - kHalf) >> kShift); }

/// Bits of a word from `low` to `high`, both included; either may lie beyond the word.
std::uint64_t bitsBetween(int low, int high) {
  constexpr int kLast = VoxelGrid::kWord - 1;
  return ~std::uint64_t{0} << std::max(0, low) & ~std::uint64_t{0} >> (kLast - std::min(kLast, high));
}

}  // namespace

struct NearestRoom::Search {
  const VoxelGrid& grid;
  const Outlet& outlet;
  std::array<std::int64_t, 3> middle{};
};

/// Voxels along x.
struct NearestRoom::Row {
  int j = 0;
  int k = 0;
  std::int64_t across2 = 0;  ///< of the distance from the middle squared, what j and k contribute
  double behind = 0.0;       ///< of the distance behind the nozzle's plane, what j and k contribute [voxels]
};

NearestRoom::NearestRoom(int lowest_k, double reach)
    : lowest_k_(lowest_k), reach_(static_cast<std::int64_t>(std::ceil(reach * kFine))) {}

/// A ball around the middle in which nothing is open, from what the last search left.
std::int64_t NearestRoom::radiusKnownFull(const Search& search) const {
  const Outlet& outlet = search.outlet;
  const bool is_behind =
      outlet.tool_axis == last_.tool_axis && outlet.tool_axis.dot(outlet.tip - last_.tip) >= 0.0;
  if (!is_behind) return 0;
  std::int64_t square = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::int64_t moved = search.middle[axis] - last_middle_[axis];
    square += moved * moved;
  }
  return std::max<std::int64_t>(0, full_ - wholeRoot(square) - 1);
}

/// Adds the open voxels of the row at distances in [inner, outer).
void NearestRoom::collectRow(const Search& search, const Row& row, std::int64_t inner, std::int64_t outer) {
  const std::int64_t middle = search.middle[0];
  const std::int64_t half = wholeRoot(outer * outer - row.across2 - 1);
  int low = std::max(0, firstFrom(middle - half));
  int high = std::min(search.grid.frame().count[0] - 1, lastUpTo(middle + half));
  const double tool_axis_x = search.outlet.tool_axis.x();
  if (std::abs(tool_axis_x) >= kParallel) {
    const double border =
        std::clamp(search.outlet.tip.x() - 0.5 - row.behind / tool_axis_x, -2.0, kFarBorder);
    if (tool_axis_x > 0.0) {
      low = std::max(low, static_cast<int>(std::ceil(border)));
    } else {
      high = std::min(high, static_cast<int>(std::floor(border)));
    }
  }
  if (low > high) return;
  for (int w = low / VoxelGrid::kWord; w <= high / VoxelGrid::kWord; ++w) {
    const int begin = w * VoxelGrid::kWord;
    std::uint64_t open = ~search.grid.word(w, row.j, row.k) & bitsBetween(low - begin, high - begin);
    for (; open != 0; open &= open - 1) {
      const int i = begin + __builtin_ctzll(open);
      const std::int64_t dx = centreOf(i) - middle;
      const std::int64_t distance2 = dx * dx + row.across2;
      if (distance2 >= inner * inner) found_.push_back({distance2, i, row.j, row.k});
    }
  }
}

/// Adds the open voxels at distances in [inner, outer).
void NearestRoom::collect(const Search& search, std::int64_t inner, std::int64_t outer) {
  const VoxelFrame& frame = search.grid.frame();
  const Outlet& outlet = search.outlet;
  const bool is_level =
      std::abs(outlet.tool_axis.x()) < kParallel && std::abs(outlet.tool_axis.y()) < kParallel;
  const int last_k = std::min(frame.count[2] - 1, lastUpTo(search.middle[2] + outer));
  for (int k = std::max(lowest_k_, firstFrom(search.middle[2] - outer)); k <= last_k; ++k) {
    const double behind = outlet.tool_axis.z() * (k + 0.5 - outlet.tip.z()) + kOnPlane;
    if (is_level && behind < 0.0) continue;
    const std::int64_t dz = centreOf(k) - search.middle[2];
    const std::int64_t left = outer * outer - dz * dz;
    if (left <= 0) continue;
    const std::int64_t half = wholeRoot(left - 1);
    const int last_j = std::min(frame.count[1] - 1, lastUpTo(search.middle[1] + half));
    for (int j = std::max(0, firstFrom(search.middle[1] - half)); j <= last_j; ++j) {
      const std::int64_t dy = centreOf(j) - search.middle[1];
      const Row row{j, k, dy * dy + dz * dz, behind + outlet.tool_axis.y() * (j + 0.5 - outlet.tip.y())};
      if (row.behind >= 0.0 || std::abs(outlet.tool_axis.x()) >= kParallel)
        collectRow(search, row, inner, outer);
    }
  }
}

/// Drops all but the nearest, which there must be enough of; returns the square of the largest distance left.
std::int64_t NearestRoom::keepNearest(std::int64_t count) {
  const int side_x = (calls_ & 1U) != 0 ? 1 : -1;
  const int side_y = (calls_ & 2U) != 0 ? 1 : -1;
  const auto is_nearer = [side_x, side_y](const OpenVoxel& a, const OpenVoxel& b) {
    if (a.distance2 != b.distance2) return a.distance2 < b.distance2;
    if (a.k != b.k) return a.k < b.k;
    if (a.j != b.j) return a.j * side_y < b.j * side_y;
    return a.i * side_x < b.i * side_x;
  };
  const auto last = found_.begin() + (count - 1);
  std::nth_element(found_.begin(), last, found_.end(), is_nearer);
  const std::int64_t farthest2 = last->distance2;
  found_.resize(static_cast<std::size_t>(count));
  return farthest2;
}

const std::vector<OpenVoxel>& NearestRoom::find(const VoxelGrid& grid, const Outlet& outlet,
                                                std::int64_t count) {
  Search search{grid, outlet, {}};
  for (std::size_t axis = 0; axis < 3; ++axis)
    search.middle[axis] = std::llround(outlet.middle[static_cast<Eigen::Index>(axis)] * kFine);
  ++calls_;
  found_.clear();
  const auto ball = static_cast<std::int64_t>(kFine * std::cbrt(static_cast<double>(count) * 0.75 / M_PI));
  std::int64_t inner = std::min(radiusKnownFull(search), reach_);
  const std::int64_t likely = std::clamp(usual_, ball, kMostLikely * ball);
  std::int64_t outer = std::min(std::max(likely, inner) + kHalf / 2, reach_);
  collect(search, inner, outer);
  while (static_cast<std::int64_t>(found_.size()) < count && outer < reach_) {
    inner = outer;
    outer = std::min(outer + outer / 4 + kHalf, reach_);
    collect(search, inner, outer);
  }
  const bool is_enough = static_cast<std::int64_t>(found_.size()) >= count;
  full_ = is_enough ? wholeRoot(keepNearest(count)) : reach_;
  usual_ = full_;
  last_ = outlet;
  last_middle_ = search.middle;
  return found_;
}

}  // namespace lamina
