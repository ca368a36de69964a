// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/firmware/klipper/klipper_protocol.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdlib>

#include "lamina/base/text_search.hpp"
#include "lamina/streaming/firmware/marlin/marlin_protocol.hpp"
#include "streaming/job/complaints.hpp"

namespace lamina {
namespace {

constexpr std::string_view kEcho = "// ECHO LAMINA=";

std::optional<double> numberAt(std::string_view text) {
  const std::string number(text.substr(0, 16));
  char* end = nullptr;
  const double value = std::strtod(number.c_str(), &end);
  return end == number.c_str() ? std::nullopt : std::optional<double>(value);
}

/// "B:60.0 /60.0 T0:210.0 /210.0": Klipper numbers its nozzles.
void readHeaters(std::string_view text, PacedReply& read) {
  const std::size_t tool = text.find("T0:");
  const auto nozzle_c = tool == std::string_view::npos ? std::nullopt : numberAt(text.substr(tool + 3));
  for (std::size_t at = text.find(" /"); at != std::string_view::npos; at = text.find(" /", at + 1)) {
    const auto target = numberAt(text.substr(at + 2));
    if (!target) return;
    read.are_heaters_off = read.are_heaters_off.value_or(true) && *target == 0.0;
    if (tool == std::string_view::npos || at < tool || read.reply.temperatures || !nozzle_c) continue;
    ReportedTemperatures temperatures;
    temperatures.nozzle_c = *nozzle_c;
    temperatures.nozzle_target_c = *target;
    const std::size_t bed = text.find("B:");
    if (bed != std::string_view::npos) {
      temperatures.bed_c = numberAt(text.substr(bed + 2));
      temperatures.bed_target_c = numberAt(text.substr(std::min(text.size(), text.find(" /", bed) + 2)));
    }
    read.reply.temperatures = temperatures;
  }
}

bool looksLikeHeaters(std::string_view text) {
  if (startsWith(text, "ok ")) text.remove_prefix(3);
  return (startsWith(text, "B:") || startsWith(text, "T")) && text.find(':') != std::string_view::npos;
}

}  // namespace

PacedReply readKlipperReply(std::string_view line) {
  PacedReply read;
  read.reply = parseReply(line);
  FirmwareReply& reply = read.reply;
  const std::string_view text = reply.text;
  if (klipperComplaint(text) == Complaint::Error) {
    reply.kind = ReplyKind::Warning;
    read.is_refusal = true;
  } else if (startsWith(text, "// Klipper state: ")) {
    const bool has_stopped = text.find("Shutdown") != std::string_view::npos;
    // "Ready" answers anybody's STATUS too.
    const bool has_restarted = text.find("Disconnect") != std::string_view::npos;
    if (has_stopped) reply.kind = ReplyKind::Fatal;
    if (has_restarted) reply.kind = ReplyKind::Start;
  } else if (klipperComplaint(text) == Complaint::NotDone) {
    reply.kind = ReplyKind::NotDone;
    // Only where there is no heater is this unknown.
    if (text.find("TURN_OFF_HEATERS") != std::string_view::npos) read.are_heaters_off = true;
  } else if (startsWith(text, kEcho)) {
    SyncAnswer answer;
    const char* const begin = text.data() + kEcho.size();
    const char* const end = text.data() + text.size();
    const auto number = std::from_chars(begin, end, answer.question);
    if (number.ec == std::errc() && number.ptr == end) read.sync_answer = answer;
  } else if ((reply.kind == ReplyKind::Ok && !startsWith(line, "ok")) || reply.kind == ReplyKind::Start ||
             reply.kind == ReplyKind::Fatal) {
    // A message of its user's, which has a prefix; and Klipper greets and halts in words of its own.
    reply.kind = ReplyKind::Information;
  }
  if (looksLikeHeaters(text)) readHeaters(text, read);
  return read;
}

std::string klipperQuestion(std::uint64_t number) { return "ECHO LAMINA=" + std::to_string(number); }

bool isExtendedCommand(std::string_view command) {
  const auto isNamePart = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  return command.size() > 1 && isNamePart(command[0]) && isNamePart(command[1]);
}

std::string klipperDefectOf(std::string_view command, int max_line_bytes) {
  if (max_line_bytes > 0 && command.size() + 1 > static_cast<std::size_t>(max_line_bytes)) {
    return "is " + std::to_string(command.size() + 1) + " bytes with its end; stream.max_line_bytes is " +
           std::to_string(max_line_bytes);
  }
  const auto isOdd = [](char c) {
    return static_cast<unsigned char>(c) < ' ' || static_cast<unsigned char>(c) > '~';
  };
  if (std::any_of(command.begin(), command.end(), isOdd))
    return "has a byte that is not printable ASCII; Klipper loses all that it reads at once where such a "
           "character is cut";
  if (!isExtendedCommand(command)) {
    if (command.find(';') == std::string_view::npos) return {};
    return "has a ';' within quotes, behind which Klipper reads nothing of such a command";
  }
  bool is_quoted = false;
  for (const char c : command) {
    if (c == '"') is_quoted = !is_quoted;
    if (!is_quoted && c == '#')
      return "has a '#', behind which Klipper reads nothing of a command of its own";
  }
  return is_quoted ? "has a quote that is not closed, which Klipper refuses" : std::string();
}

}  // namespace lamina
