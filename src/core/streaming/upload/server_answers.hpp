// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "streaming/upload/print_server.hpp"

namespace lamina {

inline ServerAnswer answered(ServerAnswer::Kind kind) { return {kind, {}}; }
inline ServerAnswer refused(const std::string& why) {
  return {ServerAnswer::Kind::Refused, {ErrorCode::Rejected, why}};
}

/// The body as JSON; nothing if it is not JSON.
std::optional<nlohmann::json> jsonOf(const HttpResponse& response);

/// The error text of a response: the message in its JSON, otherwise the status and the beginning of its body.
std::string errorTextOf(const HttpResponse& response);

/// The meaning of a status other than 2xx, from any server: NotTaken for 429 and 503, Later for any other 5xx
/// (as of a proxy that got no answer), Refused for all others, including redirects.
/// @param what  what was requested: "the upload"
ServerAnswer answerOfStatus(const std::string& what, const HttpResponse& response);

inline bool isSuccess(const HttpResponse& response) { return response.status / 100 == 2; }

/// The value at a path of keys if it has the type of `fallback`; otherwise `fallback`.
template <class Value>
Value valueAt(const nlohmann::json& tree, const char* path, Value fallback) {
  const nlohmann::json::json_pointer pointer(path);
  if (!tree.contains(pointer)) return fallback;
  const nlohmann::json& found = tree.at(pointer);
  if constexpr (std::is_same_v<Value, std::string>) return found.is_string() ? found.get<Value>() : fallback;
  if constexpr (std::is_same_v<Value, bool>) return found.is_boolean() ? found.get<Value>() : fallback;
  if constexpr (std::is_arithmetic_v<Value> && !std::is_same_v<Value, bool>)
    return found.is_number() ? found.get<Value>() : fallback;
  return fallback;
}

/// Compares the file read back from the server with the one sent.
ServerAnswer compared(const ProgramBody& body, const HttpResponse& response);
/// Compares the size that a server reports with that of the file that was sent.
ServerAnswer comparedSize(const ProgramBody& body, std::uint64_t bytes);

}  // namespace lamina
