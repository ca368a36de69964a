// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/emulator/grbl/grbl_board.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace lamina {
namespace {

constexpr double kForever = std::numeric_limits<double>::infinity();
// By which time may be short of an event that is due [s].
constexpr double kGrblTimeRounding = 1e-9;
constexpr int kReportsBetweenOverrides = 10;
constexpr int kReportsBetweenOffsets = 30;

std::string grblAxes(const Point3& place) {
  std::array<char, 96> text{};
  std::snprintf(text.data(), text.size(), "%.3f,%.3f,%.3f", place.x(), place.y(), place.z());
  return text.data();
}

}  // namespace

EmulatedGrbl::Board::Board(EmulatedGrblSettings settings, std::vector<GrblFault> faults, Observer observer)
    : settings_(std::move(settings)),
      faults_(std::move(faults)),
      observer_(std::move(observer)),
      random_(settings_.seed),
      state_(settings_.is_locked ? State::Alarm : State::Idle) {}

// Bytes.

void EmulatedGrbl::Board::receive(std::string_view bytes, double now) {
  elapse(now);
  for (const char byte : bytes) {
    if (is_link_cut_) return;
    const auto heard = throughFaults(byte);
    if (heard && !obey(*heard, now)) store(*heard);
    if (byte == '\n' && strikesOnArrival(arriving_ - 1, now)) return;
  }
  work(now);
}

/// Damage is drawn once for each line, when its first byte arrives.
std::optional<char> EmulatedGrbl::Board::throughFaults(char byte) {
  constexpr std::size_t kSpread = 12;  // bytes from the start of a line
  if (arrived_bytes_ == 0) {
    first_byte_ = byte;
    loses_at_.reset();
    changes_at_.reset();
    const bool is_counted = byte == 'G';
    if (is_counted && strikes(GrblFaultKind::LostByte, arriving_)) loses_at_ = random_.below(kSpread);
    if (is_counted && strikes(GrblFaultKind::ChangedByte, arriving_)) changes_at_ = random_.below(kSpread);
  }
  const bool is_realtime = byte == '?' || byte == '!' || byte == '~' || byte == '\x18';
  if (is_realtime && arrived_bytes_ == 0) return byte;
  if (static_cast<unsigned char>(byte) >= 0x80) return byte;
  const std::size_t at = arrived_bytes_++;
  const bool is_end = byte == '\n';
  if (is_end) arrived_bytes_ = 0;
  if (is_end && first_byte_ != '$') ++arriving_;
  const auto strikesHere = [&](const std::optional<std::size_t>& place) {
    return place && (at == *place || (is_end && at < *place));
  };
  if (strikesHere(loses_at_)) return std::nullopt;
  constexpr std::uint64_t kBits = 7;
  if (strikesHere(changes_at_)) return static_cast<char>(byte ^ (1 << random_.below(kBits)));
  return byte;
}

bool EmulatedGrbl::Board::strikes(GrblFaultKind kind, std::uint64_t line) {
  bool is_struck = false;
  for (GrblFault& fault : faults_) {
    if (fault.kind != kind) continue;
    if (fault.rate > 0.0 && random_.uniform(0.0, 1.0) < fault.rate) is_struck = true;
    const auto listed = std::find(fault.lines.begin(), fault.lines.end(), line);
    if (listed == fault.lines.end()) continue;
    fault.lines.erase(listed);
    is_struck = true;
  }
  if (is_struck) ++fault_count_;
  return is_struck;
}

/// @return whether what follows on the link is lost
bool EmulatedGrbl::Board::strikesOnArrival(std::uint64_t line, double now) {
  if (first_byte_ != 'G') return false;
  if (strikes(GrblFaultKind::Reset, line)) {
    reset();
    return true;
  }
  if (strikes(GrblFaultKind::Disconnect, line)) {
    is_link_cut_ = true;
    return true;
  }
  if (strikes(GrblFaultKind::Silence, line)) asleep_until_s_ = now + settings_.silence_s;
  return false;
}

void EmulatedGrbl::Board::store(char byte) {
  if (rx_.size() - read_ >= static_cast<std::size_t>(settings_.receive_bytes)) {
    ++bytes_lost_;
    return;
  }
  rx_ += byte;
}

/// @return whether the byte was one of those that do not wait in the buffer
bool EmulatedGrbl::Board::obey(char byte, double now) {
  switch (byte) {
    case '?':
      if (!isAsleep(now)) report();
      return true;
    case '!':
      if (!settings_.obeys_holds) return true;
      if (state_ == State::Idle) state_ = State::Held;
      if (state_ == State::Run) {
        advance(now);
        state_ = State::Slowing;
        still_at_s_ = now + settings_.hold_s;
      }
      return true;
    case '~':
      if (state_ == State::Held) state_ = blocks_.empty() ? State::Idle : State::Run;
      return true;
    case '\x18':
      if (isInMotion()) {
        state_ = State::Alarm;
        say("ALARM:3\r\n");
      }
      reset();
      return true;
    default:
      return noteOverride(byte);
  }
}

void EmulatedGrbl::Board::reset() {
  rx_.clear();
  read_ = 0;
  blocks_.clear();
  pending_.reset();
  wait_until_s_.reset();
  planned_ = position_;
  offset_ = Point3::Zero();
  reports_to_offset_ = 1;
  is_absolute_ = is_rapid_ = true;
  unit_mm_ = 1.0;
  feed_mm_min_ = spindle_ = speed_ = 0.0;
  percents_ = {};
  reports_to_overrides_ = 1;
  arrived_bytes_ = 0;
  if (state_ != State::Alarm) state_ = State::Idle;
  say("\r\n" + settings_.greeting + "\r\n");
  if (state_ == State::Alarm) say("[MSG:'$H'|'$X' to unlock]\r\n");
}

void EmulatedGrbl::Board::say(const std::string& text) {
  (held_back_.empty() ? ready_ : held_back_.back().second) += text;
}

void EmulatedGrbl::Board::report() {
  const char* state = "Idle";
  if (state_ == State::Run) state = "Run";
  if (state_ == State::Slowing) state = "Hold:1";
  if (state_ == State::Held) state = "Hold:0";
  if (state_ == State::Alarm) state = "Alarm";
  const auto used = static_cast<int>(rx_.size() - read_);
  std::string text = std::string("<") + state + "|MPos:" + grblAxes(position_) +
                     "|Bf:" + std::to_string(settings_.blocks - static_cast<int>(blocks_.size())) + "," +
                     std::to_string(settings_.receive_bytes - used) + "|FS:0," +
                     std::to_string(static_cast<int>(spindleSpeed()));
  if (--reports_to_offset_ <= 0) {
    reports_to_offset_ = kReportsBetweenOffsets;
    text += "|WCO:" + grblAxes(offset_);
  }
  if (--reports_to_overrides_ <= 0) {
    reports_to_overrides_ = kReportsBetweenOverrides;
    text += "|Ov:" + std::to_string(percents_.feed) + "," + std::to_string(percents_.rapid) + "," +
            std::to_string(percents_.spindle);
  }
  say(text + ">\r\n");
}

// Time.

void EmulatedGrbl::Board::elapse(double now) {
  for (; !held_back_.empty() && held_back_.front().first <= now; held_back_.pop_front())
    ready_ += held_back_.front().second;
  work(now);
}

void EmulatedGrbl::Board::advance(double now) {
  double passed = std::max(now - clock_s_, 0.0);
  clock_s_ = std::max(clock_s_, now);
  if (state_ == State::Slowing && now >= still_at_s_) state_ = State::Held;
  while (state_ == State::Run && !blocks_.empty()) {
    if (block_left_s_ > passed + kGrblTimeRounding) {
      block_left_s_ -= passed;
      return;
    }
    passed = std::max(passed - block_left_s_, 0.0);
    position_ = blocks_.front().end;
    blocks_.pop_front();
    block_left_s_ = blocks_.empty() ? 0.0 : blocks_.front().seconds;
  }
  if (state_ == State::Run) state_ = State::Idle;
}

void EmulatedGrbl::Board::work(double now) {
  if (isAsleep(now)) return;
  advance(now);
  applyOverrides();
  while (!is_link_cut_) {
    if (state_ == State::Held || state_ == State::Slowing) return;
    if (pending_ ? !tryFinish(now) : !readLine(now)) return;
  }
}

double EmulatedGrbl::Board::nextDeadline() const {
  double deadline = held_back_.empty() ? kForever : held_back_.front().first;
  if (isAsleep(clock_s_)) return std::min(deadline, asleep_until_s_);
  if (state_ == State::Run && !blocks_.empty()) deadline = std::min(deadline, clock_s_ + block_left_s_);
  if (state_ == State::Slowing) deadline = std::min(deadline, still_at_s_);
  if (wait_until_s_ && state_ == State::Idle) deadline = std::min(deadline, *wait_until_s_);
  return deadline;
}

EmulatedGrbl::EmulatedGrbl(EmulatedGrblSettings settings, std::vector<GrblFault> faults, Observer observer)
    : board_(std::make_unique<Board>(std::move(settings), std::move(faults), std::move(observer))) {}
EmulatedGrbl::~EmulatedGrbl() = default;

void EmulatedGrbl::receive(std::string_view bytes, double now) { board_->receive(bytes, now); }
void EmulatedGrbl::elapse(double now) { board_->elapse(now); }
std::string EmulatedGrbl::takeOutput() { return board_->takeOutput(); }
double EmulatedGrbl::nextDeadline() const { return board_->nextDeadline(); }
bool EmulatedGrbl::takeDisconnect() { return board_->takeDisconnect(); }
Point3 EmulatedGrbl::position() const { return board_->position(); }
double EmulatedGrbl::spindleSpeed() const { return board_->spindleSpeed(); }
bool EmulatedGrbl::isInMotion() const { return board_->isInMotion(); }
std::uint64_t EmulatedGrbl::faults() const { return board_->faults(); }
std::uint64_t EmulatedGrbl::bytesLost() const { return board_->bytesLost(); }

}  // namespace lamina
