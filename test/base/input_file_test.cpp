// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/base/input_file.hpp"

#include <gtest/gtest.h>
#include <pthread.h>
#include <sys/stat.h>
#include <unistd.h>

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
