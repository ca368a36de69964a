// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <atomic>
#include <functional>
#include <string>
#include <thread>

#include "drawing/drawn_part.hpp"

namespace lamina {

/// Reads programs in a thread of its own and gives them to the window's thread.
class BackgroundReader {
 public:
  using Deliver = std::function<void(DrawnPart part)>;

  explicit BackgroundReader(std::string frame) : frame_(std::move(frame)) {}
  ~BackgroundReader() { stop(); }
  BackgroundReader(const BackgroundReader&) = delete;
  BackgroundReader& operator=(const BackgroundReader&) = delete;

  /// Gives up what is being read, and reads another.
  /// @param deliver  called in the thread that runs the window's events
  void read(const std::string& path, Deliver deliver);
  /// Returns soon; nothing is delivered afterwards.
  void stop();

 private:
  std::string frame_;
  std::atomic<bool> is_cancelled_{false};
  std::thread thread_;
  std::size_t number_ = 0;  ///< of the last reading: what was delivered late by another is dropped
  QObject receiver_;        ///< in the window's thread
};

}  // namespace lamina
