// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>
#include <functional>
#include <string>

#include "actions/run_outcome.hpp"

class QLabel;
class QProgressBar;
class QPushButton;

namespace lamina {

/// How the last run stands; shown by the light.
enum class RunState {
  Idle,     ///< grey
  Running,  ///< amber
  Done,     ///< green
  Failed,   ///< red
};

/// How a run stands that has ended so.
RunState stateAfter(RunOutcome::End end);

/// What stands on a strip.
struct RunLabels {
  const char* run = "Run";
  const char* cancel = "Cancel";
  const char* hint = "choose a program and press Run";  ///< before the first run
  const char* prefix = "";  ///< of the names of its widgets, where a window has two strips
};

/// Run and Cancel, the light with a message beside it, progress and elapsed time.
class RunStrip : public QWidget {
 public:
  RunStrip(const RunLabels& labels, QWidget* parent);

  std::function<void()> run_pressed;
  std::function<void()> cancel_pressed;

  /// Amber; the time begins to count.
  void begin(const std::string& message);
  /// @param fraction  of this stage, 0 to 1
  void progress(const std::string& stage, double fraction);
  /// The time stops.
  void end(RunState state, const std::string& message);

  RunState state() const { return state_; }

  /// Idle, and not to be run until it is released; the message says why.
  void block(const std::string& reason);
  /// Idle, and ready to be run.
  void release(const std::string& hint);

 private:
  void showState(RunState state, const std::string& message);
  void showTime();

  RunState state_ = RunState::Idle;
  bool is_blocked_ = false;
  QPushButton* run_;
  QPushButton* cancel_;
  QProgressBar* bar_;
  QLabel* light_;
  QLabel* message_;
  QLabel* time_;
  QElapsedTimer clock_;
  QTimer tick_;
};

}  // namespace lamina
