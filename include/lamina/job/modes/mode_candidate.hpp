// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

namespace lamina {

/// A slicing mode tried for a part, and its result. The figures are 0 if the mode cannot slice the part. They
/// are set if the mode can slice it, but the machine cannot run the layers.
struct ModeCandidate {
  std::string mode;
  std::string refusal;  ///< why the mode cannot be used; empty if it can
  /// Share of the whole surface that overhangs the mode's own layers by more than is allowed.
  double unsupported_percent = 0.0;
  /// Number of pieces printed along one direction; each curved layer is a piece of its own.
  std::size_t steps = 1;
  std::size_t layers = 0;
  double time_s = 0.0;  ///< printing time, within the limits of the nozzle tip
};

}  // namespace lamina
