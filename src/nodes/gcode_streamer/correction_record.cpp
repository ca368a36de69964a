// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "correction_record.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <random>
#include <utility>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"

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

CorrectionRecord::CorrectionRecord(std::string folder, std::string program_sha256, std::string toolpath_id)
    : folder_(std::move(folder)), of_{std::move(program_sha256), std::move(toolpath_id), anyName()} {
  if (folder_.empty()) return;
  std::error_code failure;
  std::filesystem::create_directories(folder_, failure);
  if (failure) throw FileError("cannot make the folder " + folder_ + ": " + failure.message());
  if (::access(folder_.c_str(), W_OK | X_OK) != 0)
    throw FileError("cannot record corrections in the folder " + folder_ + ": " + std::strerror(errno));
}

void CorrectionRecord::begin(const ProgrammedToolpath& toolpath) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (folder_.empty() || std::exchange(has_begun_, true)) return;
  writeFile(folder_ + "/" + kProgrammedToolpathFile, programmedToolpathCsv(toolpath));
  writeFile(folder_ + "/" + kAppliedMapsFile, appliedRecordCsv(of_, rows_));
}

std::optional<RecordedJob> CorrectionRecord::of() const {
  return folder_.empty() ? std::nullopt : std::optional<RecordedJob>(of_);
}

template <class Write>
void CorrectionRecord::attempt(Write write) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (folder_.empty() || !failure_.empty()) return;
  try {
    write();
  } catch (const Error& error) {
    failure_ = error.what();
  }
}

void CorrectionRecord::keep(const AppliedRow& row, const CorrectionMap& map) {
  attempt([&] { writeFile(folder_ + "/" + appliedMapFile(row), correctionMapCsv(map)); });
}

void CorrectionRecord::add(AppliedRow row) {
  attempt([&] {
    rows_.push_back(std::move(row));
    writeFile(folder_ + "/" + kAppliedMapsFile, appliedRecordCsv(of_, rows_));
  });
}

std::string CorrectionRecord::failure() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return failure_;
}

}  // namespace lamina
