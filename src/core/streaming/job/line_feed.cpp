// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/job/line_feed.hpp"

#include <algorithm>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include "lamina/streaming/job/streamable_program.hpp"
#include "streaming/job/motion_time.hpp"

namespace lamina {
namespace {

/// Reads a program's file a thousand lines ahead in a thread of its own, so that a slow disk or network
/// folder does not stop the machine. It ends early if the file is changed, since its new content was not
/// checked.
class ReadAhead {
 public:
  /// @throws FileError if the file is gone
  explicit ReadAhead(const StreamableProgram& program);
  ~ReadAhead();
  ReadAhead(const ReadAhead&) = delete;
  ReadAhead& operator=(const ReadAhead&) = delete;

  /// The next line; waits for it if necessary. None at the end.
  std::optional<ProgramLine> next();

 private:
  using Batch = std::vector<ProgramLine>;

  void run();
  Batch readBatch();
  bool hand(Batch batch);

  StreamableProgram program_;
  ProgramCursor cursor_;
  MotionTime time_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Batch> read_;
  bool is_over_ = false;  ///< nothing more is read, or wanted
  Batch current_;
  std::size_t given_ = 0;  ///< lines of the current batch
  std::thread thread_;
};

constexpr std::size_t kBatchLines = 128;
constexpr std::size_t kBatches = 8;

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

// Far more than any window: firmware asks for lines it has just missed.
constexpr std::size_t kRememberedLines = 1024;

}  // namespace

LineFeed::Source sourceOf(const StreamableProgram& program) {
  if (program.isHeld()) {
    return [cursor = std::make_shared<ProgramCursor>(program.open()),
            time = std::make_shared<MotionTime>()]() -> std::optional<ProgramLine> {
      auto line = cursor->next();
      if (line) line->seconds = time->secondsOf(line->command);
      return line;
    };
  }
  return [ahead = std::make_shared<ReadAhead>(program)] { return ahead->next(); };
}

LineFeed::Source restOf(const StreamableProgram& program, std::uint64_t lines_left_out,
                        const std::function<void(const ProgramLine&)>& passed) {
  LineFeed::Source source = sourceOf(program);
  for (std::uint64_t i = 0; i < lines_left_out; ++i)
    if (const auto line = source()) passed(*line);
  return source;
}

LineFeed::Source sourceOf(std::vector<std::string> commands) {
  std::reverse(commands.begin(), commands.end());
  return [left = std::move(commands)]() mutable -> std::optional<ProgramLine> {
    if (left.empty()) return std::nullopt;
    ProgramLine line{left.back(), -1, 0.0};
    left.pop_back();
    return line;
  };
}

const ProgramLine* LineFeed::peek() {
  const std::size_t index = next_ - first_kept_;
  if (index < kept_.size()) return &kept_[index];
  auto line = source_();
  if (!line) return nullptr;
  kept_.push_back(std::move(*line));
  has_unsent_ = true;
  return &kept_.back();
}

void LineFeed::advance() {
  if (next_ == end()) has_unsent_ = false;
  ++next_;
  if (kept_.size() <= kRememberedLines) return;
  kept_.pop_front();
  ++first_kept_;
}

bool LineFeed::rewind(std::uint64_t number) {
  if (number < first_kept_ || number > end()) return false;
  next_ = number;
  return true;
}

std::int32_t LineFeed::layerOf(std::uint64_t number) const {
  if (number == line_before_) return layer_before_;
  if (number < first_kept_ || number >= first_kept_ + kept_.size()) return -1;
  return kept_[number - first_kept_].layer;
}

}  // namespace lamina
