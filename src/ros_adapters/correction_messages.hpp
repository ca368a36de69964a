// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "lamina/control/correction_map.hpp"
#include "lamina/control/run/missed_map.hpp"
#include "messages.hpp"

namespace lamina {

/// The message of a map, with an empty header: the publisher sets the time stamp. Lengths are rounded to 40
/// bits of their mantissa: conversion to metres and back does not change them. The digest is that of the
/// rounded map.
lamina_msgs::CorrectionMap toMessage(const CorrectionMap& map);

/// The map of a message; its `digestOf` is the message's digest.
/// @throws InvalidInput as `validate`; if a path does not have as many speeds or heights as amounts, or the
///   digest does not fit the values
CorrectionMap toCore(const lamina_msgs::CorrectionMap& message);

/// The message on how the map of a layer was applied, with an empty header.
/// @param digest  digest of the map by which the layer is deposited from `missed.held_from` on; empty if
///   there is none
lamina_msgs::AppliedCorrection toMessage(const MissedMap& missed, const std::string& toolpath_id,
                                         const std::string& digest);

/// What the machine missed of a layer's map. If it missed nothing, the map holds from the beginning. Nothing
/// if a later map of the layer is not used.
std::optional<MissedMap> missedOf(const lamina_msgs::AppliedCorrection& message);

/// The report on the first layer of a plan that is refused, to be sent under the plan's identity.
MissedMap refusedPlan(const std::string& reason);

/// Whether a message on a plan's layer reports that the plan is refused: the layer is deposited as planned,
/// without a wait, from the plan's first layer on.
bool isRefusalOfPlan(const lamina_msgs::AppliedCorrection& message);

}  // namespace lamina
