// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <optional>

#include "lamina/planning/plan_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// The area that a travel crosses.
enum class TravelOver {
  Anything,
  Infill,  ///< the inside of the part only, where strings do not show
};

/// The travel from one point to another; none if they are the same. If it is not retracted (`isRetracted`) it
/// is straight in the plane. If it is, it goes up by the hop, over, and down. Between different heights it
/// first rises to the greater one, plus the hop if it is retracted.
std::optional<Path> makeTravel(const Point3& from, const Point3& to, const TravelSettings& settings,
                               TravelOver over = TravelOver::Anything);

/// Makes the travel from the end of a path to the start of the next one, which belongs to that layer; none if
/// they join.
using TravelMaker = std::function<std::optional<Path>(const Path& from, const Path& to, std::size_t layer)>;

/// Makes travels by `makeTravel`, over anything.
TravelMaker levelTravels(const TravelSettings& settings);

}  // namespace lamina
