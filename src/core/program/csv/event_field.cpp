// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/csv/event_field.hpp"

#include <charconv>
#include <string>
#include <utility>

#include "lamina/base/error.hpp"
#include "lamina/base/exact_text.hpp"
#include "lamina/base/percent_encoding.hpp"

namespace lamina {
namespace {

/// All that can be printed but , | %, which divide fields and events and begin an escape.
constexpr std::string_view kPlain = " !\"#$&'()*+-./:;<=>?@[\\]^_`{}~";

std::string escaped(std::string_view text) { return percentEncoded(text, kPlain); }

std::string unescaped(std::string_view field) {
  auto text = percentDecoded(field);
  if (!text) throw InvalidInput("'%' of an event is not followed by two hexadecimal digits (0 to 9, A to F)");
  return std::move(*text);
}

std::string fieldOf(const Dwell& dwell) { return "dwell=" + exactText(dwell.duration_s); }
std::string fieldOf(const FanShare& fan) { return "fan=" + exactText(fan.share); }
std::string fieldOf(const OperatorPause& pause) { return "pause=" + escaped(pause.message); }
std::string fieldOf(const PartMark& mark) { return "part=" + escaped(mark.name); }
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
  if (name == "part") return PartMark{unescaped(value)};
  if (name == "code") return MachineCode{unescaped(value), false};
  if (name == "moving_code") return MachineCode{unescaped(value), true};
  throw InvalidInput("event is '" + std::string(name) +
                     "'; must be dwell, fan, pause, part, code or "
                     "moving_code");
}

}  // namespace lamina
