// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/base/input_file.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cstdio>
#include <fstream>
#include <thread>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

TEST(InputFile, ReadsInPieces) {
  const std::string path = testing::TempDir() + "input_file_pieces";
  std::ofstream(path) << "abcdef";
  InputFile file(path);
  EXPECT_EQ(file.size(), 6u);
  char buffer[4];
  EXPECT_EQ(file.read(buffer, 4), 4u);
  EXPECT_EQ(std::string(buffer, 4), "abcd");
  EXPECT_EQ(file.read(buffer, 4), 2u);
  EXPECT_EQ(file.read(buffer, 4), 0u);
  std::remove(path.c_str());
}

TEST(InputFile, AddsTheRestToWhatWasReadBefore) {
  const std::string path = testing::TempDir() + "input_file_rest";
  std::ofstream(path) << "abcdef";
  InputFile file(path);
  char buffer[2];
  file.read(buffer, 2);
  EXPECT_EQ(file.readRest({buffer, 2}), "abcdef");
  std::remove(path.c_str());
}

TEST(InputFile, ReadsAPipeToItsEnd) {
  const std::string path = testing::TempDir() + "input_file_pipe";
  std::remove(path.c_str());
  ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
  const std::string sent(200000, 'x');
  std::thread writer([&] { std::ofstream(path) << sent; });
  EXPECT_EQ(InputFile(path).readRest(), sent);
  writer.join();
  std::remove(path.c_str());
}

TEST(InputFile, RefusesWhatCannotBeRead) {
  EXPECT_THROW(InputFile("/nowhere/file"), FileError);
  EXPECT_THROW(InputFile("/tmp"), FileError);
}

}  // namespace
}  // namespace lamina
