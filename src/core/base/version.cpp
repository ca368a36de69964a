// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/base/version.hpp"

namespace lamina {

std::string laminaVersion() { return LAMINA_VERSION; }

}  // namespace lamina
