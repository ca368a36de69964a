// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/optimisation/design_space.hpp"
#include "lamina/study/study.hpp"

namespace lamina {

/// A point of a study's design space that is known before the search.
struct KnownPoint {
  std::string name;  ///< "defaults", or the name of the baseline or published row
  DesignPoint point;
};

/// The points with which a search begins.
struct KnownPoints {
  std::vector<KnownPoint> points;  ///< without repetitions
  /// Names of the points left out, each with the reason why it is no point of the space.
  std::vector<std::string> left_out;
};

/// The known points of a study: the defaults of its settings, the baselines that differ from the study's
/// settings in variables only, and the published rows that state all variables. A study of commands or of a
/// table has published rows only.
/// @throws InvalidConfig, FileError if the settings of the study cannot be read
KnownPoints knownPointsOf(const Study& study);

}  // namespace lamina
