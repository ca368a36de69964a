// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/web/program_preview.hpp"

#include <optional>
#include <utility>

#include "lamina/base/error.hpp"

namespace lamina {

/// What reading a program has come to.
struct ProgramPreview::Read {
  std::string program;
  std::vector<LayerPreview> layers;
  std::optional<std::string> failure;
};

ProgramPreview::ProgramPreview(PreviewReader reader)
    : reader_(std::move(reader)), thread_([this] { run(); }) {}

ProgramPreview::~ProgramPreview() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    is_ending_ = true;
    is_unwanted_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

ShownPreview ProgramPreview::layer(const std::string& program, std::int32_t layer) {
  std::shared_ptr<const Read> read;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (wanted_ != program) {
      wanted_ = program;
      is_unwanted_ = true;
      changed_.notify_all();
    }
    read = read_;
  }
  ShownPreview shown;
  shown.is_being_read = !read || read->program != program;
  if (shown.is_being_read) return shown;
  if (read->failure) throw InvalidInput(*read->failure);
  if (layer >= 0 && static_cast<std::size_t>(layer) < read->layers.size())
    shown.layer = read->layers[static_cast<std::size_t>(layer)];
  return shown;
}

void ProgramPreview::run() {
  std::unique_lock<std::mutex> lock(mutex_);
  while (true) {
    changed_.wait(
        lock, [this] { return is_ending_ || (!wanted_.empty() && !(read_ && read_->program == wanted_)); });
    if (is_ending_) return;
    auto read = std::make_shared<Read>();
    read->program = wanted_;
    read_.reset();  // the layers of the former program need not be kept beside those of this one
    is_unwanted_ = false;
    lock.unlock();
    try {
      read->layers = reader_(read->program, is_unwanted_);
    } catch (...) {
      read->failure = currentFailure().message;
    }
    lock.lock();
    if (read->program == wanted_) read_ = read;
  }
}

}  // namespace lamina
