// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/slicing/volumetric/head_room.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Travels of a part over what was deposited before.
struct TravelsOverPart {
  std::size_t travels = 0;
  std::size_t led_round = 0;  ///< that would have gone through the part, or the bed
  std::size_t shut = 0;       ///< of those, for which no way was found: they stay as they were
};

/// Leads travels on which the head would be in bed or part another way: out along the tool axis as far as it
/// takes to turn upright and go up clear of everything, over all of it, and down and in likewise.
///
/// @param toolpath   its travels are changed
/// @param growth_mm  deposited once each of its layers is
/// @param hop_mm     above what is highest
/// @throws Cancelled
TravelsOverPart leadTravels(Toolpath& toolpath, const std::vector<double>& growth_mm, const HeadRoom& room,
                            double hop_mm, Progress& progress);

}  // namespace lamina
