// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/base/input_file.hpp"

#include <gtest/gtest.h>
#include <pthread.h>
#include <sys/fsuid.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <chrono>
#include <csignal>
#include <fstream>
#include <string>
#include <thread>

#include "lamina/base/error.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

TEST(InputFile, ReadsInPieces) {
  const test::ScratchFolder folder;
  const std::string path = folder.file("pieces");
  std::ofstream(path) << "abcdef";
  InputFile file(path);
  EXPECT_EQ(file.size(), 6u);
  char buffer[4];
  EXPECT_EQ(file.read(buffer, 4), 4u);
  EXPECT_EQ(std::string(buffer, 4), "abcd");
  EXPECT_EQ(file.read(buffer, 4), 2u);
  EXPECT_EQ(file.read(buffer, 4), 0u);
}

TEST(InputFile, IsFoundInAnyCaseWhereItIsNotThereAsNamed) {
  const test::ScratchFolder folder;
  std::ofstream(folder.file("BOX_1.LS")) << "a";
  EXPECT_EQ(pathInAnyCase(folder.file("box_1.ls")), folder.file("BOX_1.LS"));
  EXPECT_EQ(pathInAnyCase(folder.file("box_2.ls")), folder.file("box_2.ls"));
  std::ofstream(folder.file("box_1.ls")) << "b";
  EXPECT_EQ(pathInAnyCase(folder.file("box_1.ls")), folder.file("box_1.ls"));
  EXPECT_EQ(pathInAnyCase(folder.file("Box_1.ls")), folder.file("BOX_1.LS"));
}

/// Looks at files as a user without rights of its own, also where tests run as root.
class AsNobody {
 public:
  AsNobody() { ::setfsuid(65534); }
  ~AsNobody() { ::setfsuid(::geteuid()); }
  AsNobody(const AsNobody&) = delete;
  AsNobody& operator=(const AsNobody&) = delete;
};

TEST(InputFile, NamesTheFileWhoseFolderCannotBeListed) {
  const test::ScratchFolder folder;
  const std::string path = folder.file("part.src");
  // Its files may be opened by name.
  ::chmod(folder.file("").c_str(), 0311);
  std::string message;
  {
    const AsNobody nobody;
    try {
      pathInAnyCase(path);
    } catch (const FileError& error) {
      message = error.what();
    }
  }
  ::chmod(folder.file("").c_str(), 0700);
  EXPECT_EQ(message, "cannot read '" + path + "': its folder cannot be listed: Permission denied");
}

TEST(InputFile, LeavesAMissingFolderToWhoeverOpensTheFile) {
  const test::ScratchFolder folder;
  EXPECT_EQ(pathInAnyCase(folder.file("none/part.src")), folder.file("none/part.src"));
}

TEST(InputFile, AddsTheRestToWhatWasReadBefore) {
  const test::ScratchFolder folder;
  const std::string path = folder.file("rest");
  std::ofstream(path) << "abcdef";
  InputFile file(path);
  char buffer[2];
  file.read(buffer, 2);
  EXPECT_EQ(file.readRest({buffer, 2}), "abcdef");
}

/// A pipe, as a file that is named by its descriptor.
class DescriptorPipe {
 public:
  DescriptorPipe() { EXPECT_EQ(::pipe(ends_), 0); }
  ~DescriptorPipe() {
    ::close(ends_[0]);
    closeForWriting();
  }
  DescriptorPipe(const DescriptorPipe&) = delete;
  DescriptorPipe& operator=(const DescriptorPipe&) = delete;

  std::string path() const { return "/dev/fd/" + std::to_string(ends_[0]); }
  void write(const std::string& bytes) const {
    for (std::size_t sent = 0; sent < bytes.size();) {
      const ssize_t more = ::write(ends_[1], bytes.data() + sent, bytes.size() - sent);
      if (more > 0) sent += static_cast<std::size_t>(more);
    }
  }
  void closeForWriting() {
    if (ends_[1] >= 0) ::close(ends_[1]);
    ends_[1] = -1;
  }

 private:
  int ends_[2] = {-1, -1};
};

TEST(InputFile, ReadsAPipeThatIsNamedByItsDescriptorToItsEnd) {
  const std::string sent(200000, 'x');
  DescriptorPipe pipe;
  std::thread writer([&] {
    pipe.write(sent);
    pipe.closeForWriting();
  });
  EXPECT_EQ(InputFile(pipe.path()).readRest(), sent);
  writer.join();
}

TEST(InputFile, ASignalEndsTheWaitForAPipe) {
  const DescriptorPipe pipe;
  struct sigaction heard {};
  heard.sa_handler = [](int) {};
  struct sigaction before {};
  ASSERT_EQ(::sigaction(SIGUSR1, &heard, &before), 0);
  std::atomic<bool> is_over{false};
  const pthread_t reader = ::pthread_self();
  // Again and again, for one that comes before the wait ends nothing.
  std::thread caller([&] {
    while (!is_over) {
      ::pthread_kill(reader, SIGUSR1);
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
  });
  EXPECT_THROW(InputFile(pipe.path()).readRest(), Cancelled);
  is_over = true;
  caller.join();
  ::sigaction(SIGUSR1, &before, nullptr);
}

/// Handlers of SIGINT that only take note of it, for as long as this lives.
class NotedInterrupts {
 public:
  NotedInterrupts() {
    count_ = 0;
    struct sigaction noted {};
    noted.sa_handler = [](int) { count_ = count_ + 1; };
    EXPECT_EQ(::sigaction(SIGINT, &noted, &before_), 0);
  }
  ~NotedInterrupts() { ::sigaction(SIGINT, &before_, nullptr); }
  NotedInterrupts(const NotedInterrupts&) = delete;
  NotedInterrupts& operator=(const NotedInterrupts&) = delete;

  static int count() { return count_; }

 private:
  static inline volatile std::sig_atomic_t count_ = 0;
  struct sigaction before_ {};
};

// Nothing is waited for: there is always more to read.
TEST(InputFile, AnInterruptBetweenTwoReadsEndsTheReading) {
  const NotedInterrupts interrupts;
  DescriptorPipe pipe;
  pipe.write(std::string(1000, 'x'));
  InputFile file(pipe.path());
  std::array<char, 10> buffer{};
  EXPECT_EQ(file.read(buffer.data(), buffer.size()), buffer.size());
  ::pthread_kill(::pthread_self(), SIGINT);
  EXPECT_THROW(file.read(buffer.data(), buffer.size()), Cancelled);
  EXPECT_EQ(interrupts.count(), 1) << "its handler runs too";
}

TEST(InputFile, AnInterruptEndsTheReadingOfARegularFileToo) {
  const NotedInterrupts interrupts;
  const test::ScratchFolder folder;
  const std::string path = folder.file("long");
  std::ofstream(path) << std::string(1000, 'x');
  InputFile file(path);
  std::array<char, 10> buffer{};
  file.read(buffer.data(), buffer.size());
  ::pthread_kill(::pthread_self(), SIGINT);
  EXPECT_THROW(file.read(buffer.data(), buffer.size()), Cancelled);
}

// What is done with the bytes can be interrupted as ever.
TEST(InputFile, InterruptsComeAtOnceBehindTheEndOfTheFileAndBehindTheObject) {
  const NotedInterrupts interrupts;
  const test::ScratchFolder folder;
  const std::string path = folder.file("short");
  std::ofstream(path) << "abcdef";
  InputFile whole(path);
  EXPECT_EQ(whole.readRest(), "abcdef");
  ::pthread_kill(::pthread_self(), SIGINT);
  EXPECT_EQ(interrupts.count(), 1);
  {
    InputFile begun(path);
    char first = 0;
    begun.read(&first, 1);
    ::pthread_kill(::pthread_self(), SIGINT);
    EXPECT_EQ(interrupts.count(), 1) << "held back";
  }
  EXPECT_EQ(interrupts.count(), 2);
}

TEST(InputFile, ReadsNoMoreThanItMay) {
  const test::ScratchFolder folder;
  const std::string path = folder.file("most");
  std::ofstream(path) << "abcdef";
  EXPECT_EQ(InputFile(path).readRest({}, 6), "abcdef");
  EXPECT_THROW(InputFile(path).readRest({}, 5), FileError);
  DescriptorPipe pipe;
  pipe.write("abcdef");
  pipe.closeForWriting();
  EXPECT_THROW(InputFile(pipe.path()).readRest({}, 5), FileError);
}

/// What grows needs its old room and twice as much at once.
TEST(InputFile, WithoutASizeLeavesRoomToGrow) {
  constexpr double kAvailable = 6e9;
  EXPECT_EQ(mostBytesInMemory(kAvailable, 1000), 4800000000U);
  const std::size_t of_pipe = mostBytesInMemory(kAvailable, 0);
  EXPECT_GT(of_pipe, 1000000000U);
  EXPECT_LE(3.0 * static_cast<double>(of_pipe), 0.8 * kAvailable);
}

TEST(InputFile, RefusesWhatCannotBeRead) {
  EXPECT_THROW(InputFile("/nowhere/file"), FileError);
  const test::ScratchFolder folder;
  EXPECT_THROW(InputFile(folder.file("")), FileError);
  EXPECT_THROW(InputFile("/dev/zero"), FileError);
  const std::string pipe = folder.file("pipe");
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_THROW(InputFile{pipe}, FileError) << "nobody writes to it";
  EXPECT_THROW(requireReadable(pipe), FileError);
}

}  // namespace
}  // namespace lamina
