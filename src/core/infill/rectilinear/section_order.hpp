// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/infill/rectilinear/raster_settings.hpp"

namespace lamina {

/// The ends of a section of a raster, which decide the travel between sections. A section is deposited line
/// by line, to and fro, without a jump.
struct BoustrophedonCell {
  std::array<Point2, 2> first;  ///< left and right end of its first line
  std::array<Point2, 2> last;   ///< left and right end of its last line
  std::size_t lines = 1;
};

/// The end at which a section is entered; the number of its lines then fixes the end at which it is left.
enum class SectionEntry { FirstLeft = 0, FirstRight = 1, LastLeft = 2, LastRight = 3 };

struct SectionVisit {
  std::size_t section = 0;
  SectionEntry entry = SectionEntry::FirstLeft;
};

/// Every section once, in the order deposited.
using SectionTour = std::vector<SectionVisit>;

Point2 entryPoint(const BoustrophedonCell& section, SectionEntry entry);

/// The end at which a section is left after entering at `entry`. Entering at the returned end traverses the
/// section in reverse.
SectionEntry exitOf(const BoustrophedonCell& section, SectionEntry entry);

/// Length of the travels between sections [mm], without the travel to the first one.
double travelLength(const std::vector<BoustrophedonCell>& sections, const SectionTour& tour);

/// The sections as given, each entered at the left end of its first line.
SectionTour tourAsGiven(const std::vector<BoustrophedonCell>& sections);

/// Greedy tour by midpoints [Flores2018, figures 52 and 53]. It starts with the first section given. From the
/// midpoint of the line just deposited it continues with the section whose first or last line has the nearest
/// midpoint; the section is reversed if that is its last line. Takes quadratic time.
SectionTour tourByMidpoints(const std::vector<BoustrophedonCell>& sections);

/// Greedy tour by ends: from `start` on, it always continues at the nearest end of a first or last line.
SectionTour tourByEnds(const std::vector<BoustrophedonCell>& sections, const Point2& start);

/// `tourByEnds`, improved as long as a move shortens the travel from `start`: reversing a stretch (2-opt) or
/// moving a section (or-opt), both within a window of 64 places, or entering a section at another end. Never
/// longer than `tourByEnds`, the travel to the first section included.
SectionTour improvedTour(const std::vector<BoustrophedonCell>& sections, const Point2& start);

/// The shortest tour from `start`, by dynamic programming over subsets.
/// @throws InvalidInput for more than 12 sections
SectionTour shortestTour(const std::vector<BoustrophedonCell>& sections, const Point2& start);

SectionTour tourOf(const std::vector<BoustrophedonCell>& sections, const Point2& start, SectionOrder order);

/// Travel of each of the orders, for comparison in reports [mm], without the travel to the first section.
struct SectionTravels {
  double as_given = 0.0;
  double midpoints = 0.0;
  double ends = 0.0;
  double optimised = 0.0;
};
SectionTravels sectionTravels(const std::vector<BoustrophedonCell>& sections, const Point2& start);

}  // namespace lamina
