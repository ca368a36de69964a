// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/streaming/emulator/emulated_faults.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <utility>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

constexpr std::array<std::pair<FaultKind, const char*>, 8> kNames = {{
    {FaultKind::LostOk, "lost_ok"},
    {FaultKind::DelayedOk, "delayed_ok"},
    {FaultKind::LostLine, "lost_line"},
    {FaultKind::CorruptedLine, "corrupted_line"},
    {FaultKind::SpuriousResend, "spurious_resend"},
    {FaultKind::Silence, "silence"},
    {FaultKind::Disconnect, "disconnect"},
    {FaultKind::Reset, "reset"},
}};

std::string knownKinds() {
  std::string text;
  for (const auto& name : kNames) text += std::string(text.empty() ? "" : ", ") + name.second;
  return text;
}

FaultKind kindFromText(const std::string& text) {
  for (const auto& name : kNames) {
    if (text == name.second) return name.first;
  }
  throw InvalidConfig("unknown fault \"" + text + "\"; expected one of " + knownKinds());
}

double rateFromText(const std::string& text) {
  char* end = nullptr;
  const double rate = std::strtod(text.c_str(), &end);
  if (*end == '\0' && rate >= 0.0 && rate <= 1.0) return rate;
  throw InvalidConfig("fault rate is " + text + "; must be in [0.0, 1.0]");
}

std::vector<std::uint64_t> linesFromText(const std::string& text) {
  std::vector<std::uint64_t> lines;
  const char* at = text.data();
  const char* const end = at + text.size();
  while (true) {
    std::uint64_t line = 0;
    const auto read = std::from_chars(at, end, line);
    if (read.ec != std::errc()) break;
    lines.push_back(line);
    at = read.ptr;
    if (at == end) return lines;
    if (*at++ != ',') break;
  }
  throw InvalidConfig("fault lines are \"" + text +
                      "\"; expected line numbers such as 12,40 or a rate such as 0.01");
}

}  // namespace

const char* toString(FaultKind kind) {
  for (const auto& name : kNames) {
    if (name.first == kind) return name.second;
  }
  return "unknown";
}

const std::vector<FaultKind>& allFaultKinds() {
  static const std::vector<FaultKind> kAll = [] {
    std::vector<FaultKind> kinds;
    kinds.reserve(std::size(kNames));
    for (const auto& name : kNames) kinds.push_back(name.first);
    return kinds;
  }();
  return kAll;
}

Fault faultFromText(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) {
    throw InvalidConfig("fault \"" + text + "\" has no '='; expected kind=rate or kind=line,line");
  }
  Fault fault;
  fault.kind = kindFromText(text.substr(0, equals));
  const std::string when = text.substr(equals + 1);
  if (when.find('.') != std::string::npos) {
    fault.rate = rateFromText(when);
  } else {
    fault.lines = linesFromText(when);
  }
  return fault;
}

FaultInjector::FaultInjector(std::vector<Fault> faults, std::uint64_t seed)
    : faults_(std::move(faults)), random_(seed) {}

bool FaultInjector::strikes(FaultKind kind, std::uint64_t line) {
  bool is_struck = false;
  for (Fault& fault : faults_) {
    if (fault.kind != kind) continue;
    if (fault.rate > 0.0 && random_.uniform(0.0, 1.0) < fault.rate) is_struck = true;
    const auto listed = std::find(fault.lines.begin(), fault.lines.end(), line);
    if (listed == fault.lines.end()) continue;
    fault.lines.erase(listed);
    is_struck = true;
  }
  return is_struck;
}

std::string FaultInjector::corrupted(std::string line) {
  if (line.empty()) return line;
  constexpr std::uint64_t kPrintable = '~' - ' ';
  char& victim = line[random_.below(line.size())];
  // One of the other printable characters, all equally likely.
  const auto offset = static_cast<std::uint64_t>(victim - ' ');
  victim = static_cast<char>(' ' + (offset + 1 + random_.below(kPrintable)) % (kPrintable + 1));
  return line;
}

}  // namespace lamina
