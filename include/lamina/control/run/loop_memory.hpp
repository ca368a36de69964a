// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "lamina/control/height_loop.hpp"
#include "lamina/control/part_learning.hpp"
#include "lamina/control/supervision.hpp"

namespace lamina {

/// The state of the loop after a layer. A loop that resumes with it gives the same results as one that was
/// not interrupted, to the last bit.
struct LoopMemory {
  PartIdentity identity;  ///< of the print; its `program` is the id of the toolpath
  std::size_t layer = 0;  ///< number of the last layer that is done
  LoopStatus status;
  double gain_at_check = 1.0;  ///< mean gain at the last check of stability
  double last_amount = 0.0;    ///< amount deposited at the end of the layer
  double mean_shift_mm = 0.0;  ///< mean shift of the nozzle over the layer
  StoredHeights heights;       ///< of the layer's cells
  std::optional<RaisedAlarm> last_alarm = {};
  std::vector<RaisedAlarm> standing = {};  ///< conditions that stand, each of another number
};

/// The state as YAML, which `memoryFromYaml` reads back to the same bits.
std::string toYaml(const LoopMemory& memory);

/// Reads a state strictly: exactly the known keys, numbers within bounds, and lists of one value per cell.
/// @param source  names the text in errors
/// @throws InvalidConfig naming the source of text that is no YAML, or of lists of unequal lengths; the key
///   of anything else
LoopMemory memoryFromYaml(const std::string& yaml, const std::string& source);

/// Reads a state from a file.
/// @throws FileError if it cannot be read; InvalidConfig as `memoryFromYaml`
LoopMemory readLoopMemory(const std::string& path);

/// Writes a state to a file: completely, or leaving the file as it was.
/// @throws FileError if it cannot be written
void writeLoopMemory(const std::string& path, const LoopMemory& memory);

}  // namespace lamina
