// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace lamina {

enum class HostDatagramKind : std::uint8_t { Question = 1, Answer = 2 };

/// The datagram that the hosts of a cell send each other over UDP. Its 28 bytes are "LMHW", version (1),
/// kind, two bytes 0, sequence (4 bytes), time of receipt and time of answer (both 0 in a question); numbers
/// are big-endian, times are doubles. A question and its answer have the same length, so that a host cannot
/// be made to send more than it receives.
struct HostDatagram {
  HostDatagramKind kind = HostDatagramKind::Question;
  std::uint32_t sequence = 0;  ///< number of the question
  double received_s = 0.0;     ///< time of receipt by the clock of the answering host, since 1970
  double answered_s = 0.0;     ///< time of the answer by the same clock
};

constexpr std::size_t kHostDatagramBytes = 28;

std::string encoded(const HostDatagram& datagram);

/// Decodes a datagram.
/// @return nothing if the bytes are no datagram of this version
std::optional<HostDatagram> hostDatagramIn(std::string_view bytes);

}  // namespace lamina
