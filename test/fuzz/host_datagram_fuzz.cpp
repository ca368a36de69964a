// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Bytes that come to a host's UDP port: refused, or a datagram that is written as it was read.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "lamina/cell/host_datagram.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
  const std::string_view text(reinterpret_cast<const char*>(bytes), count);
  const auto datagram = lamina::hostDatagramIn(text);
  if (!datagram) return 0;
  const auto again = lamina::hostDatagramIn(lamina::encoded(*datagram));
  if (!again || again->sequence != datagram->sequence || again->kind != datagram->kind) std::abort();
  return 0;
}
