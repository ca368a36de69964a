// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/job/voids/drop_void_job.hpp"
#include "lamina/voids/drops/disc_coverage.hpp"

namespace lamina {

/// The effect that filling voids at one allowed overlap would have on a program of drops. The uncovered areas
/// are those of the whole inside, with the pores of the pattern: they can be compared between overlaps,
/// whereas the voids found differ with the overlap.
struct DropSweepStep {
  double overlap = 0.0;   ///< the allowed overlap
  std::size_t voids = 0;  ///< number of voids found
  OverlapReading reading;
  double inside_mm2 = 0.0;  ///< area within the contours of all layers, measured as `before` and `after` are
  DiscCoverage before;      ///< sums over all layers; the largest void is that of any layer
  DiscCoverage after;
  bool is_worth_it = false;
};

/// Tries allowed overlaps from 0 to 0.4 in steps of 0.05, to choose one before printing [Sobreviela2014,
/// section 6.1]; all other settings stay.
/// @throws InvalidProgram as `reportDropVoids`; Cancelled
std::vector<DropSweepStep> sweepDropVoids(const DropProgram& program, const DropVoidSettings& settings,
                                          Progress& progress);

/// Uncovered share of the area within the contours [%]; 0 if there is none.
/// @param coverage  `before` or `after` of the step
double uncoveredPercent(const DropSweepStep& step, const DiscCoverage& coverage);

/// The table as text: a line of names, then one line per step.
std::string sweepCsv(const std::vector<DropSweepStep>& steps);

}  // namespace lamina
