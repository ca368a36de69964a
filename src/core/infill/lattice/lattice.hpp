// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "infill/hilbert/hilbert_order.hpp"
#include "infill/rectilinear/raster.hpp"
#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/infill/strategy.hpp"

namespace lamina {

/// The frame of a lattice of cells: turned by an angle, with an origin at a corner, and a step along each
/// axis.
class LatticeFrame {
 public:
  /// Fits a lattice to the region's bounding box in the turned frame: the outermost rows and columns are just
  /// inside the box, and steps are as close to the spacing as a whole number of them allows. A side shorter
  /// than half a spacing has one row, in its middle.
  LatticeFrame(const Region& region, double spacing_mm, double angle_rad);

  Point2 intoLattice(const Point2& point) const;
  Point2 outOfLattice(const Point2& point) const;
  Point2 centre(const Cell& cell) const;
  int columns() const { return columns_; }
  int rows() const { return rows_; }
  /// Steps from column to column and from row to row [mm].
  const Point2& step() const { return step_; }

 private:
  RasterFrame turn_;
  Point2 corner_ = Point2::Zero();  ///< middle of cell (0, 0), in the turned frame
  Point2 step_ = Point2::Ones();
  int columns_ = 0;
  int rows_ = 0;
};

/// Plan width of a bead [mm]: the pitch times the ratio of a cell's area to the area of a cell of the
/// requested spacing.
double beadWidth(const LatticeFrame& frame, const InfillRequest& request);

/// The cells of a lattice whose centres are in a region, and the steps between neighbours that stay in the
/// region.
struct Lattice {
  LatticeFrame frame;
  Raster rows;     ///< the region cut along the rows, in lattice coordinates
  Raster columns;  ///< the region cut along the columns, in lattice coordinates turned by a right angle: line
                   ///< -c is column c

  Lattice(const Region& centre_lines, double spacing_mm, double angle_rad);

  /// Finds diagonal steps too; before this call there are none.
  void findDiagonals();

  std::size_t indexOf(const Cell& cell) const {
    return static_cast<std::size_t>(cell.row) * static_cast<std::size_t>(frame.columns()) +
           static_cast<std::size_t>(cell.column);
  }
  std::size_t size() const { return bits_.size(); }
  bool isInside(std::size_t cell) const { return (bits_[cell] & kInside) != 0; }
  /// Whether the step to the next column (or row) stays in the region.
  bool leadsRight(std::size_t cell) const { return (bits_[cell] & kRight) != 0; }
  bool leadsUp(std::size_t cell) const { return (bits_[cell] & kUp) != 0; }
  /// Whether the step to the next row and the next (or previous) column stays in the region.
  bool leadsUpRight(std::size_t cell) const { return (bits_[cell] & kUpRight) != 0; }
  bool leadsUpLeft(std::size_t cell) const { return (bits_[cell] & kUpLeft) != 0; }

 private:
  static constexpr std::uint8_t kInside = 1;
  static constexpr std::uint8_t kRight = 2;
  static constexpr std::uint8_t kUp = 4;
  static constexpr std::uint8_t kUpRight = 8;
  static constexpr std::uint8_t kUpLeft = 16;

  void markRows();
  void markColumns();
  bool holds(const Cell& cell) const {
    return cell.column >= 0 && cell.column < frame.columns() && cell.row >= 0 && cell.row < frame.rows();
  }
  void markDiagonal(const Cell& from, const Cell& to, std::uint8_t step);

  Regions region_;  ///< in lattice coordinates

  std::vector<std::uint8_t> bits_;
};

}  // namespace lamina
