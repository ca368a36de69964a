// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "network/listening_ports.hpp"

#include <arpa/inet.h>

#include <array>
#include <charconv>
#include <cstring>
#include <optional>
#include <sstream>
#include <string>

namespace lamina {
namespace {

constexpr std::string_view kListening = "0A";
constexpr std::size_t kWordDigits = 8;
constexpr std::uint32_t kLoopbackNetwork = 127;
constexpr std::uint32_t kMappedMark = 0xffff;

template <class Number>
std::optional<Number> numberIn(std::string_view digits, int base) {
  Number number = 0;
  const char* end = digits.data() + digits.size();
  const auto result = std::from_chars(digits.data(), end, number, base);
  if (result.ec != std::errc{} || result.ptr != end) return std::nullopt;
  return number;
}

/// The kernel writes each four bytes of an address as a number of the host's own byte order.
std::vector<std::uint32_t> wordsOf(std::string_view address) {
  std::vector<std::uint32_t> words;
  for (; address.size() >= kWordDigits; address.remove_prefix(kWordDigits)) {
    const auto word = numberIn<std::uint32_t>(address.substr(0, kWordDigits), 16);
    if (!word) return {};
    words.push_back(ntohl(*word));
  }
  return words;
}

bool isLoopback(const std::vector<std::uint32_t>& words) {
  const bool is_in_network = words.back() >> 24 == kLoopbackNetwork;
  if (words.size() == 1) return is_in_network;
  if (words[0] != 0 || words[1] != 0) return false;
  return (words[2] == 0 && words[3] == 1) || (words[2] == kMappedMark && is_in_network);
}

std::optional<ListeningPort> portOf(const std::string& line) {
  std::istringstream columns(line);
  std::array<std::string, 10> column;
  for (std::string& text : column)
    if (!(columns >> text)) return std::nullopt;
  const std::string_view local = column[1];
  const std::size_t colon = local.find(':');
  if (column[3] != kListening || colon == std::string_view::npos) return std::nullopt;
  const std::vector<std::uint32_t> words = wordsOf(local.substr(0, colon));
  const auto port = numberIn<std::uint16_t>(local.substr(colon + 1), 16);
  const auto inode = numberIn<std::uint64_t>(column[9], 10);
  if ((words.size() != 1 && words.size() != 4) || !port || !inode) return std::nullopt;
  return ListeningPort{*port, isLoopback(words), *inode};
}

}  // namespace

std::vector<ListeningPort> listeningPorts(std::string_view table) {
  std::vector<ListeningPort> ports;
  std::istringstream lines{std::string(table)};
  for (std::string line; std::getline(lines, line);)
    if (const auto port = portOf(line)) ports.push_back(*port);
  return ports;
}

}  // namespace lamina
