// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "control/straight_beads.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace lamina {
namespace {

constexpr double kOffLine = 1e-4;    // of a cell's length: cells of a straight line
constexpr double kTurned = 1e-5;     // of unit vectors along it
constexpr double kRoundings = 16.0;  // of the coordinates of points and cells, as single floats
constexpr double kSingle = 6e-8;     // relative, of one
constexpr double kMostUnsure = 0.1;  // of cells and of widths: beyond, nothing would be won

/// Cells of one run from `first` on that lie along one line and are alike.
std::size_t straightCells(const LayerCells& cells, const CellRun& run, std::size_t first) {
  const std::size_t end = run.first + run.count;
  const double length = run.cellLength();
  std::size_t i = first;
  while (++i < end) {
    const Point3 expected =
        cells.middle[first] + static_cast<double>(i - first) * length * cells.tangent[first];
    const bool goes_on = (cells.middle[i] - expected).norm() < kOffLine * length &&
                         (cells.tangent[i] - cells.tangent[first]).norm() < kTurned;
    const bool is_alike =
        cells.width_mm[i] == cells.width_mm[first] && cells.height_mm[i] == cells.height_mm[first];
    if (!goes_on || !is_alike) break;
  }
  return i - first;
}

}  // namespace

StraightBeads::StraightBeads(const LayerCells& cells, const StationIndex& index) {
  const std::vector<std::uint32_t> stretch_of = layStretches(cells, index);
  if (stretches_.empty()) return;
  laySquares(index, stretch_of);
}

/// The stretch of each cell; `kNone` of those whose neighbours are not in line with it, so that bends count.
std::vector<std::uint32_t> StraightBeads::layStretches(const LayerCells& cells, const StationIndex& index) {
  std::vector<std::uint32_t> stretch_of(cells.size(), kNone);
  double farthest = 0.0;
  for (const Point3& middle : cells.middle)
    farthest = std::max(farthest, index.placeOf(middle).cwiseAbs().maxCoeff());
  for (const CellRun& run : cells.runs) {
    const double length = run.cellLength();
    const double off_mm = kOffLine * length + kRoundings * kSingle * farthest;
    const std::size_t run_end = run.first + run.count;
    for (std::size_t first = run.first, end = first; first < run_end; first = end) {
      end = first + straightCells(cells, run, first);
      const std::size_t from = first + (first > run.first || run.is_closed ? 1U : 0U);
      const std::size_t to = end - (end < run_end || run.is_closed ? 1U : 0U);
      const double width = cells.width_mm[first];
      if (from >= to || off_mm > kMostUnsure * std::min(length, width)) continue;
      unsure_cells_ = std::max(unsure_cells_, off_mm / length);
      unsure_widths_ = std::max(unsure_widths_, off_mm / width);
      std::fill(stretch_of.begin() + static_cast<std::ptrdiff_t>(from),
                stretch_of.begin() + static_cast<std::ptrdiff_t>(to),
                static_cast<std::uint32_t>(stretches_.size()));
      const double ahead = (static_cast<double>(from - first) - 0.5) * length;
      const Point3 start = index.placeOf(cells.middle[first] + ahead * cells.tangent[first]);
      const Eigen::Vector3d tangent = index.turned(cells.tangent[first]);
      stretches_.push_back({start.x(), start.y(), tangent.x(), tangent.y(), 1.0 / length, 1.0 / width,
                            static_cast<double>(to - from), static_cast<std::uint32_t>(from)});
    }
  }
  stretches_.shrink_to_fit();
  return stretch_of;
}

/// None if the cells near are of too many stretches, of bends, or of two stretches whose numbers follow one
/// another, which a search takes for one bead.
std::optional<StraightBeads::Stretches> StraightBeads::reaching(
    const BoxCells::Numbers& near, const std::vector<std::uint32_t>& stretch_of) {
  Stretches found;
  found.fill(kNone);
  std::size_t count = 0;
  std::uint32_t last = kNone;
  for (const std::uint32_t cell : near) {
    const std::uint32_t stretch = stretch_of[cell];
    const bool goes_on = last != kNone && cell == last + 1;
    const bool is_same = last != kNone && stretch_of[last] == stretch;
    if (stretch == kNone || goes_on != is_same) return std::nullopt;
    last = cell;
    if (is_same) continue;
    if (count == found.size()) return std::nullopt;
    found[count++] = stretch;
  }
  return found;
}

void StraightBeads::laySquares(const StationIndex& index, const std::vector<std::uint32_t>& stretch_of) {
  std::map<Stretches, std::uint32_t> numbers;
  auto last = numbers.end();
  set_of_.reserve(index.stations().size());
  for (std::uint32_t square = 0; square < index.stations().size(); ++square) {
    const auto found = reaching(index.stations().in(square), stretch_of);
    // Most squares have the stretches of the one before.
    if (found && (last == numbers.end() || last->first != *found)) {
      const auto added = numbers.emplace(*found, static_cast<std::uint32_t>(sets_.size()));
      if (added.second) sets_.push_back(*found);
      last = added.first;
    }
    set_of_.push_back(found ? last->second : kUnsure);
  }
  sets_.shrink_to_fit();
}

std::size_t StraightBeads::bytes() const {
  return sizeof(Stretch) * stretches_.capacity() + sizeof(Stretches) * sets_.capacity() +
         sizeof(std::uint32_t) * set_of_.capacity();
}

}  // namespace lamina
