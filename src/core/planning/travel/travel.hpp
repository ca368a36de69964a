// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <optional>

#include "lamina/planning/plan_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// What lies under a travel.
enum class TravelOver {
  Anything,
  Infill,  ///< nothing but the inside of the part, where threads do not show
};

/// The motion without deposition from one point to another, none if they are the same. In the plane it is
/// straight up to the threshold, and at any length over infill. Otherwise it is retracted and goes up by the
/// hop, over, and down. To another height it first goes to the greater of both, plus the hop if it is
/// retracted.
std::optional<Path> makeTravel(const Point3& from, const Point3& to, const TravelSettings& settings,
                               TravelOver over = TravelOver::Anything);

/// Makes the motion without deposition from the end of a path to the start of the next, which is of that
/// layer; none if they join.
using TravelMaker = std::function<std::optional<Path>(const Path& from, const Path& to, std::size_t layer)>;

/// That of `makeTravel`, over anything.
TravelMaker levelTravels(const TravelSettings& settings);

}  // namespace lamina
