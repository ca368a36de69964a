// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "lamina/control/correction_map.hpp"
#include "lamina/control/run/missed_map.hpp"
#include "messages.hpp"

namespace lamina {

/// The message with an empty header: the stamp belongs to the publisher. Lengths keep 40 bits of their
/// mantissa, so that they are the same after the way through metres; the digest is that of the map so
/// rounded.
lamina_msgs::CorrectionMap toMessage(const CorrectionMap& map);

/// The map of a message, of which `digestOf` is the message's digest.
/// @throws InvalidInput as `validate`; if a path has not as many speeds or heights as amounts, or the digest
///   is not that of the values
CorrectionMap toCore(const lamina_msgs::CorrectionMap& message);

/// What became of the map of a layer, with an empty header.
/// @param digest  of the map that the layer is deposited by, from `missed.held_from` on; empty where by none
lamina_msgs::AppliedCorrection toMessage(const MissedMap& missed, const std::string& toolpath_id,
                                         const std::string& digest);

/// What the machine did not have of a layer's map: of one that it had all of, it holds from the beginning.
/// Nothing where a later map of the layer is not used.
std::optional<MissedMap> missedOf(const lamina_msgs::AppliedCorrection& message);

/// What is reported of the first layer of a plan that is not gone on with, under the plan's identity.
MissedMap refusedPlan(const std::string& reason);

/// Whether a message of a plan says that the plan is not gone on with: as planned, without a wait, from its
/// first layer on.
bool isRefusalOfPlan(const lamina_msgs::AppliedCorrection& message);

}  // namespace lamina
