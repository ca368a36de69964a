// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/rectilinear/boustrophedon_cells.hpp"

#include <algorithm>

namespace lamina {

BoustrophedonCells::BoustrophedonCells(const RasterWalk& walk, PassLines lines)
    : walk_(walk), lines_(lines), above_(walk.raster().crossings.size(), kNoCrossing) {
  for (std::size_t i = 0; i < walk.insideLines(); ++i) {
    if (!isPass(i)) continue;
    above_[walk.leftEnd(i)] = findAbove(walk.leftEnd(i));
    above_[walk.rightEnd(i)] = findAbove(walk.rightEnd(i));
  }
  std::vector<bool> is_stacked(walk.insideLines(), false);
  for (std::size_t i = 0; i < walk.insideLines(); ++i) {
    if (!isPass(i) || is_stacked[i]) continue;
    std::vector<std::uint32_t> section;
    for (std::uint32_t left = walk.leftEnd(i); left != kNoCrossing; left = stackedOn(left)) {
      section.push_back(left);
      is_stacked[walk.insideLine(left)] = true;
    }
    sections_.push_back(std::move(section));
  }
}

bool BoustrophedonCells::isPass(std::size_t inside_line) const {
  return lines_ == PassLines::All || walk_.lineOf(walk_.leftEnd(inside_line)) % 2 != 0;
}

std::uint32_t BoustrophedonCells::findAbove(std::uint32_t crossing) const {
  const int steps = lines_ == PassLines::All ? 1 : 2;
  std::uint32_t reached = crossing;
  for (int step = 0; step < steps; ++step) {
    const std::uint32_t next = walk_.next(reached, Vertical::Up);
    if (walk_.lineOf(next) != walk_.lineOf(reached) + 1) return kNoCrossing;
    reached = next;
  }
  return reached;
}

std::uint32_t BoustrophedonCells::stackedOn(std::uint32_t left) const {
  const std::uint32_t on_left = above_[left];
  const std::uint32_t on_right = above_[walk_.otherEnd(left)];
  const bool is_joined = on_left != kNoCrossing && on_right != kNoCrossing && walk_.isLeftEnd(on_left) &&
                         walk_.otherEnd(on_left) == on_right;
  return is_joined ? on_left : kNoCrossing;
}

std::vector<BoustrophedonCell> BoustrophedonCells::ends() const {
  std::vector<BoustrophedonCell> ends;
  ends.reserve(sections_.size());
  for (const std::vector<std::uint32_t>& section : sections_) {
    BoustrophedonCell sides;
    sides.first = {walk_.pointAt(section.front()), walk_.pointAt(walk_.otherEnd(section.front()))};
    sides.last = {walk_.pointAt(section.back()), walk_.pointAt(walk_.otherEnd(section.back()))};
    sides.lines = section.size();
    ends.push_back(sides);
  }
  return ends;
}

PassEntries passesOf(const BoustrophedonCells& sections, const RasterWalk& walk, const SectionTour& tour) {
  PassEntries entries;
  for (const SectionVisit& visit : tour) {
    std::vector<std::uint32_t> lefts = sections.sections()[visit.section];
    if (static_cast<int>(visit.entry) >= 2) std::reverse(lefts.begin(), lefts.end());
    bool enters_right = static_cast<int>(visit.entry) % 2 != 0;
    for (const std::uint32_t left : lefts) {
      entries.push_back(enters_right ? walk.otherEnd(left) : left);
      enters_right = !enters_right;
    }
  }
  return entries;
}

}  // namespace lamina
