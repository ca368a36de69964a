// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/infill/rectilinear/raster_settings.hpp"

namespace lamina {

/// What matters of a section of a raster for the travel between sections: lines deposited to and fro, one
/// after the other, without a jump.
struct BoustrophedonCell {
  std::array<Point2, 2> first;  ///< left and right end of its first line
  std::array<Point2, 2> last;   ///< the same of its last line
  std::size_t lines = 1;
};

/// Where a section is entered. The lines between fix where it is left.
enum class SectionEntry { FirstLeft = 0, FirstRight = 1, LastLeft = 2, LastRight = 3 };

struct SectionVisit {
  std::size_t section = 0;
  SectionEntry entry = SectionEntry::FirstLeft;
};

/// Every section once, in the order deposited.
using SectionTour = std::vector<SectionVisit>;

Point2 entryPoint(const BoustrophedonCell& section, SectionEntry entry);

/// The entry that is left at: entering there runs the section backwards.
SectionEntry exitOf(const BoustrophedonCell& section, SectionEntry entry);

/// Length of the jumps between sections [mm]; the way to the first one does not count.
double travelLength(const std::vector<BoustrophedonCell>& sections, const SectionTour& tour);

/// The sections as given, each entered at the left end of its first line.
SectionTour tourAsGiven(const std::vector<BoustrophedonCell>& sections);

/// Greedy by midpoints [Flores2018, figures 52 and 53]: starts with the first section given; from the
/// midpoint of the line just deposited it goes on to the section whose first or last line has the nearest
/// midpoint, run backwards if that is its last. Quadratic time.
SectionTour tourByMidpoints(const std::vector<BoustrophedonCell>& sections);

/// Greedy by ends: goes on at whichever end of a first or last line is nearest, from `start` on. Quadratic
/// time.
SectionTour tourByEnds(const std::vector<BoustrophedonCell>& sections, const Point2& start);

/// `tourByEnds`, improved as long as a move shortens the way that begins at `start`: turning a stretch round
/// (2-opt), moving a section (or-opt), both within a window of 64 places, and entering elsewhere. Never
/// longer than it, the way to the first section included.
SectionTour improvedTour(const std::vector<BoustrophedonCell>& sections, const Point2& start);

/// The shortest tour from `start`, by dynamic programming over subsets.
/// @throws InvalidInput for more than 12 sections
SectionTour shortestTour(const std::vector<BoustrophedonCell>& sections, const Point2& start);

SectionTour tourOf(const std::vector<BoustrophedonCell>& sections, const Point2& start, SectionOrder order);

/// Travel of the orders, to report how far each is from the others [mm], the way to the first section not
/// included.
struct SectionTravels {
  double as_given = 0.0;
  double midpoints = 0.0;
  double ends = 0.0;
  double optimised = 0.0;
};
SectionTravels sectionTravels(const std::vector<BoustrophedonCell>& sections, const Point2& start);

}  // namespace lamina
