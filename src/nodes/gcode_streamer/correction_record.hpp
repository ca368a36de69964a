// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "lamina/control/program/correction_files.hpp"

namespace lamina {

/// The folder that says what a program was corrected by: from it and the program what was sent can be made
/// again (`readCorrectionFiles`). A disk that fails does not stop the machine: nothing is kept any more from
/// then on. May be called from any thread.
class CorrectionRecord {
 public:
  /// Makes the folder, and leaves what is in it: the record of a job before, as long as none begins.
  /// @param folder  empty to keep nothing
  /// @throws FileError if nothing can be written there
  CorrectionRecord(std::string folder, std::string program_sha256, std::string toolpath_id);

  /// The job begins: a record of nothing, and the toolpath, in place of those of a job before. Once.
  /// @param toolpath  that of the id
  /// @throws FileError if they cannot be written
  void begin(const ProgrammedToolpath& toolpath);

  /// To be called before the row that reports the map.
  void keep(const AppliedRow& row, const CorrectionMap& map);
  /// To be called before any line that the row is about is sent.
  void add(AppliedRow row);

  /// What it is of; nothing where none is kept.
  std::optional<RecordedJob> of() const;
  const std::string& folder() const { return folder_; }

  /// Why nothing is kept any more; empty while all is well.
  std::string failure() const;

 private:
  template <class Write>
  void attempt(Write write);

  const std::string folder_;
  mutable std::mutex mutex_;  ///< of what is below
  bool has_begun_ = false;
  RecordedJob of_;
  std::vector<AppliedRow> rows_;
  std::string failure_;
};

}  // namespace lamina
