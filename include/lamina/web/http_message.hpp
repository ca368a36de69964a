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

/// The client's end of a connection.
struct HttpPeer {
  std::string address;        ///< "192.168.1.20"
  bool is_local = false;      ///< through the loopback interface
  bool is_encrypted = false;  ///< by TLS
};

/// The head of a request: what is sent before its body.
struct HttpHead {
  HttpMethod method = HttpMethod::Get;
  std::string target;                          ///< as sent: "/api/v1/jobs?from=3"
  std::map<std::string, std::string> headers;  ///< by name in lower case
  HttpPeer peer;

  /// The value of a header; empty if it is missing.
  std::string header(const std::string& name) const;
};

/// A received upload: a file on the disk, and the other fields of the form.
struct ReceivedUpload {
  std::string path;  ///< of the file on the disk; empty if the form had none
  std::string name;  ///< file name made safe (`safeFileName`)
  std::uint64_t bytes = 0;
  std::string sha256;
  std::map<std::string, std::string> fields;
};

struct WebRequest {
  HttpHead head;
  std::string body;       ///< empty for uploads
  ReceivedUpload upload;  ///< only of requests that are uploads
};

struct WebResponse {
  int status = 200;
  std::string body;
  std::string type = "application/json";
  std::vector<std::pair<std::string, std::string>> headers = {};
  std::string note = {};   ///< description of the order for the audit; not sent
  bool is_audited = true;  ///< whether the audit gets a row of an order that was carried out
};

/// The parts of a request's target.
struct HttpTarget {
  std::vector<std::string> segments;         ///< of the path, decoded; none for "/"
  std::map<std::string, std::string> query;  ///< by name; of equal names the last value
};

/// Splits a target into its parts; nothing if it is not a plain path: if a decoded segment is empty, "." or
/// "..", or holds a slash, a backslash, a control character or an invalid percent code, or if there are more
/// than 16 segments.
std::optional<HttpTarget> parsedTarget(std::string_view target);

/// The value of a cookie in the header `Cookie`; empty if it is missing.
std::string cookieValue(std::string_view header, std::string_view name);

/// The host name in a `Host` or `Origin` header: without scheme and port number, in lower case. "[::1]:80"
/// gives "::1".
std::string hostName(std::string_view authority);

/// The reason phrase of a status: "Not Found".
const char* reasonOf(int status);

}  // namespace lamina
