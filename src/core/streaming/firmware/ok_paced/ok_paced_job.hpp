// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <cstdio>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lamina/base/text.hpp"
#include "streaming/firmware/ok_paced/lines_under_way.hpp"
#include "streaming/firmware/ok_paced/motion_tracker.hpp"
#include "streaming/firmware/ok_paced/ok_paced_firmware.hpp"
#include "streaming/firmware/ok_paced/ok_paced_stop.hpp"
#include "streaming/firmware/ok_paced/paced_lines.hpp"
#include "streaming/firmware/ok_paced/paced_questions.hpp"
#include "streaming/firmware/ok_paced/report_poll.hpp"
#include "streaming/firmware/ok_paced/unanswered_commands.hpp"
#include "streaming/job/answer_timer.hpp"
#include "streaming/job/job_record.hpp"
#include "streaming/job/layer_pause.hpp"
#include "streaming/job/layer_wait.hpp"
#include "streaming/job/line_account.hpp"
#include "streaming/job/line_feed.hpp"
#include "streaming/job/reply_lines.hpp"
#include "streaming/job/revised_lines.hpp"
#include "streaming/job/used_outputs.hpp"

namespace lamina {

/// Streams to firmware that answers `ok` to each line and requests none again.
///
/// On a reliable link oks are counted. If oks are missing, and at the end, the answer to a numbered question
/// shows that all lines before it were read. On a lossy link only one line is sent at a time. If its ok is
/// missing, the machine's position decides whether the line was run; if the position is inconclusive, the job
/// ends.
class OkPacedJob final : public StreamJob {
 public:
  OkPacedJob(StreamOrder order, std::shared_ptr<const OkPacedFirmware> firmware);

  void start(double now) override;
  void receive(std::string_view bytes, double now) override;
  void elapse(double now) override;
  void disconnect(const std::string& why, double now) override;
  void reconnect(double now) override;
  bool isOffline() const override { return phase_ == Phase::Offline; }
  bool pause(double now) override;
  bool resume(double now) override;
  std::string change(const LiveChange& change, double now) override;
  void abort(const Failure& why, double now) override;

  std::string takeOutput() override;
  double nextDeadline() const override;
  const StreamStatus& status() const override { return record_.status; }
  std::vector<PackmlState> takeStateChanges() override { return record_.takeStateChanges(); }

 private:
  enum class Phase {
    Idle,
    Opening,   ///< the answer to opening_[step_]
    Locating,  ///< the answer to the last question, and that nothing else is under way
    Feeding,   ///< answers to the lines under way
    Stopping,  ///< confirmation of the safe stop
    Offline,   ///< the link to come back, for the safe stop
  };
  /// Purpose of the last question.
  enum class Aim {
    Begin,  ///< to begin with the first line
    Doubt,  ///< to find out whether the unanswered line was run
    Base,   ///< to know the machine's position before the next line
    End,    ///< to make sure that all lines were read
  };

  bool isStopping() const { return record_.isStopping(); }
  bool isLossy() const { return settings_.link == LinkKind::Lossy; }
  bool isWaiting() const;
  double silenceLimit() const;
  void beginPhase(Phase phase, double now);
  void send(const std::string& command, PacedCommand as);
  bool hasRoomFor(std::size_t commands) const;
  bool leavesRoomForStop() const;
  void ask();

  void onReply(const PacedReply& heard, double now);
  void onKind(const FirmwareReply& reply, double now);
  void onOk(double now);
  void onOpeningOk(double now);
  void onAnswer(const SyncAnswer& answer, double now);
  void onRefusal(const FirmwareReply& reply, double now);
  /// A heater that RepRapFirmware has switched off ("Heater 1 fault: ...") ends a begun job, whether lines
  /// are under way or not.
  /// @return whether the reply reports one
  bool failsByHeater(const FirmwareReply& reply, double now) {
    const std::string text = lowerCase(reply.text);
    const std::size_t heater = text.find("heater ");
    int number = 0;
    std::array<char, 6> what{};
    if (!has_begun_ || isStopping() || heater == std::string::npos) return false;
    if (std::sscanf(text.c_str() + heater, "heater %d %5s", &number, what.data()) != 2) return false;
    if (std::string(what.data()) != "fault") return false;
    fail(ErrorCode::DeviceError, "the machine reports \"" + reply.text + "\"", now);
    return true;
  }
  void onHalt(const FirmwareReply& reply, double now);
  void onReason();
  void onRestart(const FirmwareReply& reply, double now);
  void onNotDone(const FirmwareReply& reply);

  void askOpening(double now);
  void locate(Aim aim, double now);
  void onLocated(double now);
  void decide(double now);
  void sendChanges();
  /// Ends Klipper's own pause: Klipper does not pause again before.
  void endPauseOfMachine() {
    const std::string command = firmware_->resumption();
    if (std::exchange(is_paused_by_machine_, false) && !command.empty()) waiting_changes_.push_back(command);
  }
  void proceed(double now);
  void pump(double now);
  bool sendNext(double now);
  void poll(double now);
  void onAllTaken(double now);
  void awaitLayer(double now);
  bool isAwaitingLayer() const {
    return layer_wait_.isUnderWay() && phase_ == Phase::Feeding &&
           record_.status.state == PackmlState::Execute;
  }
  void acknowledge(const PacedCommand& command, double now);
  std::optional<ProgramLine> nextLine();

  void fail(ErrorCode code, const std::string& what, double now) {
    abort({code, what + record_.whereItStands()}, now);
  }
  void retry(double now);
  void timeOut(double now);
  void prepareStop(double now);
  void sendStop(double now);
  void repeatStop(double now);
  void prolongStop(double now);
  void onStopTimeout(double now);
  void onStopAnswer(double now);
  void finishAborted(const std::string& remark);

  StreamSettings settings_;
  std::shared_ptr<const OkPacedFirmware> firmware_;
  ReplyListener heard_;
  JobRecord record_;
  StreamableProgram checked_program_;
  std::shared_ptr<RevisedLines> revised_;  ///< null if the lines are sent unchanged
  PacedLines lines_;
  Quotation quotation_;  ///< of the program
  LayerWait layer_wait_;
  LineFeed feed_;
  LineAccount account_;
  LinesUnderWay under_way_;
  /// Commands of changes that were accepted and are not sent yet, on a lossy link.
  std::deque<std::string> waiting_changes_;
  UnansweredCommands unanswered_;
  UsedOutputs outputs_;
  LayerPause layer_pause_;
  MotionTracker tracker_;
  AnswerTimer timer_;
  ReportPoll reports_;
  std::vector<std::string> opening_;
  std::vector<std::string> opening_answer_;
  OkPacedStop stop_;
  std::size_t step_ = 0;
  std::string not_yet_;  ///< why the opening waits
  Phase phase_ = Phase::Idle;
  Aim aim_ = Aim::Begin;
  bool has_begun_ = false;  ///< whether a line of the program may have been sent
  bool has_answered_ = false;
  bool is_paused_by_machine_ = false;
  std::uint64_t next_number_ = 1;
  PacedQuestions questions_;  ///< questions since the phase began
  double longest_motion_s_ = 0.0;
  ReplyLines replies_;
  std::string output_;
};

}  // namespace lamina
