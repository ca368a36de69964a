// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace lamina {

/// Whether a host stands for the loopback interface: "localhost", an address from 127.0.0.0/8, also within
/// IPv6, "::1", "[::1]". Other names do not, whatever they begin with or lead to.
bool isLoopbackHost(const std::string& host);

}  // namespace lamina
