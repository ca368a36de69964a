// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/deposition/bead_deposit.hpp"

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <string>
#include <utility>

#include "deposition/bead_section.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"

namespace lamina {
namespace {

constexpr double kPieceLength =
    4.0;  // mm: long motions are deposited piece by piece, so that each meets its own ground
constexpr double kFarthestBead = 1e6;  // mm
constexpr double kSameHeight = 0.01;   // mm: below any layer height, above the rounding of programs
constexpr double kShortest = 1e-6;     // mm: a shorter motion is a blob on the spot

double crossSectionOf(const DepositedMotion& motion) {
  const double length = (motion.end - motion.start).norm();
  if (length > kShortest) return motion.volume_mm3 / length;
  // A blob: the great circle of the ball of that volume.
  return M_PI * std::pow(3.0 * motion.volume_mm3 / (4.0 * M_PI), 2.0 / 3.0);
}

void checkMotion(const DepositedMotion& motion) {
  const double farthest = std::max(motion.start.cwiseAbs().maxCoeff(), motion.end.cwiseAbs().maxCoeff());
  if (!(farthest <= kFarthestBead) || !motion.start.allFinite() || !motion.end.allFinite())
    throw InvalidInput("deposited motion is not finite or farther out than 1 km");
  if (!(motion.volume_mm3 >= 0.0 && std::isfinite(motion.volume_mm3)))
    throw InvalidInput("deposited volume is " + numberText(motion.volume_mm3) + " mm3; must be 0 or more");
}

}  // namespace

BeadDeposit::BeadDeposit(HeightMap ground)
    : surface_(std::move(ground)),
      highest_(heightRange(surface_).high),
      deposited_at_(surface_.grid().cellCount(), -std::numeric_limits<float>::infinity()) {}

void BeadDeposit::lay(const DepositedMotion& motion) {
  checkMotion(motion);
  if (motion.volume_mm3 == 0.0) {
    unsupported_mm_ = 0.0;
    return;
  }
  const Point3 along = motion.end - motion.start;
  const int pieces = 1 + static_cast<int>(along.norm() / kPieceLength);
  for (int i = 0; i < pieces; ++i)
    layPiece({motion.start + along * (double(i) / pieces), motion.start + along * (double(i + 1) / pieces),
              motion.volume_mm3 / pieces});
}

void BeadDeposit::layPiece(const DepositedMotion& piece) {
  const double area = crossSectionOf(piece);
  const double cell = surface_.grid().cell_mm;
  const double gap = gapUnder(piece, discDiameter(area));
  const double height = std::min(gap, discDiameter(area));
  const double widest = std::min(kWidestBead, 3.0 * widthOnFlatGround(area, gap) + cell);
  cells_ = cellsAround(piece, 0.5 * widest + cell);
  // What lies deeper stays open, as a pore: a map of heights that filled it would sink from layer to layer.
  for (Cell& at : cells_) {
    at.underside = at.ceiling - gap;
    at.floor = at.index == HeightGrid::kNoCell ? at.underside : std::max(at.floor, at.underside);
  }
  const double most = room(widest, height);
  excess_mm3_ += std::max(0.0, piece.volume_mm3 - most);
  fill(most > piece.volume_mm3 ? widthFor(piece.volume_mm3, widest, height) : widest, height);
}

double BeadDeposit::gapUnder(const DepositedMotion& piece, double disc_diameter) {
  const double z = std::max(piece.start.z(), piece.end.z());
  const double length = (piece.end - piece.start).norm();
  if (std::abs(z - layer_z_) > std::max(kSameHeight, 0.5 * layer_gap_)) layer_gap_ = 0.0;
  layer_z_ = z;
  const double gap =
      gapToSupport(cellsAround(piece, std::max(surface_.grid().cell_mm, 0.25 * disc_diameter)), z);
  const bool is_supported = gap > 0.0 && !(layer_gap_ > 0.0 && gap > 1.5 * layer_gap_);
  unsupported_mm_ = is_supported ? 0.0 : unsupported_mm_ + length;
  if (is_supported) return layer_gap_ = gap;
  if (layer_gap_ > 0.0 && (gap <= 0.0 || unsupported_mm_ < kBridgedSpan)) return layer_gap_;
  return gap > 0.0 ? gap : disc_diameter;
}

/// From the nozzle down to the highest ground that this layer has not deposited itself; 0 if there is none.
double BeadDeposit::gapToSupport(const std::vector<Cell>& line, double ceiling) const {
  double highest = -std::numeric_limits<double>::infinity();
  for (const Cell& at : line) {
    const bool is_ground = at.index != HeightGrid::kNoCell && at.floor < ceiling - kSameHeight &&
                           deposited_at_[at.index] < ceiling - kSameHeight;
    if (is_ground) highest = std::max(highest, at.floor);
  }
  return std::isfinite(highest) ? ceiling - highest : 0.0;
}

std::vector<BeadDeposit::Cell> BeadDeposit::cellsAround(const DepositedMotion& piece, double reach) const {
  const HeightGrid& grid = surface_.grid();
  const Point2 start = piece.start.head<2>();
  const Point2 along = piece.end.head<2>() - start;
  const double squared = along.squaredNorm();
  const Point2 low = (start.cwiseMin(start + along) - Point2(reach, reach) - grid.origin) / grid.cell_mm;
  const Point2 high = (start.cwiseMax(start + along) + Point2(reach, reach) - grid.origin) / grid.cell_mm;
  std::vector<Cell> cells;
  for (int row = static_cast<int>(std::floor(low.y())); row <= high.y(); ++row) {
    for (int column = static_cast<int>(std::floor(low.x())); column <= high.x(); ++column) {
      const Point2 from_start = grid.centre(column, row) - start;
      const double at = squared > 0.0 ? std::clamp(from_start.dot(along) / squared, 0.0, 1.0) : 1.0;
      const double distance = (from_start - at * along).norm();
      if (distance > reach) continue;
      Cell cell;
      cell.distance = distance;
      cell.ceiling = piece.start.z() + at * (piece.end.z() - piece.start.z());
      if (grid.contains(column, row)) cell.index = grid.cell(column, row);
      if (cell.index != HeightGrid::kNoCell) cell.floor = surface_.at(cell.index);
      cells.push_back(cell);
    }
  }
  return cells;
}

double BeadDeposit::room(double width, double height) const {
  const double cell = surface_.grid().cell_mm;
  const BeadSection section{width, height, cell};
  double sum = 0.0;
  for (const Cell& at : cells_)
    sum += std::max(0.0, at.underside + topAbove(section, at.distance) - at.floor);
  return sum * cell * cell;
}

double BeadDeposit::widthFor(double volume, double widest, double height) const {
  const auto missing = [&](double width) { return room(width, height) - volume; };
  const double at_none = missing(0.0);
  if (at_none >= 0.0) return 0.0;
  std::uintmax_t steps = 60;
  const auto bracket = boost::math::tools::toms748_solve(
      missing, 0.0, widest, at_none, missing(widest), boost::math::tools::eps_tolerance<double>(40), steps);
  return 0.5 * (bracket.first + bracket.second);
}

void BeadDeposit::fill(double width, double height) {
  const BeadSection section{width, height, surface_.grid().cell_mm};
  for (const Cell& at : cells_) {
    if (at.index == HeightGrid::kNoCell) continue;
    const double above = topAbove(section, at.distance);
    const double top = at.underside + above;
    if (above <= 0.0 || top <= at.floor) continue;
    surface_.set(at.index, top);
    highest_ = std::max(highest_, top);
    deposited_at_[at.index] = static_cast<float>(at.ceiling);
  }
}

}  // namespace lamina
