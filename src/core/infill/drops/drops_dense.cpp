// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/drops/drops_dense.hpp"

#include <cmath>

#include "infill/drops/drop_fill.hpp"

namespace lamina {
namespace {

const double kRowPerPitch = 0.5 * std::sqrt(3.0);

/// Places of a lattice that is shifted in odd rows.
std::vector<double> latticePlaces(std::int64_t row, double left, double right, double pitch) {
  const double shift = row % 2 == 0 ? 0.0 : 0.5;
  std::vector<double> places;
  for (double i = std::ceil(left / pitch - shift); (i + shift) * pitch <= right; ++i)
    places.push_back((i + shift) * pitch);
  return places;
}

}  // namespace

std::vector<FillPath> dropsDense(const Regions& regions, const InfillRequest& request) {
  const double pitch = request.settings.drops.pitch_mm;
  return contoursAndLines(regions, request, kRowPerPitch * pitch,
                          [pitch](std::int64_t row, double left, double right) {
                            return latticePlaces(row, left, right, pitch);
                          });
}

}  // namespace lamina
