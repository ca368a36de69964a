// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/job/voids/void_job.hpp"
#include "lamina/voids/beads/refill.hpp"
#include "lamina/voids/beads/void_totals.hpp"

namespace lamina {

/// A request to fill the voids of a program of beads.
struct VoidFillingJob {
  std::string program;  ///< path of a .gcode file
  std::string output;   ///< file to write; empty for none
  VoidJob map;          ///< the part, and how its voids are found
  RefillSettings refill;
};

/// Report on the voids of a program of beads and on how they were filled.
struct VoidFillingReport {
  std::size_t runs = 0;        ///< number of runs added
  std::size_t layers = 0;      ///< number of layers with added runs
  double deposited_mm3 = 0.0;  ///< volume of the added runs
  /// Volume of the openings of sparse infill and of hollow parts, which are not filled.
  double open_mm3 = 0.0;
  std::vector<LayerVoids> found;  ///< voids before filling, layer by layer
  VoidTotals before;              ///< sums before filling
  VoidTotals after;               ///< sums after filling, measured on the new program
};

/// Fills the voids of a program by runs along them, added at the end of each layer (`insertRuns`). The
/// openings of a sparse infill stay open (`withoutOpenInfill`). Runs are deposited according to
/// `feed.infill_mm_s` (in the first layer no faster than `feed.first_layer_mm_s`), `travel.*` and `program.*`
/// of the settings.
/// @throws FileError, InvalidProgram, InvalidMesh
/// @throws InvalidInput if output and input are the same file, or the program lacks layers of the part; also
///   if the part seems to be another one or to lie elsewhere: more than a fifth of the deposit lies outside
///   of it, its layers are much larger than their deposit, or they are hardly covered along their border
/// @throws Unreachable if a new run leaves both the machine's reach and the bounding box of what the program
///   deposits
/// @throws Cancelled
VoidFillingReport runVoidFillingJob(const VoidFillingJob& job, Progress& progress);

}  // namespace lamina
