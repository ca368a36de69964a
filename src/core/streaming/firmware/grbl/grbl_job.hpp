// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lamina/streaming/job/firmware_protocol.hpp"
#include "streaming/firmware/grbl/expected_position.hpp"
#include "streaming/firmware/grbl/grbl_machine.hpp"
#include "streaming/firmware/grbl/grbl_overrides.hpp"
#include "streaming/firmware/grbl/grbl_place.hpp"
#include "streaming/firmware/grbl/grbl_program_check.hpp"
#include "streaming/firmware/grbl/grbl_resumption.hpp"
#include "streaming/firmware/grbl/grbl_standstill.hpp"
#include "streaming/firmware/grbl/grbl_start.hpp"
#include "streaming/firmware/grbl/grbl_starvation.hpp"
#include "streaming/firmware/grbl/grbl_stop.hpp"
#include "streaming/firmware/grbl/grbl_window.hpp"
#include "streaming/job/answer_timer.hpp"
#include "streaming/job/job_record.hpp"
#include "streaming/job/layer_pause.hpp"
#include "streaming/job/line_feed.hpp"
#include "streaming/job/reply_lines.hpp"

namespace lamina {

/// Streams to firmware of the grbl family, which answers each line once, in order, and '?' at any time.
class GrblJob final : public StreamJob {
 public:
  explicit GrblJob(StreamOrder order);

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
  /// What the job waits for.
  enum class Phase {
    Idle,      ///< nothing
    Starting,  ///< the machine to be idle and identified
    Locating,  ///< the position of a machine whose job is resumed
    Checking,  ///< the check of the remaining program against the machine's abilities
    Feeding,   ///< answers to the lines under way
    Proving,   ///< the answer to a question after the last line
    Resting,   ///< the end of all motions
    Stopping,  ///< the safe stop to be confirmed
    Offline,   ///< the link to come back, for the safe stop
  };

  PackmlState state() const { return record_.status.state; }
  bool isRunning() const {
    return phase_ == Phase::Feeding || phase_ == Phase::Proving || phase_ == Phase::Resting;
  }

  void onReply(const GrblReply& reply, double now);
  void followStart(double now);
  void followStop(double now);
  void beginChecking(double now);
  void check(double now);
  void beginLocating(double now);
  void continueOncePlaced(double now);
  void continueAt(const GrblAxes& work, double now);
  void execute(double now);

  void proceed(double now);
  void pump(double now);
  void ask();
  void prove(double now);

  void onAnswered(double now);
  void onOk(double now);
  void onError(int code, double now);
  void onModes(double now);
  void onAlarm(const std::string& code_text, int code, double now);
  void onReport(const GrblReport& report, double now);
  void onMotionState(const GrblReport& report, double now);
  void onStandstill(double now);
  void onMoving(double now);
  void followOverrides(const GrblReport& report, double now);
  bool isHeldBack(const ProgramLine& line, double now);
  void holdAtLayer(const GrblReport& report, double now);
  void countStarvation(const GrblReport& report, double now);
  void finish(double now);

  void poll(double now);
  void onNoAnswer(double now);
  double silenceLimit() const;
  double answerLimit() const;
  bool isAnswerDue() const;
  void release(double now);
  void loseCount(const std::string& what, double now);
  void stop(GrblStop::Motion motion, double now);
  void finishAborted(const std::string& remark);

  StreamOrder order_;
  JobRecord record_;
  LineFeed feed_;
  GrblStart start_;
  std::optional<GrblStop> stop_;
  std::optional<GrblProgramCheck> check_;
  ExpectedPosition expected_{""};
  GrblWindow window_;
  GrblOverrides overrides_;
  LayerPause layer_pause_;
  bool is_at_layer_ = false;  ///< whether no line is sent until the machine stands still and holds
  AnswerTimer answers_;
  Phase phase_ = Phase::Idle;
  double next_poll_s_ = 0.0;
  double heard_s_ = 0.0;
  double locate_by_s_ = 0.0;
  GrblState machine_state_ = GrblState::Other;  ///< as last reported
  int machine_substate_ = 0;
  GrblPlace place_;
  GrblStandstill standstill_;
  GrblStarvation starvation_;
  bool has_begun_ = false;  ///< whether a line of the program may have been sent
  bool is_held_by_user_ = false;
  bool is_resume_wanted_ = false;
  double release_again_s_ = 0.0;
  double safe_stop_by_s_ = 0.0;
  ReplyLines replies_;
  std::string output_;
};

}  // namespace lamina
