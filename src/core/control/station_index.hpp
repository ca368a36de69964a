// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "lamina/control/layer_cells.hpp"

namespace lamina {

/// Finds the cells of a layer that may hold a point. If no cell leans from the plane of the layer by more
/// than 60 degrees it is a grid of squares in that plane; else it is a grid of cubes, of which only those
/// that hold cells take memory.
class StationIndex {
 public:
  StationIndex(const LayerCells& cells, double window_layers);

  /// Whether all cells have the same growth direction.
  bool isPlane() const { return is_plane_; }
  /// A point in the axes of the index: two in the plane, and its normal.
  Point3 placeOf(const Point3& point) const { return axes_ * point - low_; }
  Eigen::Vector3d turned(const Eigen::Vector3d& direction) const { return axes_ * direction; }

  /// Numbers of cells, ascending.
  struct Cells {
    const std::uint32_t* first = nullptr;
    const std::uint32_t* last = nullptr;
    const std::uint32_t* begin() const { return first; }
    const std::uint32_t* end() const { return last; }
  };
  /// @param place  of the point (`placeOf`)
  Cells near(const Point3& place) const { return cellsIn(squareOf(place)); }

  /// The same in two steps, so that the memory of many places can be fetched at once: the square or cube of a
  /// place, `kNone` if there is none, and its cells.
  static constexpr std::uint32_t kNone = 0xFFFFFFFFU;
  std::uint32_t squareOf(const Point3& place) const;
  Cells cellsIn(std::uint32_t square) const;
  void fetch(std::uint32_t square) const {
    if (square != kNone) __builtin_prefetch(begin_.data() + square);
  }

  std::size_t bytes() const;

 private:
  /// A cube that holds cells; `number` is kNone in a free slot of the table.
  struct Cube {
    std::uint64_t key = 0;
    std::uint32_t number = kNone;
  };
  using Place = std::array<std::int64_t, 3>;
  static constexpr std::uint64_t kSpread =
      0x9E3779B97F4A7C15ULL;  ///< factor that scatters keys over the table

  void layOut(const LayerCells& cells);
  /// Where a place of the axes lies, within the index.
  Place squareAt(const Point3& offset) const;
  Point3 reachOf(const LayerCells& cells, const CellRun& run, std::size_t cell) const;
  template <class Visit>
  void visitPlaces(const LayerCells& cells, Visit visit) const;
  std::uint64_t keyOf(const Place& place) const;
  std::uint32_t numberOf(std::uint64_t key) const;
  std::uint32_t numberedAs(std::uint64_t key);
  void grow();

  double window_layers_;
  bool is_plane_ = true;
  bool has_squares_ = true;
  Eigen::Matrix3d axes_ = Eigen::Matrix3d::Identity();  ///< rows: two of the plane, and its normal
  Point3 low_ = Point3::Zero();
  double per_mm_ = 1.0;
  Place count_{};
  std::vector<std::uint32_t> begin_;  ///< first cell of each square or cube, and the number of cells
  std::vector<std::uint32_t> cells_;
  std::vector<Cube> table_;  ///< a power of two long; empty for a plane
  std::uint32_t cubes_ = 0;
};

// Asked once a point: to be compiled in where that is done.

inline std::uint64_t StationIndex::keyOf(const Place& place) const {
  return static_cast<std::uint64_t>(place[0] + count_[0] * (place[1] + count_[1] * place[2]));
}

inline std::uint32_t StationIndex::numberOf(std::uint64_t key) const {
  if (has_squares_) return static_cast<std::uint32_t>(key);
  const std::size_t mask = table_.size() - 1;
  for (std::size_t at = (key * kSpread >> 32U) & mask;; at = (at + 1) & mask)
    if (table_[at].number == kNone || table_[at].key == key) return table_[at].number;
}

inline std::uint32_t StationIndex::squareOf(const Point3& at) const {
  Place place{};
  for (std::size_t axis = 0; axis < (has_squares_ ? 2U : 3U); ++axis) {
    const double offset = per_mm_ * at[static_cast<Eigen::Index>(axis)];
    if (!(offset >= 0.0 && offset < static_cast<double>(count_[axis]))) return kNone;
    place[axis] = static_cast<std::int64_t>(offset);
  }
  return numberOf(keyOf(place));
}

inline StationIndex::Cells StationIndex::cellsIn(std::uint32_t square) const {
  if (square == kNone) return {};
  return {cells_.data() + begin_[square], cells_.data() + begin_[square + 1]};
}

}  // namespace lamina
