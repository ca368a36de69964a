// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/session/session_journal.hpp"

#include <gtest/gtest.h>

#include <future>

#include "streaming/session/scripted_peer.hpp"

namespace lamina {
namespace {

/// A disk that does not answer until it is let go.
class MuteDisk {
 public:
  ~MuteDisk() { goes_on_.set_value(); }

  SessionJournal::Writer writer() {
    return [wait = goes_on_.get_future().share()](const JournalledJob& /*job*/) {
      return [wait](const JobProgress& /*progress*/) { wait.wait(); };
    };
  }

 private:
  std::promise<void> goes_on_;
};

class SessionJournalTest : public test::ScriptedPeer {
 protected:
  SessionJournal journal(MuteDisk& disk, const std::string& execution = "") {
    StreamJournal where{"/a/path", {}};
    where.execution = execution;
    SessionJournal journal(where, program_, "/dev/printer", nullptr);
    journal.writeBy(disk.writer(), 0.05);
    return journal;
  }
};

TEST_F(SessionJournalTest, MakesNoStopWaitForADiskThatDoesNotAnswer) {
  MuteDisk disk;
  SessionJournal slow = journal(disk);
  Streamer streamer(program_, settings());
  begin(streamer);
  slow.keep(streamer, 0.1);
  EXPECT_NE(slow.failure().find("its disk does not answer; the job goes on"), std::string::npos)
      << slow.failure();
  EXPECT_FALSE(slow.forbidsTheFirstLine());
  streamer.takeOutput();
  streamer.abort({ErrorCode::Cancelled, "enough"}, 1.0);
  slow.keep(streamer, 1.0);
  EXPECT_EQ(streamer.takeOutput().find("M108\nM410\nM104 S0\nM140 S0\n"), 0U);
}

TEST_F(SessionJournalTest, ForbidsTheLinesOfAnExecutionThatItCannotState) {
  MuteDisk disk;
  SessionJournal slow = journal(disk, "e-1");
  Streamer streamer(program_, settings());
  begin(streamer);
  slow.keep(streamer, 0.1);
  EXPECT_TRUE(slow.forbidsTheFirstLine());
  EXPECT_NE(slow.failure().find("no line of execution e-1 was sent"), std::string::npos) << slow.failure();
}

}  // namespace
}  // namespace lamina
