// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/session/upload_journal.hpp"

#include <gtest/gtest.h>

#include <future>
#include <memory>
#include <thread>

#include "lamina/base/error.hpp"
#include "streaming/journal/progress_file.hpp"
#include "streaming/upload/upload_fixture.hpp"

namespace lamina {
namespace {

/// An upload to a Duet up to the request that starts the print, which is not sent.
struct AskedToStart {
  StreamableProgram program = StreamableProgram::fromText("part", test::hotProgram(20));
  std::shared_ptr<const UploadOrder> order = test::orderOf(program);
  UploadJob job{StreamSettings(), order};
  double now = 0.0;
  std::optional<HttpRequest> start;

  AskedToStart() {
    const auto server = makeEmulatedDuet();
    job.start(now);
    for (int i = 0; i < 100; ++i) {
      const auto request = job.takeRequest(now);
      if (request && job.mayBeStarted()) {
        start = request;
        return;
      }
      if (request)
        job.receive(server->answer(*request, test::bodyOf(*request, order->body)), now);
      else
        now = job.nextDeadline();
    }
  }
};

/// A journal on a disk that answers when it is told to, however long that outlives the journal.
struct OnSlowDisk {
  std::shared_ptr<std::promise<void>> asked = std::make_shared<std::promise<void>>();
  std::promise<void> answers;
  UploadJournal journal;

  explicit OnSlowDisk(const StreamableProgram& program)
      : journal({"/a/path", {}}, program, "http://printer",
                [begun = asked, may_go_on = answers.get_future().share()](const JournalledJob& /*job*/) {
                  return [begun, may_go_on, is_first = true](const JobProgress& /*progress*/) mutable {
                    if (std::exchange(is_first, false)) begun->set_value();
                    may_go_on.wait();
                  };
                }) {}
};

TEST(UploadJournal, LetsThePrintBeginWhenItIsOnDisk) {
  AskedToStart upload;
  ASSERT_TRUE(upload.start);
  OnSlowDisk slow(upload.program);
  EXPECT_FALSE(slow.journal.isAwaited(upload.job));
  slow.journal.keep(upload.job, upload.now);
  EXPECT_TRUE(slow.journal.isAwaited(upload.job));
  slow.answers.set_value();
  while (slow.journal.isAwaited(upload.job)) std::this_thread::yield();
  EXPECT_EQ(slow.journal.withWhatIsKnown(upload.job).message, "");
}

TEST(UploadJournal, MakesNoStopWaitForADisk) {
  AskedToStart upload;
  ASSERT_TRUE(upload.start);
  OnSlowDisk slow(upload.program);
  slow.journal.keep(upload.job, upload.now);
  upload.job.abort({ErrorCode::Cancelled, "stopped"}, upload.now);
  EXPECT_TRUE(upload.job.takeBreak()) << "the start is not sent any more";
  EXPECT_TRUE(upload.job.takeRequest(upload.now));
  slow.journal.keep(upload.job, upload.now);
  EXPECT_FALSE(slow.journal.isAwaited(upload.job));
  slow.answers.set_value();
}

TEST(UploadJournal, GoesOnWithoutADiskThatDoesNotAnswer) {
  AskedToStart upload;
  ASSERT_TRUE(upload.start);
  OnSlowDisk slow(upload.program);
  slow.journal.keep(upload.job, upload.now);
  slow.asked->get_future().wait();
  slow.journal.keep(upload.job, upload.now + kLongestWrite);
  EXPECT_TRUE(slow.journal.isAwaited(upload.job));
  slow.journal.keep(upload.job, upload.now + kLongestWrite + 0.1);
  EXPECT_FALSE(slow.journal.isAwaited(upload.job));
  const std::string message = slow.journal.withWhatIsKnown(upload.job).message;
  EXPECT_NE(message.find("within 10 s"), std::string::npos) << message;
  EXPECT_NE(message.find("the print goes on"), std::string::npos) << message;
  slow.answers.set_value();
}

TEST(UploadJournal, LetsNoExecutionBeginThatNothingStates) {
  AskedToStart upload;
  ASSERT_TRUE(upload.start);
  for (const bool is_execution : {false, true}) {
    StreamJournal where{"/a/path", {}};
    if (is_execution) where.execution = "execution 7";
    UploadJournal journal(where, upload.program, "http://printer", [](const JournalledJob& /*job*/) {
      return [](const JobProgress& /*progress*/) { throw FileError("the disk is full"); };
    });
    journal.keep(upload.job, upload.now);
    while (journal.isAwaited(upload.job)) {
      std::this_thread::yield();
      journal.keep(upload.job, upload.now);
    }
    EXPECT_EQ(journal.prohibition().empty(), !is_execution);
    if (is_execution) {
      EXPECT_EQ(journal.prohibition(),
                "the disk is full; execution execution 7 was not started, since nothing states that it has "
                "begun");
    }
  }
}

}  // namespace
}  // namespace lamina
