// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/job/drop_void_job.hpp"

namespace lamina {

/// What one allowed overlap would do to a program of drops.
struct DropSweepStep {
  double overlap = 0.0;  ///< allowed
  std::size_t voids = 0;
  OverlapReading reading;
  double uncovered_before_mm2 = 0.0;  ///< of the voids that this overlap lets see
  double uncovered_after_mm2 = 0.0;
  double largest_after_mm2 = 0.0;
  bool is_worth_it = false;
};

/// Tries allowed overlaps from 0 to 0.4 by 0.05, so that a degree can be chosen before anything is printed
/// (droplet-infill.md section 6); all other settings stay.
/// @throws InvalidProgram as `reportDropVoids`; Cancelled
std::vector<DropSweepStep> sweepDropVoids(const DropProgram& program, const DropVoidSettings& settings,
                                          Progress& progress);

/// The table as text: a line of names, then one line per step.
std::string sweepCsv(const std::vector<DropSweepStep>& steps);

}  // namespace lamina
