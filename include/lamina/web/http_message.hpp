// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace lamina {

enum class HttpMethod : std::uint8_t { Get, Post, Delete, Other };

/// Where a connection comes from, and how.
struct HttpPeer {
  std::string address;        ///< "192.168.1.20"
  bool is_local = false;      ///< the loopback interface
  bool is_encrypted = false;  ///< TLS
};

/// A request before its body.
struct HttpHead {
  HttpMethod method = HttpMethod::Get;
  std::string target;                          ///< as sent: "/api/v1/jobs?from=3"
  std::map<std::string, std::string> headers;  ///< by name in small letters
  HttpPeer peer;

  /// The value of a header; empty if it is missing.
  std::string header(const std::string& name) const;
};

/// What came of an upload: a file on the disk, and the fields beside it.
struct ReceivedUpload {
  std::string path;  ///< of the file; empty if the form had none
  std::string name;  ///< made safe (`safeFileName`)
  std::uint64_t bytes = 0;
  std::string sha256;
  std::map<std::string, std::string> fields;
};

struct WebRequest {
  HttpHead head;
  std::string body;       ///< empty for uploads
  ReceivedUpload upload;  ///< of requests that are one
};

struct WebResponse {
  int status = 200;
  std::string body;
  std::string type = "application/json";
  std::vector<std::pair<std::string, std::string>> headers = {};
  std::string note = {};  ///< what was asked for, for the audit; not sent
};

/// A target taken apart.
struct HttpTarget {
  std::vector<std::string> segments;         ///< of the path, decoded; none for "/"
  std::map<std::string, std::string> query;  ///< the last of equal names
};

/// The parts of a target; nothing if it is not a plain path: a segment is empty, "." or "..", holds a slash,
/// backslash, control character or bad percent code once decoded, or there are more than 16.
std::optional<HttpTarget> parsedTarget(std::string_view target);

/// The value of a cookie in the header `Cookie`; empty if it is missing.
std::string cookieValue(std::string_view header, std::string_view name);

/// The name of a host header or origin: without scheme and port, in small letters. "[::1]:80" gives "::1".
std::string hostName(std::string_view authority);

/// Words of a status: "Not Found".
const char* reasonOf(int status);

}  // namespace lamina
