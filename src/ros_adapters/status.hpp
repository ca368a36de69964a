// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/error.hpp"
#include "messages.hpp"

namespace lamina {

/// The failure as a status message; code and message are empty for success.
lamina_msgs::Status toMessage(const Failure& failure);

/// The failure of a status message.
/// @throws InvalidInput if the code is no code of Status.msg
Failure fromMessage(const lamina_msgs::Status& status);

/// Does nothing if the status is OK.
/// @throws Error with the code and message of the status
void throwIfFailed(const lamina_msgs::Status& status);

}  // namespace lamina
