// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/job/voids/void_job.hpp"
#include "lamina/voids/beads/refill.hpp"
#include "lamina/voids/beads/void_totals.hpp"

namespace lamina {

/// One request: fill the voids of a program of beads.
struct VoidFillingJob {
  std::string program;  ///< path of a .gcode file
  std::string output;   ///< file to write; empty for none
  VoidJob map;          ///< the part, and how its voids are found
  RefillSettings refill;
};

/// What filling voids gave.
struct VoidFillingReport {
  std::size_t runs = 0;           ///< that were added
  std::size_t layers = 0;         ///< to which they were added
  double deposited_mm3 = 0.0;     ///< by them
  double open_mm3 = 0.0;          ///< of sparse infill and hollow parts, which stay open
  std::vector<LayerVoids> found;  ///< before, layer by layer
  VoidTotals before;
  VoidTotals after;  ///< as read from the new program
};

/// Adds runs along the voids of each layer at its end; see `insertRuns`. A sparse infill stays sparse
/// (`withoutOpenInfill`). They are deposited as
/// `feed.infill_mm_s` (the first layer no faster than `feed.first_layer_mm_s`), `travel.*` and `program.*` of
/// the settings say.
/// @throws FileError, InvalidProgram, InvalidMesh; InvalidInput if output and input are the same file, if the
/// program lacks layers of the part, or if the part does not belong to the program or not there: more than a
/// fifth of the deposit lies outside of it, or its layers are much larger than their deposit, or hardly
/// covered along their border; Unreachable if a new run leaves both the machine's reach and what the program
/// reaches; Cancelled
VoidFillingReport runVoidFillingJob(const VoidFillingJob& job, Progress& progress);

}  // namespace lamina
