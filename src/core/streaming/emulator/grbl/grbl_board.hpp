// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lamina/base/random.hpp"
#include "lamina/streaming/emulator/grbl/emulated_grbl.hpp"
#include "streaming/emulator/grbl/grbl_overriding.hpp"

namespace lamina {

/// Implementation of the emulated grbl.
class EmulatedGrbl::Board {
 public:
  Board(EmulatedGrblSettings settings, std::vector<GrblFault> faults, Observer observer);

  void receive(std::string_view bytes, double now);
  void elapse(double now);
  std::string takeOutput() { return std::exchange(ready_, {}); }
  double nextDeadline() const;
  bool takeDisconnect() { return std::exchange(is_link_cut_, false); }

  const Point3& position() const { return position_; }
  double spindleSpeed() const { return 0.01 * overriding_.percents().spindle * spindle_; }
  bool isInMotion() const { return state_ == State::Run || state_ == State::Slowing; }
  std::uint64_t faults() const { return fault_count_; }
  std::uint64_t bytesLost() const { return bytes_lost_; }

 private:
  enum class State { Idle, Run, Slowing, Held, Alarm };

  struct Block {
    Point3 end = Point3::Zero();
    double seconds = 0.0;
  };
  /// A line that is being run and has no answer yet.
  struct Pending {
    std::optional<Block> block;
    bool needs_rest = false;  ///< whether the line ends only when all motions have ended
    bool pauses = false;      ///< whether the machine holds after the motions
    double wait_s = 0.0;      ///< dwell after the motions
    std::optional<double> spindle;
    bool loses_ok = false;
    bool delays_ok = false;
  };
  /// What the words of a line ask for.
  struct Wish {
    Point3 axes = Point3::Zero();
    std::array<bool, 3> has_axis{};
    bool sets_offset = false;
    bool dwells = false;
    double dwell_s = 0.0;
    Pending pending;
  };

  // Bytes.
  bool obey(char byte, double now);
  void store(char byte);
  std::optional<char> throughFaults(char byte);
  bool strikes(GrblFaultKind kind, std::uint64_t line);
  bool strikesOnArrival(std::uint64_t line, double now);

  // Lines.
  void work(double now);
  bool readLine(double now);
  void run(const std::string& line, double now);
  void runDollar(const std::string& line);
  int parse(const std::string& line, Wish& wish);
  int parseG(int tenfold, Wish& wish);
  int parseM(int number, Wish& wish);
  bool tryFinish(double now);
  void say(const std::string& text);
  void report();
  void reset();

  void advance(double now);
  bool isAsleep(double now) const { return now < asleep_until_s_; }

  EmulatedGrblSettings settings_;
  std::vector<GrblFault> faults_;
  Observer observer_;
  Random random_;
  State state_;
  std::string rx_;            ///< bytes received
  std::size_t read_ = 0;      ///< number of bytes of `rx_` that were read
  std::deque<Block> blocks_;  ///< the first one runs
  double block_left_s_ = 0.0;
  double clock_s_ = 0.0;
  double still_at_s_ = 0.0;  ///< time at which the machine has slowed down
  std::optional<Pending> pending_;
  std::optional<double> wait_until_s_;

  // Modes.
  Point3 position_ = Point3::Zero();
  Point3 planned_ = Point3::Zero();
  Point3 offset_ = Point3::Zero();
  bool is_absolute_ = true;
  bool is_rapid_ = true;
  double unit_mm_ = 1.0;
  double feed_mm_min_ = 0.0;
  double spindle_ = 0.0;
  double speed_ = 0.0;
  int reports_to_offset_ = 1;  ///< number of reports until the offset is reported again
  GrblOverriding overriding_;

  // Faults.
  std::uint64_t arriving_ = 1;     ///< number of the line whose bytes arrive
  std::size_t arrived_bytes_ = 0;  ///< number of bytes of that line so far
  char first_byte_ = '\n';         ///< first byte of that line
  std::optional<std::size_t> loses_at_;
  std::optional<std::size_t> changes_at_;
  std::uint64_t run_lines_ = 0;
  double asleep_until_s_ = -1.0;
  std::string ready_;
  std::deque<std::pair<double, std::string>> held_back_;
  bool is_link_cut_ = false;
  std::uint64_t fault_count_ = 0;
  std::uint64_t bytes_lost_ = 0;
};

}  // namespace lamina
