// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/control/correction_map.hpp"
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

}  // namespace lamina
