// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "lamina/geometry/vector.hpp"
#include "markers/toolpath_markers.hpp"

namespace lamina {

/// The largest program that is drawn [bytes].
inline constexpr std::size_t kLargestDrawn = std::size_t{256} << 20U;

/// A program as it is drawn.
struct DrawnPart {
  std::vector<MarkerChunk> chunks;
  std::vector<PathRole> roles;  ///< that occur, in the order of their values
  std::size_t layers = 0;
  Box3 box;             ///< of what is deposited [mm]
  std::string failure;  ///< why it cannot be drawn; empty if it can
};

/// Reads a program of any slicer.
/// @param frame  that its coordinates are given in
/// @param is_cancelled  set from any thread; the part is then empty
DrawnPart drawProgram(const std::string& path, const std::string& frame,
                      const std::atomic<bool>& is_cancelled);

}  // namespace lamina
