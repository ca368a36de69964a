// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/session/identification.hpp"

#include <algorithm>
#include <cctype>
#include <limits>
#include <memory>
#include <utility>

#include "lamina/base/text.hpp"
#include "lamina/streaming/firmware/marlin/marlin_protocol.hpp"
#include "streaming/firmware/marlin/person_wait.hpp"

namespace lamina {
namespace {

constexpr const char* kMarlin = "marlin";

/// What only grbl and its kin say: "error:20" to a command they do not know, a report "<Idle|...>", and the
/// end of their greeting, which grblHAL and FluidNC word in ways of their own.
bool isOfGrbl(std::string_view line) {
  constexpr std::string_view kError = "error:";
  line = trimmed(line);
  if (line.substr(0, kError.size()) == kError && line.size() > kError.size())
    return std::isdigit(static_cast<unsigned char>(line[kError.size()])) != 0;
  if (line.size() > 2 && line.front() == '<' && line.back() == '>')
    return line.find('|') != std::string_view::npos;
  return line.find("for help]") != std::string_view::npos;
}

}  // namespace

std::vector<std::string> protocolsSpokenBy(const std::string& firmware_name) {
  std::vector<std::string> names = firmwareProtocols().names();
  const auto isDeaf = [&](const std::string& name) {
    return name == kMarlin || !firmwareProtocols().find(name)->isSpokenBy(firmware_name);
  };
  names.erase(std::remove_if(names.begin(), names.end(), isDeaf), names.end());
  if (names.empty() && firmwareProtocols().find(kMarlin)->isSpokenBy(firmware_name)) names.push_back(kMarlin);
  return names;
}

Identification::Identification(const StreamOrder& order)
    : settings_(order.settings), heard_(order.heard), timer_(order.settings.probe_after_s) {
  record_.status.lines_total = order.program.lines();
}

void Identification::start(double now) {
  if (record_.status.state != PackmlState::Idle) return;
  record_.enter(PackmlState::Starting);
  timer_.restart(now);
  ask(now);
}

void Identification::ask(double now) {
  timer_.asked(now);
  ++questions_;
  output_ += "M115\n";
}

void Identification::receive(std::string_view bytes, double now) {
  replies_.add(bytes);
  while (!isOver()) {
    const auto line = replies_.next();
    if (!line) return;
    const FirmwareReply reply = parseReply(*line);
    if (heard_) heard_(reply);
    onReply(reply, now);
  }
}

void Identification::onReply(const FirmwareReply& reply, double now) {
  if (reply.text.find("Please enter your password") != std::string::npos) {
    abort({ErrorCode::Rejected, "the machine asks for a password (\"" + reply.text +
                                    "\"), and none can be given; expected a machine without one (M551)"});
    return;
  }
  if (!reply.firmware_name.empty()) firmware_name_ = reply.firmware_name;
  hears_at_once_ = hears_at_once_ || saysThatItHearsAtOnce(reply);
  if (isOfGrbl(reply.text)) {
    firmware_name_ = "grbl";
    choose();
  } else if (reply.kind == ReplyKind::Ok) {
    choose();
  } else if (reply.kind == ReplyKind::Start) {
    timer_.restart(now);
    ask(now);
  } else if (reply.kind == ReplyKind::Busy || reply.temperatures) {
    // A machine that boots, or that another sender has made heat, answers later.
    timer_.restart(now);
  }
}

void Identification::choose() {
  const std::vector<std::string> protocols = protocolsSpokenBy(firmware_name_);
  record_.status.firmware_name = firmware_name_;
  if (protocols.size() == 1) {
    found_ = FoundFirmware{protocols.front(), firmware_name_, hears_at_once_};
  } else if (protocols.empty()) {
    abort({ErrorCode::Rejected, "the machine's firmware is \"" + firmware_name_ +
                                    "\", which nothing here speaks to; expected one of " +
                                    listed(firmwareProtocols().names())});
  } else {
    abort({ErrorCode::Rejected, "the machine's firmware is \"" + firmware_name_ + "\", which speaks " +
                                    listed(protocols) + "; expected stream.firmware to be one of these"});
  }
}

void Identification::elapse(double now) {
  if (isOver()) return;
  if (now >= timer_.quietSince() + settings_.connect_timeout_s) {
    abort({ErrorCode::TimedOut, "no machine answered within " +
                                    std::to_string(static_cast<int>(settings_.connect_timeout_s)) +
                                    " s; is it on, and is the baud rate right?"});
  } else if (now >= timer_.retryAt()) {
    ask(now);
  }
}

void Identification::abort(const Failure& why) {
  if (record_.status.state != PackmlState::Starting) return;
  found_.reset();
  record_.status.failure = why;
  record_.enter(PackmlState::Aborting);
  record_.enter(PackmlState::Aborted);
}

double Identification::nextDeadline() const {
  if (isOver()) return std::numeric_limits<double>::infinity();
  return std::min(timer_.retryAt(), timer_.quietSince() + settings_.connect_timeout_s);
}

}  // namespace lamina
