// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Numbers of repositions: stops of the deposition between one path and the next, by class. Paths that join
/// end to start need none; build aids such as skirts do not count.
struct Repositions {
  std::size_t to_fill = 0;   ///< class A: from a wall to a path of the fill
  std::size_t in_layer = 0;  ///< class B: any other within a layer, as from one path of the fill to the next
  std::size_t to_layer = 0;  ///< class C: from the last path of a layer to the first of a later layer
};
/// Counts the repositions of a toolpath [Flores2018, section 6.1.2]; all are 0 without layers.
Repositions countRepositions(const Toolpath& toolpath);

}  // namespace lamina
