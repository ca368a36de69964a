// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// A cell whose nodes are killed at random instants, started again as their launch files do, and gone on with
// by an operator, who sees what the topics say and nothing else. The emulated machine outlives them all; what
// it ran is the truth.
//
//   LAMINA_KILLS       kills of one node (default 3)
//   LAMINA_GROUP_KILLS kills of all nodes at once (default 1)
//   LAMINA_WRITE_KILLS kills amid a write to the journal or the progress file (default 2)
//   LAMINA_SEED        of all that is random (default 1)
#include <gtest/gtest.h>
#include <ros/ros.h>

#include <cstdlib>
#include <iostream>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "journal/database.hpp"
#include "lamina/journal/cell_journal.hpp"
#include "ros/cell/cell_of_nodes.hpp"

namespace lamina {
namespace {

using test::CellOfNodes;
using test::Command;
using test::commandsOf;
using test::squareProgram;

constexpr int kMotions = 400;  // of a job

int numberFrom(const char* variable, int otherwise) {
  const char* const text = std::getenv(variable);
  return text == nullptr ? otherwise : std::atoi(text);
}

enum class Victim { Streamer, Controller, All, StreamerInWrite, ControllerInWrite };

const char* toString(Victim victim) {
  switch (victim) {
    case Victim::Streamer:
      return "streamer";
    case Victim::Controller:
      return "controller";
    case Victim::All:
      return "all";
    case Victim::StreamerInWrite:
      return "streamer amid a write";
    case Victim::ControllerInWrite:
      return "controller amid a write";
  }
  return "";
}

/// What the journal says while nobody writes it.
struct JournalFound {
  std::string integrity;
  std::optional<std::int64_t> bad_audit;
  bool has_open_execution = false;
};

JournalFound foundIn(const std::string& path) {
  JournalFound found;
  {
    const Database database(path);
    Statement check = database.prepare("PRAGMA integrity_check");
    found.integrity = check.step() ? check.text(0) : "no answer";
    // A journal that was killed at its very beginning has no tables yet.
    Statement tables = database.prepare("SELECT count(*) FROM sqlite_master WHERE name = 'audit'");
    if (!tables.step() || tables.integer(0) == 0) return found;
  }
  const CellJournal journal(path);
  found.bad_audit = journal.firstBadAudit();
  found.has_open_execution = journal.open().has_value();
  return found;
}

/// Does what a patient operator would do, one thing at a time, by what the cell says.
class Operator {
 public:
  explicit Operator(CellOfNodes& cell) : cell_(cell) {}

  void act() {
    const std::string state = cell_.status.state_name;
    if (cell_.status.state == 0) return;
    for (const lamina_msgs::CellAlarm& alarm : cell_.alarms.alarms)
      if (!alarm.is_acknowledged) return cell_.acknowledgeAll();
    if (state == "Aborted") cell_.command(Command::CLEAR);
    if (state == "Stopped" || state == "Complete") cell_.command(Command::RESET);
    if (state == "Held") cell_.command(Command::UNHOLD);
    if (state != "Idle") return;
    if (cell_.status.is_part_on_plate && !cell_.status.resume_waits) cell_.confirmRemoval("test");
    const std::uint8_t cut_off = cell_.status.resume_waits ? Command::RESUME : Command::UNDECIDED;
    cell_.command(Command::START, cut_off, cell_.status.sequence);
  }

 private:
  CellOfNodes& cell_;
};

class KilledCell {
 public:
  KilledCell() : cell_("killed", 20.0), operator_(cell_) {}

  void printAmidst(const std::vector<Victim>& victims) {
    enqueue(1 + victims.size() / 4);
    for (const Victim victim : victims) {
      if (testing::Test::HasFailure()) return;
      meet(victim);
    }
    const bool is_done = operateUntil([this] { return isDone(); }, test::kPatience);
    ASSERT_TRUE(is_done) << "after " << said_ << ": " << cell_.status.state_name << ", " << cell_.reason
                         << ", " << cell_.machine.commands().size() << " of " << expected_.size() << " lines";
    cell_.controller->end(SIGINT);
    std::cout << kills_ << " kills, " << jobs_ << " jobs, " << expected_.size()
              << " lines; the controller was back after " << longest_absence_s_ << " s at most\n";
    checkMachine();
    checkJournal();
    EXPECT_EQ(cell_.status.parts, jobs_);
  }

 private:
  void enqueue(std::size_t jobs) {
    for (jobs_ = 0; jobs_ < jobs; ++jobs_) {
      const std::string program = squareProgram(kMotions, 0.01 * static_cast<double>(jobs_ + 1));
      for (const std::string& command : commandsOf(program)) expected_.push_back(command);
      const std::uint32_t job = cell_.enqueue(program);
      ASSERT_NE(job, 0U) << cell_.reason;
      ASSERT_EQ(cell_.change(job, lamina_msgs::ChangeQueue::Request::RELEASE), "");
    }
  }

  bool isDone() const {
    return cell_.status.parts == jobs_ && cell_.queue.jobs.empty() && cell_.status.job.id == 0;
  }

  /// Lets the operator work.
  bool operateUntil(const std::function<bool()>& is_true, double patience_s) {
    const ros::WallTime give_up = ros::WallTime::now() + ros::WallDuration(patience_s);
    while (!is_true() && ros::WallTime::now() < give_up) {
      const ros::WallTime next = ros::WallTime::now() + ros::WallDuration(0.05);
      while (ros::WallTime::now() < next && !is_true()) {
        ros::spinOnce();
        ros::WallDuration(0.005).sleep();
      }
      operator_.act();
    }
    return is_true();
  }

  double upTo(double most) { return std::uniform_real_distribution<double>(0.0, most)(random_); }

  /// The node that is to die amid a write is started so that it will.
  std::vector<std::string> dyingBy(const std::string& file, int most) {
    const int write = 1 + static_cast<int>(upTo(most));
    return {std::string("LD_PRELOAD=") + LAMINA_KILL_AT_WRITE, "LAMINA_KILL_FILE=" + file,
            "LAMINA_KILL_AT=" + std::to_string(write)};
  }

  void meet(Victim victim) {
    said_ = std::to_string(++kills_) + ". kill: " + toString(victim);
    if (victim == Victim::StreamerInWrite || victim == Victim::ControllerInWrite) return dieInWrite(victim);
    operateUntil([] { return false; }, upTo(2.0));
    const bool is_streamer_killed = victim != Victim::Controller;
    said_ += " in " + cell_.status.state_name;
    if (is_streamer_killed) cell_.streamer->end(SIGKILL);
    if (victim != Victim::Streamer) {
      cell_.controller->end(SIGKILL);
      cell_.status = {};
    }
    startAgain(is_streamer_killed, victim != Victim::Streamer);
  }

  void dieInWrite(Victim victim) {
    const bool is_streamer = victim == Victim::StreamerInWrite;
    test::NodeProcess& dying = *(is_streamer ? cell_.streamer : cell_.controller);
    dying.end(SIGKILL);
    if (is_streamer) {
      cell_.startStreamer(dyingBy(cell_.progressFile(), 40));
    } else {
      checkJournal();
      cell_.launchController(dyingBy(cell_.journalFile(), 150));
    }
    auto& node = is_streamer ? cell_.streamer : cell_.controller;
    operateUntil([&node] { return node->isOver(); }, 5.0);
    said_ += node->isOver() ? " in " : " which did not come, in ";
    said_ += cell_.status.state_name;
    node->end(SIGKILL);
    if (!is_streamer) cell_.status = {};
    startAgain(is_streamer, !is_streamer);
  }

  void startAgain(bool starts_streamer, bool starts_controller) {
    std::cout << said_ << std::endl;
    const JournalFound journal = starts_controller ? checkJournal() : JournalFound();
    if (starts_streamer) cell_.startStreamer();
    if (!starts_controller) return;
    const ros::WallTime started = ros::WallTime::now();
    cell_.startController();
    if (!starts_streamer)
      longest_absence_s_ = std::max(longest_absence_s_, (ros::WallTime::now() - started).toSec());
    checkFirstState(journal, starts_streamer);
  }

  void checkFirstState(const JournalFound& journal, bool is_streamer_new) const {
    const std::string& state = cell_.status.state_name;
    // A streamer that was not killed may have gone on, have ended, or not have begun.
    if (!journal.has_open_execution || is_streamer_new) {
      EXPECT_EQ(state, journal.has_open_execution ? "Aborted" : "Stopped") << said_;
    }
  }

  JournalFound checkJournal() const {
    JournalFound found = foundIn(cell_.journalFile());
    EXPECT_EQ(found.integrity, "ok") << said_;
    EXPECT_FALSE(found.bad_audit) << said_;
    return found;
  }

  void checkMachine() const {
    const std::vector<std::string> ran = cell_.machine.commands();
    const auto pair = std::mismatch(ran.begin(), ran.end(), expected_.begin(), expected_.end());
    const auto at = static_cast<std::size_t>(pair.first - ran.begin());
    EXPECT_EQ(ran.size(), expected_.size());
    EXPECT_EQ(at, expected_.size()) << "line " << at + 1 << " is " << (at < ran.size() ? ran[at] : "missing")
                                    << "; expected " << (at < expected_.size() ? expected_[at] : "none");
  }

  CellOfNodes cell_;
  Operator operator_;
  std::mt19937 random_{static_cast<unsigned>(numberFrom("LAMINA_SEED", 1))};
  std::vector<std::string> expected_;
  std::size_t jobs_ = 0;
  int kills_ = 0;
  double longest_absence_s_ = 0.0;
  std::string said_ = "no kill";
};

TEST(CellKills, LoseNoJobAndRunEachLineOnce) {
  std::mt19937 random(static_cast<unsigned>(numberFrom("LAMINA_SEED", 1)));
  std::vector<Victim> victims;
  for (int i = 0; i < numberFrom("LAMINA_KILLS", 3); ++i)
    victims.push_back(random() % 2 == 0 ? Victim::Streamer : Victim::Controller);
  for (int i = 0; i < numberFrom("LAMINA_GROUP_KILLS", 1); ++i) victims.push_back(Victim::All);
  for (int i = 0; i < numberFrom("LAMINA_WRITE_KILLS", 2); ++i)
    victims.push_back(i % 2 == 0 ? Victim::ControllerInWrite : Victim::StreamerInWrite);
  std::shuffle(victims.begin(), victims.end(), random);
  KilledCell cell;
  cell.printAmidst(victims);
}

}  // namespace
}  // namespace lamina
