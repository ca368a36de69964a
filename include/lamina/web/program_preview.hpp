// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "lamina/web/cell_desk.hpp"

namespace lamina {

/// Reads all layers of a program. Should return early, with any result, once `is_unwanted` is true.
using PreviewReader = std::function<std::vector<LayerPreview>(const std::string& program,
                                                              const std::atomic<bool>& is_unwanted)>;

/// The layers of a program as lines. The program that was asked for last is read once, in a thread of its
/// own, and its layers, or the failure to read them, are kept until another program is asked for. Nobody
/// waits for the reading. May be called from several threads.
class ProgramPreview {
 public:
  explicit ProgramPreview(PreviewReader reader);
  ~ProgramPreview();
  ProgramPreview(const ProgramPreview&) = delete;
  ProgramPreview& operator=(const ProgramPreview&) = delete;

  /// A layer of a program, or the information that the program is still being read.
  /// @throws InvalidInput if the program could not be read, with the reason
  ShownPreview layer(const std::string& program, std::int32_t layer);

 private:
  struct Read;
  void run();

  PreviewReader reader_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::string wanted_;
  std::atomic<bool> is_unwanted_{false};  ///< what is being read
  bool is_ending_ = false;
  std::shared_ptr<const Read> read_;
  std::thread thread_;
};

}  // namespace lamina
