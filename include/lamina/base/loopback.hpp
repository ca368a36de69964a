// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace lamina {

/// Whether a host is the loopback interface: "localhost", "::1", "[::1]", or an IPv4 address from
/// 127.0.0.0/8, also as a mapped IPv6 address. Other names are not, even if they begin like one of these or
/// resolve to one.
bool isLoopbackHost(const std::string& host);

}  // namespace lamina
