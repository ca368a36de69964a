// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/web/http_message.hpp"

#include <algorithm>
#include <array>

#include "lamina/base/percent_encoding.hpp"
#include "lamina/base/text.hpp"

namespace lamina {
namespace {

constexpr std::size_t kMostSegments = 16;

bool isControl(char character) { return static_cast<unsigned char>(character) < 0x20 || character == 0x7f; }

bool isPlainSegment(const std::string& segment) {
  if (segment.empty() || segment == "." || segment == "..") return false;
  return std::none_of(segment.begin(), segment.end(), [](char character) {
    return character == '/' || character == '\\' || isControl(character);
  });
}

/// The pieces of a text between separators; one empty piece for an empty text.
std::vector<std::string_view> pieces(std::string_view text, char separator) {
  std::vector<std::string_view> found;
  while (true) {
    const std::size_t end = text.find(separator);
    found.push_back(text.substr(0, end));
    if (end == std::string_view::npos) return found;
    text.remove_prefix(end + 1);
  }
}

std::optional<std::map<std::string, std::string>> parsedQuery(std::string_view text) {
  std::map<std::string, std::string> query;
  for (const std::string_view piece : pieces(text, '&')) {
    if (piece.empty()) continue;
    const std::size_t equals = piece.find('=');
    const auto name = percentDecoded(piece.substr(0, equals));
    const auto value = percentDecoded(equals == std::string_view::npos ? "" : piece.substr(equals + 1));
    if (!name || !value) return std::nullopt;
    query[*name] = *value;
  }
  return query;
}

}  // namespace

std::string HttpHead::header(const std::string& name) const {
  const auto found = headers.find(name);
  return found == headers.end() ? "" : found->second;
}

std::optional<HttpTarget> parsedTarget(std::string_view target) {
  if (target.empty() || target.front() != '/') return std::nullopt;
  HttpTarget parsed;
  const std::size_t question = target.find('?');
  const std::string_view path =
      target.substr(1, question == std::string_view::npos ? question : question - 1);
  const auto query =
      parsedQuery(question == std::string_view::npos ? std::string_view() : target.substr(question + 1));
  if (!query) return std::nullopt;
  parsed.query = *query;
  if (path.empty()) return parsed;
  for (const std::string_view piece : pieces(path, '/')) {
    auto segment = percentDecoded(piece);
    if (!segment || !isPlainSegment(*segment) || parsed.segments.size() == kMostSegments) return std::nullopt;
    parsed.segments.push_back(std::move(*segment));
  }
  return parsed;
}

std::string cookieValue(std::string_view header, std::string_view name) {
  for (const std::string_view piece : pieces(header, ';')) {
    const std::string_view cookie = trimmed(piece);
    const std::size_t equals = cookie.find('=');
    if (equals != std::string_view::npos && cookie.substr(0, equals) == name)
      return std::string(cookie.substr(equals + 1));
  }
  return "";
}

std::string hostName(std::string_view authority) {
  const std::size_t scheme = authority.find("://");
  if (scheme != std::string_view::npos) authority.remove_prefix(scheme + 3);
  if (!authority.empty() && authority.front() == '[')
    authority = authority.substr(1, std::min(authority.find(']'), authority.size()) - 1);
  else
    authority = authority.substr(0, authority.find(':'));
  std::string name(authority);
  std::transform(name.begin(), name.end(), name.begin(), [](char letter) {
    return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
  });
  return name;
}

const char* reasonOf(int status) {
  struct Reason {
    int status;
    const char* words;
  };
  static constexpr std::array kReasons = {
      Reason{200, "OK"},
      Reason{201, "Created"},
      Reason{202, "Accepted"},
      Reason{204, "No Content"},
      Reason{303, "See Other"},
      Reason{400, "Bad Request"},
      Reason{401, "Unauthorized"},
      Reason{403, "Forbidden"},
      Reason{404, "Not Found"},
      Reason{405, "Method Not Allowed"},
      Reason{408, "Request Timeout"},
      Reason{409, "Conflict"},
      Reason{411, "Length Required"},
      Reason{413, "Payload Too Large"},
      Reason{415, "Unsupported Media Type"},
      Reason{429, "Too Many Requests"},
      Reason{431, "Request Header Fields Too Large"},
      Reason{500, "Internal Server Error"},
      Reason{503, "Service Unavailable"},
      Reason{504, "Gateway Timeout"},
      Reason{507, "Insufficient Storage"},
  };
  const auto* const found =
      std::find_if(kReasons.begin(), kReasons.end(), [&](const Reason& row) { return row.status == status; });
  return found == kReasons.end() ? "Unknown" : found->words;
}

}  // namespace lamina
