// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <type_traits>

#include "streaming/upload/print_server.hpp"

namespace lamina {

inline ServerAnswer answered(ServerAnswer::Kind kind) { return {kind, {}}; }
inline ServerAnswer refused(const std::string& why) {
  return {ServerAnswer::Kind::Refused, {ErrorCode::Rejected, why}};
}

/// The body as JSON; nothing if it is no JSON object, or nests more than 100 deep.
std::optional<nlohmann::json> jsonOf(const HttpResponse& response);

/// The error text of a response: the message in its JSON, otherwise the status and the beginning of its body.
std::string errorTextOf(const HttpResponse& response);

/// The meaning of a status other than 2xx, from any server: NotTaken for 429 and 503, Later for any other 5xx
/// (as of a proxy that got no answer), Refused for all others, including redirects.
/// @param what  what was requested: "the upload"
ServerAnswer answerOfStatus(const std::string& what, const HttpResponse& response);

inline bool isSuccess(const HttpResponse& response) { return response.status / 100 == 2; }

/// A number of an answer if `Value` can hold it. Refused are texts, fractions for whole numbers, values out
/// of the range of `Value`, and for floating-point `Value` magnitudes above 1e9, which no machine measures.
template <class Value>
std::optional<Value> numberOf(const nlohmann::json& found) {
  constexpr double kGreatest = 1e9;
  using Limits = std::numeric_limits<Value>;
  if (!found.is_number()) return std::nullopt;
  if constexpr (std::is_floating_point_v<Value>) {
    const auto number = found.get<double>();
    if (std::abs(number) <= kGreatest) return static_cast<Value>(number);
    return std::nullopt;
  } else if (found.is_number_unsigned()) {
    const auto number = found.get<std::uint64_t>();
    if (number <= static_cast<std::uint64_t>(Limits::max())) return static_cast<Value>(number);
    return std::nullopt;
  } else if (found.is_number_integer()) {
    const auto number = found.get<std::int64_t>();
    if (number >= static_cast<std::int64_t>(Limits::min()) && (number < 0 || std::is_signed_v<Value>))
      return static_cast<Value>(number);
    return std::nullopt;
  } else {
    // Some write whole numbers with a point; the limit itself may not be a double.
    const auto number = found.get<double>();
    const double beyond = std::ldexp(1.0, Limits::digits);
    if (std::floor(number) == number && number >= static_cast<double>(Limits::min()) && number < beyond)
      return static_cast<Value>(number);
    return std::nullopt;
  }
}

/// The value at a path of keys if it has the type of `fallback`; otherwise `fallback`.
template <class Value>
Value valueAt(const nlohmann::json& tree, const char* path, Value fallback) {
  const nlohmann::json::json_pointer pointer(path);
  if (!tree.contains(pointer)) return fallback;
  const nlohmann::json& found = tree.at(pointer);
  if constexpr (std::is_same_v<Value, std::string>)
    return found.is_string() ? found.get<Value>() : fallback;
  else if constexpr (std::is_same_v<Value, bool>)
    return found.is_boolean() ? found.get<Value>() : fallback;
  else
    return numberOf<Value>(found).value_or(fallback);
}

/// Reads numbers of an answer, and remembers the first value that is no valid number.
class AnswerNumbers {
 public:
  explicit AnswerNumbers(const nlohmann::json& tree) : tree_(tree) {}

  /// The number at a path of keys; nothing if it is missing, null or invalid.
  template <class Value>
  std::optional<Value> at(const std::string& path) {
    const nlohmann::json::json_pointer pointer(path);
    if (!tree_.contains(pointer) || tree_.at(pointer).is_null()) return std::nullopt;
    const std::optional<Value> number = numberOf<Value>(tree_.at(pointer));
    if (!number) {
      const char* whole = std::is_signed_v<Value> ? "a whole number" : "a whole number of 0 or more";
      doubt(path, std::is_floating_point_v<Value> ? "a number of at most 1e9" : whole);
    }
    return number;
  }
  /// States that the value at a path is not the expected kind.
  void doubt(const std::string& path, const std::string& expected);
  /// The first value left out, and what was expected; empty if none was.
  const std::string& doubted() const { return doubted_; }

 private:
  const nlohmann::json& tree_;
  std::string doubted_;
};

/// The outcome of an answer that is unreadable because of an invalid value.
inline ServerAnswer unreadable(const std::string& what, const std::string& doubted) {
  return {ServerAnswer::Kind::Later,
          {ErrorCode::DeviceError, "the answer to " + what + " cannot be read: " + doubted}};
}

/// Compares the file read back from the server with the one sent.
ServerAnswer compared(const ProgramBody& body, const HttpResponse& response);
/// Compares the size that a server reports with that of the file that was sent.
ServerAnswer comparedSize(const ProgramBody& body, std::uint64_t bytes);
/// As above, with the size at a path of keys.
ServerAnswer comparedSize(const ProgramBody& body, const nlohmann::json& tree, const char* path);

}  // namespace lamina
