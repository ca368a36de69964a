// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "control/station_index.hpp"

namespace lamina {

/// Finds the cell at a point of a plane layer by a division, without examining cells, where only a few
/// straight beads are near. Gives no answer where rounding could decide.
class StraightBeads {
 public:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  /// The cells near the point must be examined one by one.
  static constexpr std::uint32_t kUnsure = kNone - 1;

  /// No beads: all points are unsure.
  StraightBeads() = default;
  /// @param index  of these cells, which are of a plane layer
  StraightBeads(const LayerCells& cells, const StationIndex& index);

  /// The cell of the bead whose middle is nearest in bead widths, heights apart; `kNone` beside all beads.
  /// @param square  of the index, of that place
  /// @param place   point in the axes of the index
  std::uint32_t cellAt(std::uint32_t square, const Point3& place) const;
  void fetch(std::uint32_t square) const {
    if (square < set_of_.size()) __builtin_prefetch(set_of_.data() + square);
  }
  std::size_t bytes() const;

 private:
  /// Cells in a row along a straight line, in the axes of the index.
  struct Stretch {
    double u, v;  ///< start of the first cell
    double tangent_u, tangent_v;
    double cells_per_mm, widths_per_mm;
    double count;
    std::uint32_t first;
  };
  /// Stretches whose cells reach a square, ascending; `kNone` where there are fewer.
  using Stretches = std::array<std::uint32_t, 4>;

  std::vector<std::uint32_t> layStretches(const LayerCells& cells, const StationIndex& index);
  static std::optional<Stretches> reaching(const BoxCells::Numbers& near,
                                           const std::vector<std::uint32_t>& stretch_of);
  void laySquares(const StationIndex& index, const std::vector<std::uint32_t>& stretch_of);

  std::vector<Stretch> stretches_;
  std::vector<Stretches> sets_;
  std::vector<std::uint32_t> set_of_;  ///< by square; `kUnsure` where cells must be examined
  double unsure_cells_ = 0.0;  ///< distance from where two cells meet within which rounding may decide
  double unsure_widths_ = 0.0;
};

// Called once for each point, so it should be inlined.

inline std::uint32_t StraightBeads::cellAt(std::uint32_t square, const Point3& place) const {
  if (square >= set_of_.size()) return square == BoxCells::kNone ? kNone : kUnsure;
  if (set_of_[square] == kUnsure) return kUnsure;
  const Stretch* nearest = nullptr;
  double share = std::numeric_limits<double>::infinity();
  double next_share = share;
  for (const std::uint32_t number : sets_[set_of_[square]]) {
    if (number == kNone) break;
    const Stretch& stretch = stretches_[number];
    const double across =
        (place.y() - stretch.v) * stretch.tangent_u - (place.x() - stretch.u) * stretch.tangent_v;
    const double here = std::abs(across) * stretch.widths_per_mm;
    next_share = std::min(next_share, std::max(share, here));
    if (!(here < share)) continue;
    share = here;
    nearest = &stretch;
  }
  if (!nearest) return kNone;
  if (share > StationIndex::kAcross - unsure_widths_)
    return share < StationIndex::kAcross + unsure_widths_ ? kUnsure : kNone;
  if (next_share < share + 2.0 * unsure_widths_) return kUnsure;
  const double along =
      ((place.x() - nearest->u) * nearest->tangent_u + (place.y() - nearest->v) * nearest->tangent_v) *
      nearest->cells_per_mm;
  if (!(along >= 0.0 && along < nearest->count)) return kUnsure;
  const auto number = static_cast<std::uint32_t>(along);
  const double within = along - static_cast<double>(number);
  if (within < unsure_cells_ || within > 1.0 - unsure_cells_) return kUnsure;
  return nearest->first + number;
}

}  // namespace lamina
