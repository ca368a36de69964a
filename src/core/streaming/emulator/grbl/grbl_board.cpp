// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/emulator/grbl/grbl_board.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>

namespace lamina {
namespace {

constexpr double kForever = std::numeric_limits<double>::infinity();
// By which time may be short of an event that is due [s].
constexpr double kGrblTimeRounding = 1e-9;
constexpr int kReportsBetweenOffsets = 30;

std::string grblAxes(const Point3& place) {
  std::array<char, 96> text{};
  std::snprintf(text.data(), text.size(), "%.3f,%.3f,%.3f", place.x(), place.y(), place.z());
  return text.data();
}

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
      return overriding_.note(byte);
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
  overriding_.reset();
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
  say(text + overriding_.takeReport() + ">\r\n");
}

// Lines.

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
  overriding_.apply();
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
