// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "infill/rectilinear/raster_walk.hpp"
#include "infill/rectilinear/section_order.hpp"

namespace lamina {

/// Which lines of a raster passes run along.
enum class PassLines {
  All,
  Odd,  ///< a pass fills the strip between the even lines below and above it
};

/// The passes of a raster and the sections they form: a section is a stack of passes of which the outline
/// joins each with the next on both sides, a monotone cell.
class BoustrophedonCells {
 public:
  BoustrophedonCells(const RasterWalk& walk, PassLines lines);

  /// Left ends of the passes of each section, from below.
  const std::vector<std::vector<std::uint32_t>>& sections() const { return sections_; }
  /// The crossing on the pass line above that the outline leads to, or none.
  std::uint32_t above(std::uint32_t crossing) const { return above_[crossing]; }
  /// What their order depends on, in the raster frame.
  std::vector<BoustrophedonCell> ends() const;

 private:
  bool isPass(std::size_t inside_line) const;
  std::uint32_t findAbove(std::uint32_t crossing) const;
  /// The pass above joined on both sides, by its left end.
  std::uint32_t stackedOn(std::uint32_t left) const;

  const RasterWalk& walk_;
  PassLines lines_;
  std::vector<std::uint32_t> above_;
  std::vector<std::vector<std::uint32_t>> sections_;
};

/// A pass in the order deposited, by the crossing at which it is entered.
using PassEntries = std::vector<std::uint32_t>;

/// The passes of all sections in the order of the tour.
PassEntries passesOf(const BoustrophedonCells& sections, const RasterWalk& walk, const SectionTour& tour);

}  // namespace lamina
