// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// How often a process that fills contours must stop depositing, by what for. Runs that join end to start
/// need no stop; skirts do not count.
struct Repositions {
  std::size_t to_fill = 0;  ///< class A: from a wall to a run of the fill
  std::size_t in_layer =
      0;  ///< class B: any other within a layer, such as from one run of the fill to the next
  std::size_t to_layer = 0;  ///< class C: from the last run of a layer to the first one of a later layer
};

/// Counts them [Flores2018, section 6.1.2]. No layer gives none.
Repositions countRepositions(const Toolpath& toolpath);

}  // namespace lamina
