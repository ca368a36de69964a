// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "lamina/control/program/correction_files.hpp"

namespace lamina {

/// The folder that records the corrections of a program: from both, the sent lines can be reproduced
/// (`readCorrectionFiles`). A failure of the disk does not stop the machine; nothing is recorded from then
/// on. A disk that does not answer is waited for no longer than the patience: whoever waits has a machine to
/// stop. May be called from any thread.
class CorrectionRecord {
 public:
  /// Function that returns once the text is in the file.
  using Write = std::function<void(const std::string& path, const std::string& text)>;

  static constexpr double kLongestWrite = 10.0;  ///< [s]

  /// Creates the folder. A previous job's record in it stays until a job begins.
  /// @param folder  empty to keep nothing
  /// @param write  called in a thread of its own, which outlives the record while a call lasts; empty to
  /// write
  ///   files (`writeFile`)
  /// @param patience_s  longest duration of a write
  /// @throws FileError if nothing can be written there
  CorrectionRecord(std::string folder, std::string program_sha256, std::string toolpath_id, Write write = {},
                   double patience_s = kLongestWrite);

  /// Begins the job: an empty record and the toolpath replace those of a previous job. Called once.
  /// @param toolpath  that of the id
  /// @throws FileError if they cannot be written
  void begin(const ProgrammedToolpath& toolpath);

  /// To be called before the row that reports the map.
  void keep(const AppliedRow& row, const CorrectionMap& map);
  /// To be called before any line to which the row applies is sent.
  void add(AppliedRow row);

  /// The recorded job; nothing if no record is kept.
  std::optional<RecordedJob> of() const;
  const std::string& folder() const { return folder_; }

  /// Why recording has ended; empty if it has not.
  std::string failure() const;

 private:
  template <class Action>
  void attempt(Action action);
  void put(const std::string& name, std::string text) const;

  const std::string folder_;
  const Write write_;
  const double patience_s_;
  mutable std::mutex mutex_;  ///< guards everything below
  bool has_begun_ = false;
  RecordedJob of_;
  std::vector<AppliedRow> rows_;
  std::string failure_;
};

}  // namespace lamina
