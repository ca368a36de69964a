// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

namespace lamina {

/// A mode that a part may be sliced by, and what it would give: of one that refuses the part nothing, of one
/// whose layers the machine cannot run the same as of others.
struct ModeCandidate {
  std::string mode;
  std::string refusal;               ///< why it is not to be had; empty if it is
  double unsupported_percent = 0.0;  ///< of the whole surface: overhangs its own layers by more than is taken
  std::size_t steps = 1;  ///< pieces printed along one direction; each bent layer is one of its own
  std::size_t layers = 0;
  double time_s = 0.0;  ///< of printing, at the tip
};

}  // namespace lamina
