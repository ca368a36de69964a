// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/web/multipart_reader.hpp"

#include <algorithm>
#include <utility>

#include "lamina/base/error.hpp"
#include "lamina/base/percent_encoding.hpp"
#include "lamina/base/text.hpp"

namespace lamina {
namespace {

constexpr std::size_t kLongestHead = 8192;
constexpr int kMostParts = 16;
constexpr std::size_t kLongestBoundary = 70;
constexpr std::size_t kLongestFileName = 120;

/// A parameter of a header such as `form-data; name="file"`, its quotes taken off; nothing if it is missing.
std::optional<std::string> parameterOf(std::string_view header, std::string_view wanted) {
  std::size_t at = header.find(';');
  while (at != std::string_view::npos && at + 1 < header.size()) {
    std::size_t equals = at + 1;
    while (equals < header.size() && header[equals] != '=' && header[equals] != ';') ++equals;
    const std::string name = lowerCase(trimmed(header.substr(at + 1, equals - at - 1)));
    std::string value;
    std::size_t end = equals < header.size() && header[equals] == '=' ? equals + 1 : equals;
    if (end < header.size() && header[end] == '"') {
      for (++end; end < header.size() && header[end] != '"'; ++end) {
        // Only quotes and backslashes are escaped: browsers send the backslashes of paths as they are.
        if (header[end] == '\\' && end + 1 < header.size() &&
            (header[end + 1] == '"' || header[end + 1] == '\\'))
          ++end;
        value += header[end];
      }
      end = header.find(';', std::min(end, header.size()));
    } else {
      const std::size_t next = header.find(';', end);
      value = trimmed(header.substr(end, next == std::string_view::npos ? next : next - end));
      end = next;
    }
    if (name == wanted) return value;
    at = end;
  }
  return std::nullopt;
}

/// The value of `filename*=UTF-8''…` (RFC 5987).
std::string extendedValue(const std::string& value) {
  const std::size_t language = value.find('\'');
  const std::size_t text = language == std::string::npos ? language : value.find('\'', language + 1);
  if (text == std::string::npos) return value;
  const std::string encoded = value.substr(text + 1);
  return percentDecoded(encoded).value_or(encoded);  // a name, whatever it is: it is made safe
}

MultipartHead headOf(std::string_view text) {
  MultipartHead head;
  while (!text.empty()) {
    const std::size_t end = text.find("\r\n");
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 2);
    const std::size_t colon = line.find(':');
    if (colon == std::string_view::npos || lowerCase(line.substr(0, colon)) != "content-disposition")
      continue;
    head.name = parameterOf(line, "name").value_or("");
    head.filename = parameterOf(line, "filename");
    if (const auto extended = parameterOf(line, "filename*")) head.filename = extendedValue(*extended);
  }
  if (head.name.empty())
    throw InvalidInput("a part of the form has no name; expected Content-Disposition with one");
  return head;
}

/// Bytes of the UTF-8 character that begins here; 0 if none does.
std::size_t characterAt(std::string_view text, std::size_t at) {
  const auto byte = static_cast<unsigned char>(text[at]);
  const std::size_t size = byte < 0x80                   ? 1
                           : byte >= 0xc2 && byte < 0xe0 ? 2
                           : byte >= 0xe0 && byte < 0xf0 ? 3
                           : byte >= 0xf0 && byte < 0xf5 ? 4
                                                         : 0;
  if (size == 0 || at + size > text.size()) return 0;
  for (std::size_t i = 1; i < size; ++i)
    if ((static_cast<unsigned char>(text[at + i]) & 0xc0) != 0x80) return 0;
  return size;
}

}  // namespace

std::optional<std::string> multipartBoundary(std::string_view content_type) {
  const std::string type = lowerCase(trimmed(content_type.substr(0, content_type.find(';'))));
  if (type != "multipart/form-data") return std::nullopt;
  auto boundary = parameterOf(content_type, "boundary");
  if (!boundary || boundary->empty() || boundary->size() > kLongestBoundary) return std::nullopt;
  return boundary;
}

MultipartReader::MultipartReader(const std::string& boundary, MultipartHandlers handlers)
    : delimiter_("\r\n--" + boundary), handlers_(std::move(handlers)), held_("\r\n") {}

void MultipartReader::read(std::string_view piece) {
  // Piece by piece of what is held at most, so that a large one does not become twice as large.
  while (!piece.empty()) {
    const std::string_view part = piece.substr(0, kLongestHead);
    piece.remove_prefix(part.size());
    held_ += part;
    while (advance()) {
    }
  }
}

bool MultipartReader::advance() {
  switch (within_) {
    case Within::Preamble:
      return skipPreamble();
    case Within::Boundary:
      return takeBoundary();
    case Within::Head:
      return takeHead();
    case Within::Body:
      return takeBody();
    case Within::Epilogue:
      held_.clear();
      return false;
  }
  return false;
}

bool MultipartReader::skipPreamble() {
  const std::size_t found = held_.find(delimiter_);
  if (found == std::string::npos) {
    if (held_.size() > delimiter_.size()) held_.erase(0, held_.size() - delimiter_.size());
    return false;
  }
  held_.erase(0, found + delimiter_.size());
  within_ = Within::Boundary;
  return true;
}

bool MultipartReader::takeBoundary() {
  if (held_.size() < 2) return false;
  if (held_.compare(0, 2, "--") == 0) {
    within_ = Within::Epilogue;
    return true;
  }
  if (held_.compare(0, 2, "\r\n") != 0)
    throw InvalidInput("a boundary of the form is not followed by the end of its line");
  if (++parts_ > kMostParts)
    throw InvalidInput("the form has more than " + std::to_string(kMostParts) + " parts");
  within_ = Within::Head;
  return true;
}

bool MultipartReader::takeHead() {
  const std::size_t end = held_.find("\r\n\r\n");
  if (end == std::string::npos) {
    if (held_.size() > kLongestHead)
      throw InvalidInput("the head of a part of the form has more than " + std::to_string(kLongestHead) +
                         " bytes");
    return false;
  }
  handlers_.begin(headOf(std::string_view(held_).substr(2, end < 2 ? 0 : end - 2)));
  held_.erase(0, end + 2);  // an empty part ends with the line break that ends its head
  within_ = Within::Body;
  is_body_new_ = true;
  return true;
}

bool MultipartReader::takeBody() {
  if (is_body_new_) {
    if (held_.size() < delimiter_.size()) return false;
    // The line break before the first byte is no part of the body.
    if (held_.compare(0, delimiter_.size(), delimiter_) != 0) held_.erase(0, 2);
    is_body_new_ = false;
  }
  const std::size_t found = held_.find(delimiter_);
  if (found != std::string::npos) {
    if (found > 0) handlers_.piece(std::string_view(held_).substr(0, found));
    handlers_.end();
    held_.erase(0, found + delimiter_.size());
    within_ = Within::Boundary;
    return true;
  }
  if (held_.size() <= delimiter_.size()) return false;
  const std::size_t sure = held_.size() - delimiter_.size();
  handlers_.piece(std::string_view(held_).substr(0, sure));
  held_.erase(0, sure);
  return false;
}

void MultipartReader::finish() const {
  if (within_ != Within::Epilogue) throw InvalidInput("the form was cut off before its last boundary");
}

std::string safeFileName(std::string_view name) {
  const std::size_t slash = name.find_last_of("/\\");
  if (slash != std::string_view::npos) name.remove_prefix(slash + 1);
  std::string safe;
  for (std::size_t at = 0; at < name.size();) {
    const std::size_t size = characterAt(name, at);
    const auto byte = static_cast<unsigned char>(name[at]);
    const bool is_kept = size > 0 && byte >= 0x20 && byte != 0x7f;
    const std::string_view kept = is_kept ? name.substr(at, size) : "_";
    if (safe.size() + kept.size() > kLongestFileName) break;
    safe += kept;
    at += std::max<std::size_t>(size, 1);
  }
  const std::size_t first = safe.find_first_not_of(". ");
  safe.erase(0, first);
  return first == std::string::npos || safe.empty() ? "program.gcode" : safe;
}

}  // namespace lamina
