// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "correction_record.hpp"

#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <exception>
#include <filesystem>
#include <future>
#include <random>
#include <thread>
#include <utility>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"

namespace lamina {
namespace {

/// Two jobs of one program are distinguished by it.
std::string anyName() {
  std::random_device source;
  char name[24];
  std::snprintf(name, sizeof name, "%08x%08x", source(), source());
  return name;
}

}  // namespace

CorrectionRecord::CorrectionRecord(std::string folder, std::string program_sha256, std::string toolpath_id,
                                   Write write, double patience_s)
    : folder_(std::move(folder)),
      write_(write ? std::move(write)
                   : [](const std::string& path, const std::string& text) { writeFile(path, text); }),
      patience_s_(patience_s),
      of_{std::move(program_sha256), std::move(toolpath_id), anyName()} {
  if (folder_.empty()) return;
  std::error_code failure;
  std::filesystem::create_directories(folder_, failure);
  if (failure) throw FileError("cannot make the folder " + folder_ + ": " + failure.message());
  if (::access(folder_.c_str(), W_OK | X_OK) != 0)
    throw FileError("cannot record corrections in the folder " + folder_ + ": " + std::strerror(errno));
}

/// Writes in a thread of its own, since a thread that waits for a disk cannot be ended.
/// @throws FileError if the file cannot be written, or not in time
void CorrectionRecord::put(const std::string& name, std::string text) const {
  std::promise<std::string> failure;
  std::future<std::string> answer = failure.get_future();
  const std::string path = folder_ + "/" + name;
  std::thread writer([write = write_, path, text = std::move(text), failure = std::move(failure)]() mutable {
    std::string why;
    try {
      write(path, text);
    } catch (const std::exception& error) {  // of a file system too
      why = error.what();
    }
    failure.set_value(why);
  });
  if (answer.wait_for(std::chrono::duration<double>(patience_s_)) != std::future_status::ready) {
    writer.detach();
    throw FileError(path + " was not written within " + numberText(patience_s_) +
                    " s: its disk does not answer");
  }
  writer.join();
  const std::string why = answer.get();
  if (!why.empty()) throw FileError(why);
}

void CorrectionRecord::begin(const ProgrammedToolpath& toolpath) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (folder_.empty() || std::exchange(has_begun_, true)) return;
  put(kProgrammedToolpathFile, programmedToolpathCsv(toolpath));
  put(kAppliedMapsFile, appliedRecordCsv(of_, rows_));
}

std::optional<RecordedJob> CorrectionRecord::of() const {
  return folder_.empty() ? std::nullopt : std::optional<RecordedJob>(of_);
}

template <class Action>
void CorrectionRecord::attempt(Action action) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (folder_.empty() || !failure_.empty()) return;
  try {
    action();
  } catch (const std::exception& error) {
    failure_ = error.what();
  }
}

void CorrectionRecord::keep(const AppliedRow& row, const CorrectionMap& map) {
  attempt([&] { put(appliedMapFile(row), correctionMapCsv(map)); });
}

void CorrectionRecord::add(AppliedRow row) {
  attempt([&] {
    rows_.push_back(std::move(row));
    put(kAppliedMapsFile, appliedRecordCsv(of_, rows_));
  });
}

std::string CorrectionRecord::failure() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return failure_;
}

}  // namespace lamina
