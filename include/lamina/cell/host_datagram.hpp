// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace lamina {

enum class HostDatagramKind : std::uint8_t { Question = 1, Answer = 2 };

/// What the hosts of a cell send each other over UDP. Numbers are big-endian, times are double:
/// "LMHW", version 1, kind, two bytes 0, sequence (4 bytes), time of receipt, time of the answer (0 in a
/// question). A question and its answer are equally long, so that nobody is made to send more than was asked.
struct HostDatagram {
  HostDatagramKind kind = HostDatagramKind::Question;
  std::uint32_t sequence = 0;  ///< of the question
  double received_s = 0.0;     ///< by the clock of who answers, since 1970
  double answered_s = 0.0;
};

constexpr std::size_t kHostDatagramBytes = 28;

std::string encoded(const HostDatagram& datagram);

/// @return nothing if the bytes are no datagram of this version
std::optional<HostDatagram> hostDatagramIn(std::string_view bytes);

}  // namespace lamina
