// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/csv/event_field.hpp"

#include <charconv>
#include <string>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

constexpr std::string_view kHexDigits = "0123456789ABCDEF";

std::string escaped(std::string_view text) {
  std::string field;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= ' ' && byte <= '~' && c != ',' && c != '|' && c != '%')
      field += c;
    else
      field += {'%', kHexDigits[byte >> 4U], kHexDigits[byte & 0xFU]};
  }
  return field;
}

std::string unescaped(std::string_view field) {
  std::string text;
  for (std::size_t i = 0; i < field.size(); ++i) {
    if (field[i] != '%') {
      text += field[i];
      continue;
    }
    const std::size_t high = i + 3 <= field.size() ? kHexDigits.find(field[i + 1]) : std::string_view::npos;
    const std::size_t low = i + 3 <= field.size() ? kHexDigits.find(field[i + 2]) : std::string_view::npos;
    if (high == std::string_view::npos || low == std::string_view::npos)
      throw InvalidInput("'%' of an event is not followed by two hexadecimal digits (0 to 9, A to F)");
    text += static_cast<char>(high << 4U | low);
    i += 2;
  }
  return text;
}

std::string shortest(double value) {
  char digits[32];
  return {digits, std::to_chars(digits, digits + sizeof digits, value).ptr};
}

std::string fieldOf(const Dwell& dwell) { return "dwell=" + shortest(dwell.duration_s); }
std::string fieldOf(const FanShare& fan) { return "fan=" + shortest(fan.share); }
std::string fieldOf(const OperatorPause& pause) { return "pause=" + escaped(pause.message); }
std::string fieldOf(const MachineCode& code) {
  return (code.moves_axes ? "moving_code=" : "code=") + escaped(code.text);
}

double numberOf(std::string_view text) {
  double value{};
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  if (result.ec != std::errc{} || result.ptr != text.data() + text.size())
    throw InvalidInput("'" + std::string(text) + "' of an event is no number");
  return value;
}

}  // namespace

std::string toField(const ToolpathEvent& event) {
  return std::visit([](const auto& kind) { return fieldOf(kind); }, event);
}

ToolpathEvent eventFromField(std::string_view field) {
  const std::size_t equals = field.find('=');
  const std::string_view name = field.substr(0, equals);
  const std::string_view value = equals == std::string_view::npos ? "" : field.substr(equals + 1);
  if (name == "dwell") return Dwell{numberOf(value)};
  if (name == "fan") return FanShare{numberOf(value)};
  if (name == "pause") return OperatorPause{unescaped(value)};
  if (name == "code") return MachineCode{unescaped(value), false};
  if (name == "moving_code") return MachineCode{unescaped(value), true};
  throw InvalidInput("event is '" + std::string(name) + "'; must be dwell, fan, pause, code or moving_code");
}

}  // namespace lamina
