// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/job/voids/drop_void_job.hpp"
#include "lamina/voids/drops/disc_coverage.hpp"

namespace lamina {

/// What one allowed overlap would do to a program of drops. The area left uncovered is that of the whole
/// inside, pores of the pattern too, so that degrees can be compared: each sees other voids.
struct DropSweepStep {
  double overlap = 0.0;  ///< allowed
  std::size_t voids = 0;
  OverlapReading reading;
  double inside_mm2 = 0.0;  ///< area within the contours, as the next two look at it
  DiscCoverage before;      ///< of all layers; the largest of any of them
  DiscCoverage after;
  bool is_worth_it = false;
};

/// Tries allowed overlaps from 0 to 0.4 by 0.05, so that a degree can be chosen before anything is printed
/// [Sobreviela2014, section 6.1]; all other settings stay.
/// @throws InvalidProgram as `reportDropVoids`; Cancelled
std::vector<DropSweepStep> sweepDropVoids(const DropProgram& program, const DropVoidSettings& settings,
                                          Progress& progress);

/// Of the area within the contours [%]; 0 if there is none.
/// @param coverage  the step's, before or after
double uncoveredPercent(const DropSweepStep& step, const DiscCoverage& coverage);

/// The table as text: a line of names, then one line per step.
std::string sweepCsv(const std::vector<DropSweepStep>& steps);

}  // namespace lamina
