// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/program/drops/drop_program.hpp"
#include "lamina/toolpath/toolpath.hpp"
#include "lamina/voids/beads/overlap_meter.hpp"
#include "lamina/voids/drops/drop_filling.hpp"
#include "lamina/voids/drops/drop_layer.hpp"

namespace lamina {

/// Report on the voids between the drops of a program or toolpath, and on how they were filled.
struct DropVoidReport {
  double diameter_mm = 0.0;                  ///< diameter of a drop
  std::vector<std::vector<DropVoid>> voids;  ///< of each layer
  std::vector<double> heights_mm;            ///< height of each layer's drops; empty for a toolpath
  OverlapReading overlap;
  /// Number of layers without a contour, which are left as they are, since their inside is not known.
  std::size_t layers_without_contour = 0;
  bool is_worth_it = false;  ///< see DropVoidSettings::least_share

  std::size_t count() const;
  double uncoveredBefore() const;  ///< [mm²], of all voids
  double uncoveredAfter() const;
  double largestBefore() const;
  double largestAfter() const;
  std::map<VoidClass, std::size_t> countByClass() const;
};

/// A program of drops with its voids filled, and the report on them.
struct FilledDropProgram {
  std::string text;
  DropVoidReport report;
};

/// The layers of a program as needed for the search of voids: chains of drops, by the roles that the program
/// states, or by guessed roles if it states none. A chain that is back at its start ends there if the next
/// drop is farther away than two diameters and two steps.
/// @throws InvalidProgram if the program deposits no drop, or its header states no diameter
std::vector<DropLayer> dropLayers(const DropProgram& program);

/// Fills the voids of each layer of a program of drops, independently of other layers.
/// @throws InvalidProgram if the program deposits no drop, its header states no diameter, or lines cannot be
///   added to it
/// @throws Cancelled
FilledDropProgram fillDropProgram(const DropProgram& program, const DropVoidSettings& settings,
                                  const DropDialect& dialect, Progress& progress);

/// The report that filling would give, without writing anything.
/// @throws InvalidProgram as `dropLayers`; Cancelled
DropVoidReport reportDropVoids(const DropProgram& program, const DropVoidSettings& settings,
                               Progress& progress);

/// Fills the voids between the drops of a toolpath. The new drops of a layer are a run at its end, with
/// travels to it and back. Paths of beads stay as they are.
/// @throws InvalidInput if the layers are inclined; Cancelled
Toolpath withDropVoidsFilled(Toolpath toolpath, const DropVoidSettings& settings, double travel_feed_mm_s,
                             Progress& progress);

}  // namespace lamina
