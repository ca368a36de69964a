// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/deposition/voxel_deposit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/deposition/strand.hpp"
#include "lamina/geometry/voxel/voxel_grid.hpp"

namespace lamina {

/// Lengths within a search count in 256ths of a voxel, as whole numbers: so distances compare exactly.
constexpr int kFine = 256;

/// Where a portion of material comes out. Lengths are in voxels, from the corner of the frame.
struct Outlet {
  Point3 tip = Point3::Zero();  ///< the plane through it, square to the tool axis, is not passed
  Eigen::Vector3d tool_axis{0, 0, -1};
  Point3 middle = Point3::Zero();  ///< what lies nearest is filled first
};

/// A voxel that may be filled.
struct OpenVoxel {
  std::int64_t distance2 = 0;  ///< from the middle, squared [256ths of a voxel]
  int i = 0;
  int j = 0;
  int k = 0;
};

/// Finds the open voxels nearest to an outlet. It remembers the ball that the last search left full, and
/// looks only around it as long as the outlets follow each other: voxels only ever become solid.
class NearestRoom {
 public:
  /// @param lowest_k     voxels below are never room
  /// @param reach        farthest from the middle [voxels]
  NearestRoom(int lowest_k, double reach);

  /// The `count` open voxels of the grid nearest to the outlet's middle, or all within reach if there are
  /// fewer. All of them must be solid before the next call. Of those at the same distance, one side of the
  /// middle comes first, another at every call.
  const std::vector<OpenVoxel>& find(const VoxelGrid& grid, const Outlet& outlet, std::int64_t count);

 private:
  struct Search;
  struct Row;

  std::int64_t radiusKnownFull(const Search& search) const;
  void collect(const Search& search, std::int64_t inner, std::int64_t outer);
  void collectRow(const Search& search, const Row& row, std::int64_t inner, std::int64_t outer);
  std::int64_t keepNearest(std::int64_t count);

  int lowest_k_;
  std::int64_t reach_;       ///< [256ths of a voxel], as all below
  std::int64_t usual_ = 0;   ///< how far the last search went
  std::uint32_t calls_ = 0;  ///< decides between sides
  std::vector<OpenVoxel> found_;
  Outlet last_;
  std::array<std::int64_t, 3> last_middle_{};
  std::int64_t full_ = 0;  ///< every voxel nearer than this to the last middle, behind its plane, is solid
};

/// Height of the top in each column of voxels, as floats [mm above the bed].
class ColumnTops {
 public:
  ColumnTops(const VoxelFrame& frame, double bed_z_mm);

  void raise(int i, int j, double z);
  double at(double x, double y) const;

 private:
  std::size_t index(int i, int j) const {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(frame_.count[0]) +
           static_cast<std::size_t>(i);
  }

  VoxelFrame frame_;
  double bed_z_mm_;
  std::vector<float> above_bed_;
};

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
      throw InvalidInput("motion of the nozzle from (" + numberText(motion.start.x()) + ", " +
                         numberText(motion.start.y()) + ", " + numberText(motion.start.z()) + ") to (" +
                         numberText(motion.end.x()) + ", " + numberText(motion.end.y()) + ", " +
                         numberText(motion.end.z()) + ") mm; expected to stay within 1 km");
  for (const Eigen::Vector3d& tool_axis : {motion.start_tool_axis, motion.end_tool_axis})
    if (!(std::abs(tool_axis.norm() - 1.0) <= kUnit))
      throw InvalidInput("tool axis of the nozzle is " + numberText(tool_axis.norm()) + " long; expected 1");
  if (!(motion.volume_mm3 >= 0.0 && std::isfinite(motion.volume_mm3)))
    throw InvalidInput("volume of a motion is " + numberText(motion.volume_mm3) + " mm3; expected 0 or more");
  if (!(motion.radius_mm >= 0.0 && motion.radius_mm <= VoxelDeposit::kThickestStrand))
    throw InvalidInput("radius of a strand is " + numberText(motion.radius_mm) + " mm; expected 0 to " +
                       numberText(VoxelDeposit::kThickestStrand) + " mm");
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
    throw InvalidInput("deposition.reach_mm is " + numberText(settings.reach_mm) + " mm; expected up to " +
                       numberText(kMostReach * voxel_mm) + " mm for voxels of " + numberText(voxel_mm) +
                       " mm");
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

ColumnTops::ColumnTops(const VoxelFrame& frame, double bed_z_mm)
    : frame_(frame),
      bed_z_mm_(bed_z_mm),
      above_bed_(static_cast<std::size_t>(frame.count[0]) * static_cast<std::size_t>(frame.count[1]), 0.0F) {}

void ColumnTops::raise(int i, int j, double z) {
  float& top = above_bed_[index(i, j)];
  top = std::max(top, static_cast<float>(z - bed_z_mm_));
}

double ColumnTops::at(double x, double y) const {
  const double i = std::floor((x - frame_.corner.x()) / frame_.voxel_mm);
  const double j = std::floor((y - frame_.corner.y()) / frame_.voxel_mm);
  const bool is_inside = i >= 0.0 && j >= 0.0 && i < frame_.count[0] && j < frame_.count[1];
  if (!is_inside) return bed_z_mm_;
  return bed_z_mm_ + static_cast<double>(above_bed_[index(static_cast<int>(i), static_cast<int>(j))]);
}

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
