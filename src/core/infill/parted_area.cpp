// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/parted_area.hpp"

#include <utility>

#include "lamina/geometry/offset.hpp"

namespace lamina {
namespace {

/// Wide is where a disc of this radius fits, in pitches.
constexpr double kWide = 1.5;
/// Of the narrow rest, what is thinner than twice this is left out, in pitches.
constexpr double kHair = 0.1;

}  // namespace

PartedArea partByWidth(const Regions& area, double pitch_mm) {
  const Regions core = offset(area, -kWide * pitch_mm);
  if (core.empty()) return {{}, area};
  const Regions grown = offset(core, kWide * pitch_mm);
  // Rounding leaves hairs along the border: they are cleared away.
  const Regions narrow = offset(difference(area, grown), -kHair * pitch_mm);
  if (narrow.empty()) return {area, {}};
  return {intersection(grown, area), offset(narrow, kHair * pitch_mm)};
}

}  // namespace lamina
