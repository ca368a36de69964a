// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cctype>
#include <cmath>
#include <cstdlib>

#include "streaming/emulator/grbl/grbl_board.hpp"

namespace lamina {
namespace {

enum GrblErrorCode {
  kTaken = 0,
  kNoLetter = 1,
  kNoNumber = 2,
  kNotADollar = 3,
  kLocked = 9,
  kTooLong = 11,
  kUnknown = 20,
  kNoFeed = 22,
  kRepeated = 25,
};

constexpr double kInch = 25.4;  // mm
constexpr std::size_t kLongestLine = 79;

/// As grbl keeps it: without blanks and control characters, in upper case, cut at a comment.
std::string condensed(std::string_view line) {
  std::string kept;
  for (const char c : line) {
    if (c == ';' || c == '(') break;
    if (c > ' ' && c != '/') kept += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  return kept;
}

}  // namespace

bool EmulatedGrbl::Board::readLine(double now) {
  const std::size_t end = rx_.find_first_of("\r\n", read_);
  if (end == std::string::npos) return false;
  const std::string line = rx_.substr(read_, end - read_);
  read_ = end + 1;
  constexpr std::size_t kMostRead = 4096;
  if (read_ == rx_.size() || read_ > kMostRead) rx_.erase(0, std::exchange(read_, 0));
  run(line, now);
  return true;
}

void EmulatedGrbl::Board::run(const std::string& line, double now) {
  const std::string text = condensed(line);
  if (text.empty()) return say("ok\r\n");
  if (text[0] == '$') return runDollar(text);
  const auto refuse = [this](int code) { say("error:" + std::to_string(code) + "\r\n"); };
  if (text.size() > kLongestLine) return refuse(kTooLong);
  if (state_ == State::Alarm) return refuse(kLocked);
  if (text.compare(0, 4, "M115") == 0) return refuse(kUnknown);
  ++run_lines_;
  if (strikes(GrblFaultKind::Error, run_lines_)) return refuse(kUnknown);
  if (strikes(GrblFaultKind::Alarm, run_lines_)) {
    state_ = State::Alarm;
    blocks_.clear();
    return say("ALARM:1\r\n[MSG:Reset to continue]\r\n");
  }
  Wish wish;
  const int code = parse(text, wish);
  if (code != kTaken) return refuse(code);
  if (observer_) observer_(line);
  pending_ = wish.pending;
  pending_->loses_ok = strikes(GrblFaultKind::LostOk, run_lines_);
  pending_->delays_ok = strikes(GrblFaultKind::DelayedOk, run_lines_);
  tryFinish(now);
}

void EmulatedGrbl::Board::runDollar(const std::string& line) {
  if (line == "$I") {
    say(settings_.version + "\r\n" + settings_.options + "\r\nok\r\n");
  } else if (line == "$G") {
    say(std::string("[GC:G") + (is_rapid_ ? "0" : "1") + " G54 G17 " + (unit_mm_ == 1.0 ? "G21" : "G20") +
        (is_absolute_ ? " G90" : " G91") + " G94 M5 M9 T0 F" +
        std::to_string(std::lround(feed_mm_min_ / unit_mm_)) + " S0]\r\nok\r\n");
  } else if (line == "$$") {
    say("$10=3\r\n$13=0\r\n$32=0\r\nok\r\n");
  } else if (line == "$X") {
    if (state_ == State::Alarm) say("[MSG:Caution: Unlocked]\r\n");
    if (state_ == State::Alarm) state_ = State::Idle;
    say("ok\r\n");
  } else {
    say("error:" + std::to_string(kNotADollar) + "\r\n");
  }
}

int EmulatedGrbl::Board::parseG(int tenfold, Wish& wish) {
  switch (tenfold) {
    case 0:
    case 10:
    case 20:
    case 30:
      is_rapid_ = tenfold == 0;
      return kTaken;
    case 40:
      wish.dwells = wish.pending.needs_rest = true;
      return kTaken;
    case 200:
      unit_mm_ = kInch;
      return kTaken;
    case 210:
      unit_mm_ = 1.0;
      return kTaken;
    case 900:
      is_absolute_ = true;
      return kTaken;
    case 910:
      is_absolute_ = false;
      return kTaken;
    case 920:
      wish.sets_offset = true;
      return kTaken;
    case 170:
    case 540:
    case 940:
      return kTaken;
    default:
      return kUnknown;
  }
}

int EmulatedGrbl::Board::parseM(int number, Wish& wish) {
  switch (number) {
    case 0:
      wish.pending.needs_rest = wish.pending.pauses = true;
      return kTaken;
    case 3:
    case 4:
      wish.pending.needs_rest = true;
      wish.pending.spindle = 1.0;
      return kTaken;
    case 5:
    case 2:
    case 30:
      wish.pending.needs_rest = true;
      wish.pending.spindle = 0.0;
      return kTaken;
    case 8:
    case 9:
      wish.pending.needs_rest = true;
      return kTaken;
    default:
      return kUnknown;
  }
}

/// Modes that a refused line has set stay set, which grbl does better.
int EmulatedGrbl::Board::parse(const std::string& line, Wish& wish) {
  const char* at = line.c_str();
  while (*at != '\0') {
    const char letter = *at++;
    if (letter < 'A' || letter > 'Z') return kNoLetter;
    char* end = nullptr;
    const double value = std::strtod(at, &end);
    if (end == at) return kNoNumber;
    at = end;
    int code = kTaken;
    if (letter >= 'X' && letter <= 'Z') {
      const auto axis = static_cast<std::size_t>(letter - 'X');
      if (std::exchange(wish.has_axis[axis], true)) return kRepeated;
      wish.axes[static_cast<int>(axis)] = value;
    } else if (letter == 'G') {
      code = parseG(static_cast<int>(std::lround(10.0 * value)), wish);
    } else if (letter == 'M') {
      code = parseM(static_cast<int>(value), wish);
    } else if (letter == 'F') {
      feed_mm_min_ = unit_mm_ * value;
    } else if (letter == 'S') {
      speed_ = value;
    } else if (letter == 'P') {
      wish.dwell_s = value;
    } else if (std::string_view("IJKLNRT").find(letter) == std::string_view::npos) {
      code = kUnknown;
    }
    if (code != kTaken) return code;
  }
  if (wish.dwells) wish.pending.wait_s = wish.dwell_s;
  if (wish.pending.spindle) *wish.pending.spindle *= speed_;
  if (!(wish.has_axis[0] || wish.has_axis[1] || wish.has_axis[2])) return kTaken;
  Point3 target = planned_;
  for (int axis = 0; axis < 3; ++axis) {
    if (!wish.has_axis[static_cast<std::size_t>(axis)]) continue;
    const double value = unit_mm_ * wish.axes[axis];
    if (wish.sets_offset) {
      offset_[axis] = planned_[axis] - value;
      reports_to_offset_ = 1;
    } else {
      target[axis] = is_absolute_ ? value + offset_[axis] : planned_[axis] + value;
    }
  }
  if (wish.sets_offset) return kTaken;
  if (!is_rapid_ && !(feed_mm_min_ > 0.0)) return kNoFeed;
  constexpr double kMinute = 60.0;  // s
  const double speed = (is_rapid_ ? settings_.rapid_mm_min : feed_mm_min_) / kMinute;
  wish.pending.block = Block{target, (target - planned_).norm() / speed};
  planned_ = target;
  return kTaken;
}

bool EmulatedGrbl::Board::tryFinish(double now) {
  if (pending_->block) {
    if (blocks_.size() >= static_cast<std::size_t>(settings_.blocks)) return false;
    if (blocks_.empty()) block_left_s_ = pending_->block->seconds;
    blocks_.push_back(*pending_->block);
    pending_->block.reset();
    if (state_ == State::Idle) state_ = State::Run;
  }
  if (pending_->needs_rest && !blocks_.empty()) return false;
  if (pending_->wait_s > 0.0) {
    wait_until_s_ = now + std::exchange(pending_->wait_s, 0.0);
  }
  if (wait_until_s_ && now < *wait_until_s_) return false;
  wait_until_s_.reset();
  if (std::exchange(pending_->pauses, false)) {
    state_ = State::Held;
    return false;
  }
  if (pending_->spindle) spindle_ = *pending_->spindle;
  const Pending done = *std::exchange(pending_, std::nullopt);
  if (done.delays_ok) held_back_.emplace_back(now + settings_.delay_s, std::string());
  if (!done.loses_ok) say("ok\r\n");
  return true;
}

}  // namespace lamina
