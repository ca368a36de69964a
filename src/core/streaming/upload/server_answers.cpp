// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/upload/server_answers.hpp"

#include <algorithm>
#include <array>

#include "lamina/base/percent_encoding.hpp"
#include "lamina/base/text.hpp"

namespace lamina {
namespace {

std::string eightDigits(std::uint32_t number) {
  std::array<char, 9> text{};
  std::snprintf(text.data(), text.size(), "%08x", number);
  return text.data();
}

/// How many arrays and objects of a JSON text enclose what is enclosed most.
std::size_t depthOf(const std::string& text) {
  std::size_t depth = 0;
  std::size_t greatest = 0;
  bool is_quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '"') is_quoted = !is_quoted;
    if (is_quoted && c == '\\') ++i;  // and what it is in front of
    if (is_quoted) continue;
    if (c == '[' || c == '{') greatest = std::max(greatest, ++depth);
    if ((c == ']' || c == '}') && depth > 0) --depth;
  }
  return greatest;
}

}  // namespace

std::string escapedForUrl(const std::string& text) { return percentEncoded(text, "-._~/"); }

std::optional<nlohmann::json> jsonOf(const HttpResponse& response) {
  // Far more than any server's; what is copied or written goes down by one call a level.
  constexpr std::size_t kGreatestDepth = 100;
  if (depthOf(response.body) > kGreatestDepth) return std::nullopt;
  nlohmann::json tree = nlohmann::json::parse(response.body, nullptr, false);
  if (!tree.is_object()) return std::nullopt;
  return tree;
}

std::string errorTextOf(const HttpResponse& response) {
  constexpr std::size_t kLongest = 200;
  std::string status = "HTTP status " + std::to_string(response.status);
  if (const auto tree = jsonOf(response)) {
    const std::string message = valueAt<std::string>(*tree, "/error/message", "");
    if (!message.empty()) return message.substr(0, kLongest) + " (" + status + ")";
  }
  if (response.body.empty() || response.body.front() == '<') return status;
  std::string text;
  for (const char c : response.body.substr(0, kLongest)) text += c >= ' ' && c <= '~' ? c : ' ';
  return std::string(trimmed(text)) + " (" + status + ")";
}

ServerAnswer answerOfStatus(const std::string& what, const HttpResponse& response) {
  constexpr int kTooManyRequests = 429;
  constexpr int kUnavailable = 503;
  const std::string why = what + " was refused: " + errorTextOf(response);
  if (response.status == kTooManyRequests || response.status == kUnavailable)
    return {AnswerKind::NotTaken, {ErrorCode::DeviceError, why}};
  if (response.status >= 500) return {AnswerKind::Later, {ErrorCode::DeviceError, why}};
  if (response.status / 100 == 3) return refused(why + "; a redirect is not followed");
  return refused(why);
}

ServerAnswer comparedSize(const ProgramBody& body, std::uint64_t bytes) {
  if (bytes == body.bytes()) return answered(AnswerKind::Done);
  return refused("the uploaded file has " + std::to_string(bytes) + " bytes; expected " +
                 std::to_string(body.bytes()));
}

ServerAnswer comparedSize(const ProgramBody& body, const nlohmann::json& tree, const char* path) {
  AnswerNumbers numbers(tree);
  const auto bytes = numbers.at<std::uint64_t>(path);
  if (!numbers.doubted().empty()) return unreadable("what was stored", numbers.doubted());
  return comparedSize(body, bytes.value_or(0));
}

void AnswerNumbers::doubt(const std::string& path, const std::string& expected) {
  constexpr std::size_t kLongest = 40;
  if (!doubted_.empty()) return;
  std::string text = tree_.at(nlohmann::json::json_pointer(path))
                         .dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
  if (text.size() > kLongest) text = text.substr(0, kLongest) + "...";
  doubted_ = path.substr(1) + " is " + text + "; expected " + expected;
}

ServerAnswer compared(const ProgramBody& body, const HttpResponse& response) {
  if (response.digested_bytes != body.bytes()) return comparedSize(body, response.digested_bytes);
  if (response.digested_crc32 == body.crc32()) return answered(AnswerKind::Done);
  return refused("the uploaded file has the CRC-32 " + eightDigits(response.digested_crc32) + "; expected " +
                 eightDigits(body.crc32()));
}

}  // namespace lamina
