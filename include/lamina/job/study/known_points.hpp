// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/optimisation/design_space.hpp"
#include "lamina/study/study.hpp"

namespace lamina {

/// A point of a study's space that is known before anything is searched.
struct KnownPoint {
  std::string name;  ///< "defaults", or that of the baseline or published row
  DesignPoint point;
};

/// What a search begins with.
struct KnownPoints {
  std::vector<KnownPoint> points;     ///< each once
  std::vector<std::string> left_out;  ///< names, and why they are no points of the space
};

/// The points of a study that are known: the defaults of its settings, the baselines whose other settings are
/// those of the study, and the published rows that name all variables. Of commands and tables, published rows
/// alone.
/// @throws InvalidConfig, FileError if the settings of the study cannot be read
KnownPoints knownPointsOf(const Study& study);

}  // namespace lamina
