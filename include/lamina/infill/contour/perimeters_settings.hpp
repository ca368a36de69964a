// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// How each perimeter is made from the next outer perimeter.
enum class PerimeterOffset {
  Robust,   ///< the enclosed area is shrunk: loops split, join and vanish with it
  Normals,  ///< each point is moved along its normal [Flores2018, section 6.2.1]; the loop may cross itself
};

/// In which order perimeters are deposited.
enum class PerimeterOrder {
  OutsideIn,
  InsideOut,
  Alternating,  ///< outside in, and inside out in every other layer
};

/// Where perimeters start.
enum class PerimeterSeam {
  Progressive,  ///< moved along from layer to layer, and from perimeter to perimeter
  Random,       ///< at random places
};

/// Settings of the strategy of N perimeters. Lengths are in pitches.
struct PerimetersSettings {
  int count = 0;  ///< number of perimeters; 0 for as many as fit, with beads in the narrow areas left over
  PerimeterOffset offset = PerimeterOffset::Robust;
  PerimeterOrder order = PerimeterOrder::OutsideIn;
  double first_inset = 0.5;  ///< distance of the outermost centre line from the border
  double end_gap = 0.65;     ///< gap between the end of a perimeter and its start; 0 closes it
  PerimeterSeam seam = PerimeterSeam::Progressive;
  double seam_step = 3.0;  ///< step of the progressive start
  int seed = 1;            ///< seed of the random starts
};

/// Adds the keys perimeters.*.
void describe(SettingsSchema& schema, PerimetersSettings& settings);

}  // namespace lamina
