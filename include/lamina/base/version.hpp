// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace lamina {

/// Version of the package: "0.1.0".
std::string laminaVersion();

}  // namespace lamina
