// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/slicing/volumetric/head_room.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Number of a part's travels that were changed to pass over what is deposited, and of those that could not
/// be.
struct TravelsOverPart {
  std::size_t travels = 0;
  std::size_t led_round = 0;  ///< travels that would have passed through the part or the bed
  std::size_t shut = 0;       ///< travels among these for which no path was found; left unchanged
};

/// Replaces travels on which the head would be in the bed or the part: the nozzle goes out along the tool
/// axis until it can turn upright and rise without collision, passes over everything, and comes down and in
/// likewise.
/// @param toolpath   whose travels are changed
/// @param growth_mm  growth deposited up to and including each layer
/// @param hop_mm     height of the passage above the highest material
/// @throws Cancelled
TravelsOverPart leadTravels(Toolpath& toolpath, const std::vector<double>& growth_mm, const HeadRoom& room,
                            double hop_mm, Progress& progress);

}  // namespace lamina
