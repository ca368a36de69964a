// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "lamina/geometry/vector.hpp"

namespace lamina {

/// Squares in x and y, regardless of z; all of them take memory. Or cubes; only cubes with boxes take memory.
enum class CellKind : std::uint8_t { Squares, Cubes };

/// The space that is divided into cells.
struct CellSpace {
  CellKind kind = CellKind::Cubes;
  Box3 box;              ///< not empty; boxes beyond it are assigned to the cells at its border
  double cell_mm = 1.0;  ///< positive, and at least a millionth of the size of the box
};

/// Numbered boxes, assigned to cells so that the boxes that may contain a point are found at once.
class BoxCells {
 public:
  static constexpr std::uint32_t kNone = 0xFFFFFFFFU;

  /// Numbers of the boxes of a cell, ascending.
  struct Numbers {
    const std::uint32_t* first = nullptr;
    const std::uint32_t* last = nullptr;
    const std::uint32_t* begin() const { return first; }
    const std::uint32_t* end() const { return last; }
  };

  /// Makes an empty set.
  BoxCells() = default;
  /// @param for_each_box  calls its argument with a number and a box, for all boxes; numbers ascend, and
  ///   several may be equal. It is called twice
  template <class ForEachBox>
  BoxCells(const CellSpace& space, const ForEachBox& for_each_box);

  /// Numbers of the boxes that reach the cell of a point; none if the point is not in the space.
  Numbers near(const Point3& place) const { return in(cellAt(place)); }

  /// The two steps of `near`, so that the memory for many points can be fetched in advance: the cell of a
  /// point (kNone if it has no boxes), and the boxes of that cell.
  std::uint32_t cellAt(const Point3& place) const;
  Numbers in(std::uint32_t cell) const;
  void fetch(std::uint32_t cell) const {
    if (cell != kNone) __builtin_prefetch(begin_.data() + cell);
  }

  /// Number of cells that have numbers; these count from 0.
  std::size_t size() const { return begin_.size() - 1; }
  std::size_t bytes() const {
    return sizeof(std::uint32_t) * (begin_.capacity() + numbers_.capacity()) +
           sizeof(Cube) * table_.capacity();
  }

 private:
  /// A cube with boxes; `number` is kNone in a free slot of the hash table.
  struct Cube {
    std::uint64_t key = 0;
    std::uint32_t number = kNone;
  };
  using Place = std::array<std::int64_t, 3>;
  static constexpr std::uint64_t kSpread =
      0x9E3779B97F4A7C15ULL;  ///< factor that scatters keys over the table

  void layOut(const CellSpace& space);
  Place placeAt(const Point3& point) const;
  template <class ForEachBox, class Visit>
  void visitCells(const ForEachBox& for_each_box, const Visit& visit) const;
  std::uint64_t keyOf(const Place& place) const {
    return static_cast<std::uint64_t>(place[0] + count_[0] * (place[1] + count_[1] * place[2]));
  }
  std::uint32_t numberOf(std::uint64_t key) const;
  std::uint32_t numberedAs(std::uint64_t key);
  void grow();

  CellKind kind_ = CellKind::Squares;
  Point3 low_ = Point3::Zero();
  double per_mm_ = 1.0;
  Place count_{};
  /// Index of the first number of each cell, and the number of all at the end.
  std::vector<std::uint32_t> begin_{0};
  std::vector<std::uint32_t> numbers_;
  std::vector<Cube> table_;  ///< hash table whose size is a power of two; empty for squares
  std::uint32_t cubes_ = 0;
};

// Called once for each point, so it should be inlined.

inline std::uint32_t BoxCells::numberOf(std::uint64_t key) const {
  if (kind_ == CellKind::Squares) return static_cast<std::uint32_t>(key);
  const std::size_t mask = table_.size() - 1;
  for (std::size_t at = (key * kSpread >> 32U) & mask;; at = (at + 1) & mask)
    if (table_[at].number == kNone || table_[at].key == key) return table_[at].number;
}

inline std::uint32_t BoxCells::cellAt(const Point3& place) const {
  Place cell{};
  for (std::size_t axis = 0; axis < (kind_ == CellKind::Squares ? 2U : 3U); ++axis) {
    const auto a = static_cast<Eigen::Index>(axis);
    const double offset = per_mm_ * (place[a] - low_[a]);
    if (!(offset >= 0.0 && offset < static_cast<double>(count_[axis]))) return kNone;
    cell[axis] = static_cast<std::int64_t>(offset);
  }
  return numberOf(keyOf(cell));
}

inline BoxCells::Numbers BoxCells::in(std::uint32_t cell) const {
  if (cell == kNone) return {};
  return {numbers_.data() + begin_[cell], numbers_.data() + begin_[cell + 1]};
}

/// Calls visit(number, key) for all boxes and the cells that they reach.
template <class ForEachBox, class Visit>
void BoxCells::visitCells(const ForEachBox& for_each_box, const Visit& visit) const {
  for_each_box([&](std::uint32_t number, const Box3& box) {
    const Place first = placeAt(box.low);
    const Place last = placeAt(box.high);
    Place place{};
    for (place[2] = first[2]; place[2] <= last[2]; ++place[2])
      for (place[1] = first[1]; place[1] <= last[1]; ++place[1])
        for (place[0] = first[0]; place[0] <= last[0]; ++place[0]) visit(number, keyOf(place));
  });
}

template <class ForEachBox>
BoxCells::BoxCells(const CellSpace& space, const ForEachBox& for_each_box) {
  layOut(space);
  std::vector<std::uint32_t> last(begin_.size(), kNone);  // number in each cell
  visitCells(for_each_box, [&](std::uint32_t number, std::uint64_t key) {
    const std::uint32_t cell = numberedAs(key);
    if (cell + 2 > begin_.size()) {
      begin_.push_back(0);
      last.push_back(kNone);
    }
    if (std::exchange(last[cell], number) != number) ++begin_[cell];
  });
  std::uint32_t sum = 0;
  for (std::uint32_t& begin : begin_) begin = std::exchange(sum, sum + begin);
  numbers_.resize(sum);
  std::vector<std::uint32_t> next = begin_;
  visitCells(for_each_box, [&](std::uint32_t number, std::uint64_t key) {
    const std::uint32_t cell = numberOf(key);
    if (next[cell] == begin_[cell] || numbers_[next[cell] - 1] != number) numbers_[next[cell]++] = number;
  });
}

}  // namespace lamina
