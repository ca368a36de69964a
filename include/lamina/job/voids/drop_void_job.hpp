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

/// What filling did to a program or toolpath of drops.
struct DropVoidReport {
  double diameter_mm = 0.0;                  ///< of a drop
  std::vector<std::vector<DropVoid>> voids;  ///< of each layer
  std::vector<double> heights_mm;            ///< of the drops of each layer
  OverlapReading overlap;
  std::size_t layers_without_contour = 0;  ///< left alone: what is inside is not known
  bool is_worth_it = false;                ///< see DropVoidSettings::least_share

  std::size_t count() const;
  double uncoveredBefore() const;  ///< [mm²], of all voids
  double uncoveredAfter() const;
  double largestBefore() const;
  double largestAfter() const;
  std::map<VoidClass, std::size_t> countByClass() const;
};

/// A program of drops with its voids filled.
struct FilledDropProgram {
  std::string text;
  DropVoidReport report;
};

/// The layers of the program as voids are searched in them: chains by the roles that the program states, or
/// guessed. A chain back at its start ends where the next drop is farther than two diameters and two steps.
/// @throws InvalidProgram if it lets no drop go, or its header reports no diameter
std::vector<DropLayer> dropLayers(const DropProgram& program);

/// Fills the voids of each layer by itself.
/// @throws InvalidProgram if it lets no drop go, its header reports no diameter, or lines cannot be added to
/// it; Cancelled
FilledDropProgram fillDropProgram(const DropProgram& program, const DropVoidSettings& settings,
                                  const DropDialect& dialect, Progress& progress);

/// What filling would do, without writing anything.
DropVoidReport reportDropVoids(const DropProgram& program, const DropVoidSettings& settings,
                               Progress& progress);

/// A toolpath with its voids between drops filled: behind each layer a run of drops, to which and from which
/// it travels. Paths of beads stay as they are.
/// @throws InvalidInput if the layers are inclined; Cancelled
Toolpath withDropVoidsFilled(Toolpath toolpath, const DropVoidSettings& settings, double travel_feed_mm_s,
                             Progress& progress);

}  // namespace lamina
