// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nodes/gcode_streamer/correction_record.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <future>
#include <memory>

#include "lamina/base/error.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

/// A disk that does not answer until it is let go, and how often it was asked to.
class DeafDisk {
 public:
  ~DeafDisk() { goes_on_.set_value(); }

  CorrectionRecord::Write writer() {
    return [wait = goes_on_.get_future().share(), asked = asked_](const auto&, const auto&) {
      ++*asked;
      wait.wait();
    };
  }
  int asked() const { return *asked_; }

 private:
  std::shared_ptr<std::atomic<int>> asked_ = std::make_shared<std::atomic<int>>(0);
  std::promise<void> goes_on_;
};

TEST(CorrectionRecord, GivesUpADiskThatDoesNotAnswer) {
  const test::ScratchFolder folder;
  DeafDisk disk;
  CorrectionRecord record(folder.file("record"), "sha", "toolpath", disk.writer(), 0.05);
  record.add({1, 0, "", 1});
  EXPECT_EQ(record.failure(),
            folder.file("record") + "/record.csv was not written within 0.05 s: its disk does not answer");
  record.add({2, 0, "", 9});
  record.keep({3, 1, "digest", 0}, {});
  EXPECT_LE(disk.asked(), 1) << "nothing is recorded from then on";
}

TEST(CorrectionRecord, BeginsNoJobOnADiskThatDoesNotAnswer) {
  const test::ScratchFolder folder;
  DeafDisk disk;
  CorrectionRecord record(folder.file("record"), "sha", "toolpath", disk.writer(), 0.05);
  EXPECT_THROW(record.begin({}), FileError);
}

TEST(CorrectionRecord, OutlivesWhatAFileSystemThrows) {
  const test::ScratchFolder folder;
  CorrectionRecord record(folder.file("record"), "sha", "toolpath", [](const auto&, const auto&) {
    throw std::filesystem::filesystem_error("stale", std::make_error_code(std::errc::io_error));
  });
  record.add({1, 0, "", 1});
  EXPECT_NE(record.failure().find("stale"), std::string::npos) << record.failure();
}

}  // namespace
}  // namespace lamina
