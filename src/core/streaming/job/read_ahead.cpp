// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/job/read_ahead.hpp"

#include <utility>

namespace lamina {
namespace {

constexpr std::size_t kBatchLines = 128;
constexpr std::size_t kBatches = 8;

}  // namespace

ReadAhead::ReadAhead(const StreamableProgram& program) : program_(program), cursor_(program.open()) {
  thread_ = std::thread([this] { run(); });
}

ReadAhead::~ReadAhead() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    is_over_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

std::optional<ProgramLine> ReadAhead::next() {
  if (given_ == current_.size()) {
    std::unique_lock<std::mutex> lock(mutex_);
    changed_.wait(lock, [this] { return !read_.empty() || is_over_; });
    if (read_.empty()) return std::nullopt;
    current_ = std::move(read_.front());
    read_.pop_front();
    given_ = 0;
    lock.unlock();
    changed_.notify_all();
  }
  return std::move(current_[given_++]);
}

void ReadAhead::run() {
  while (true) {
    Batch batch = readBatch();
    // Read before it was looked at, so that nothing unchecked is in it.
    const bool is_last = batch.size() < kBatchLines || program_.hasChanged();
    if (program_.hasChanged()) batch.clear();
    if (!hand(std::move(batch)) || is_last) break;
  }
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    is_over_ = true;
  }
  changed_.notify_all();
}

ReadAhead::Batch ReadAhead::readBatch() {
  Batch batch;
  batch.reserve(kBatchLines);
  while (batch.size() < kBatchLines) {
    auto line = cursor_.next();
    if (!line) break;
    line->seconds = time_.secondsOf(line->command);
    batch.push_back(std::move(*line));
  }
  return batch;
}

/// @return false if no more is wanted
bool ReadAhead::hand(Batch batch) {
  std::unique_lock<std::mutex> lock(mutex_);
  changed_.wait(lock, [this] { return read_.size() < kBatches || is_over_; });
  if (is_over_) return false;
  if (!batch.empty()) read_.push_back(std::move(batch));
  lock.unlock();
  changed_.notify_all();
  return true;
}

}  // namespace lamina
