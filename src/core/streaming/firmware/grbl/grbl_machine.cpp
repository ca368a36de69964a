// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/firmware/grbl/grbl_machine.hpp"

#include <algorithm>
#include <cstdlib>
#include <string_view>

namespace lamina {
namespace {

constexpr std::string_view kBracketStart = "[VER:";  // as long as "[OPT:"

/// What stands between the colon and the bracket.
std::string bracketed(const std::string& text) {
  const std::size_t end = text.rfind(']');
  return text.substr(kBracketStart.size(),
                     (end == std::string::npos ? text.size() : end) - kBracketStart.size());
}

}  // namespace

std::string GrblMachine::name() const {
  const char* family = dialect == GrblDialect::GrblHal ? "grblHAL" : "grbl";
  return (dialect == GrblDialect::FluidNc ? "FluidNC" : family) + std::string(version.empty() ? "" : " ") +
         version;
}

GrblAxes GrblMachine::inMillimetres(const GrblAxes& reported) const {
  constexpr double kMillimetresPerInch = 25.4;
  GrblAxes position = reported;
  for (double& axis : position) axis *= reports_in_inches.value_or(false) ? kMillimetresPerInch : 1.0;
  return position;
}

void GrblMachine::learn(const GrblReply& reply) {
  if (reply.text.find("FluidNC") != std::string::npos) dialect = GrblDialect::FluidNc;
  if (reply.text.find("rblHAL") != std::string::npos || reply.text.compare(0, 8, "[NEWOPT:") == 0)
    dialect = GrblDialect::GrblHal;
  if (reply.kind == GrblReplyKind::Version) {
    version = bracketed(reply.text);
    version.erase(std::min(version.find(':'), version.size()));
  } else if (reply.kind == GrblReplyKind::Options) {
    options = bracketed(reply.text);
    const std::size_t first = options.find(',');
    if (first == std::string::npos) return;
    char* end = nullptr;
    const std::string numbers = options.substr(first + 1);
    blocks = static_cast<int>(std::strtol(numbers.c_str(), &end, 10));
    if (*end == ',') receive_bytes = static_cast<int>(std::strtol(end + 1, nullptr, 10));
    options.erase(first);
  } else if (reply.kind == GrblReplyKind::Modes) {
    modes = reply.text;
  } else if (reply.kind == GrblReplyKind::Setting && reply.text.compare(0, 4, "$13=") == 0) {
    reports_in_inches = reply.text.compare(4, 1, "1") == 0;
  } else if (reply.kind == GrblReplyKind::Setting && reply.text.compare(0, 4, "$32=") == 0) {
    is_laser = reply.text.compare(4, 1, "1") == 0;
  }
}

}  // namespace lamina
