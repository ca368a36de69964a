// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

#include "lamina/control/height_loop.hpp"
#include "lamina/control/part_learning.hpp"
#include "lamina/control/supervision.hpp"

namespace lamina {

/// The state of the loop after a layer, from which it goes on with the same bits.
struct LoopMemory {
  PartIdentity identity;  ///< the program is the toolpath's id
  std::size_t layer = 0;  ///< the last one done
  LoopStatus status;
  double gain_at_check = 1.0;
  double last_amount = 0.0;    ///< amount at the end of the layer
  double mean_shift_mm = 0.0;  ///< mean shift of the nozzle over the layer
  StoredHeights heights;       ///< of the layer's cells
};

/// The state as YAML, which `memoryFromYaml` reads back to the same bits.
std::string toYaml(const LoopMemory& memory);

/// Reads a state strictly: all keys and no others, all numbers within bounds, one value of each kind per
/// cell.
/// @throws InvalidConfig naming the source and the key
LoopMemory memoryFromYaml(const std::string& yaml, const std::string& source);

/// @throws FileError; InvalidConfig as above
LoopMemory readLoopMemory(const std::string& path);

/// Writes the file whole, or leaves what was there.
/// @throws FileError
void writeLoopMemory(const std::string& path, const LoopMemory& memory);

}  // namespace lamina
