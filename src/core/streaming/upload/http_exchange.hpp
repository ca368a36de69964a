// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace lamina {

/// A request to a print server. Its body is `head`, the program if it is sent, and `tail`.
struct HttpRequest {
  std::string method = "GET";
  std::string target;  ///< path and query, escaped; may hold a password and so must not be quoted
  std::vector<std::pair<std::string, std::string>> headers = {};
  std::string head = {};
  bool sends_program = false;
  std::string tail = {};
  bool digests_answer = false;  ///< whether only size and checksum of the answer are kept
  double timeout_s = 5.0;       ///< longest time without a byte in either direction
};

struct HttpResponse {
  int status = 0;
  std::string body;
  std::uint64_t digested_bytes = 0;  ///< size of an answer of which only the digest is kept
  std::uint32_t digested_crc32 = 0;
};

/// Why there is no response.
struct HttpFailure {
  std::string why;
  bool reached_server = true;  ///< false only if certainly no byte of the request has arrived
};

/// A text escaped for a query or path: every byte but ASCII letters, digits and "-._~/" as % and two
/// hexadecimal digits. The digits are capitals, as RepRapFirmware reads no others.
std::string escapedForUrl(const std::string& text);

}  // namespace lamina
