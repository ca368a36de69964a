// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/cell/host_datagram.hpp"

#include <cmath>
#include <cstring>

namespace lamina {
namespace {

constexpr std::string_view kMark = "LMHW";
constexpr char kVersion = 1;

void appendBigEndian(std::string& bytes, std::uint64_t value, int count) {
  for (int i = count - 1; i >= 0; --i) bytes += static_cast<char>(value >> (8 * i) & 0xFFU);
}

void appendTime(std::string& bytes, double time_s) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &time_s, sizeof bits);
  appendBigEndian(bytes, bits, 8);
}

std::uint64_t bigEndian(std::string_view bytes) {
  std::uint64_t value = 0;
  for (const char byte : bytes) value = value << 8U | static_cast<unsigned char>(byte);
  return value;
}

double timeFrom(std::string_view bytes) {
  const std::uint64_t bits = bigEndian(bytes);
  double time_s = 0.0;
  std::memcpy(&time_s, &bits, sizeof time_s);
  return time_s;
}

}  // namespace

std::string encoded(const HostDatagram& datagram) {
  std::string bytes(kMark);
  bytes += kVersion;
  bytes += static_cast<char>(datagram.kind);
  bytes.append(2, '\0');
  appendBigEndian(bytes, datagram.sequence, 4);
  appendTime(bytes, datagram.received_s);
  appendTime(bytes, datagram.answered_s);
  return bytes;
}

std::optional<HostDatagram> hostDatagramIn(std::string_view bytes) {
  if (bytes.size() != kHostDatagramBytes || bytes.substr(0, 4) != kMark || bytes[4] != kVersion)
    return std::nullopt;
  const auto kind = static_cast<unsigned char>(bytes[5]);
  if (kind != 1 && kind != 2) return std::nullopt;
  HostDatagram datagram;
  datagram.kind = static_cast<HostDatagramKind>(kind);
  datagram.sequence = static_cast<std::uint32_t>(bigEndian(bytes.substr(8, 4)));
  datagram.received_s = timeFrom(bytes.substr(12, 8));
  datagram.answered_s = timeFrom(bytes.substr(20, 8));
  if (!std::isfinite(datagram.received_s) || !std::isfinite(datagram.answered_s)) return std::nullopt;
  return datagram;
}

}  // namespace lamina
