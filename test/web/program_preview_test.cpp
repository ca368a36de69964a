// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/web/program_preview.hpp"

#include <gtest/gtest.h>

#include <future>
#include <thread>

#include "lamina/base/error.hpp"

namespace lamina::test {
namespace {

/// Asks until the program has been read.
ShownPreview whenRead(ProgramPreview& preview, const std::string& program, std::int32_t layer) {
  while (true) {
    ShownPreview shown = preview.layer(program, layer);
    if (!shown.is_being_read) return shown;
    std::this_thread::yield();
  }
}

std::vector<LayerPreview> oneLayer(double z_m) {
  LayerPreview layer;
  layer.z_m = z_m;
  return {layer};
}

TEST(ProgramPreview, HasNobodyWaitWhileAProgramIsRead) {
  std::promise<void> go;
  int reads = 0;
  ProgramPreview preview([&](const std::string&, const std::atomic<bool>&) {
    ++reads;
    go.get_future().wait();
    return oneLayer(0.5);
  });
  for (int i = 0; i < 100; ++i) EXPECT_TRUE(preview.layer("/a", i).is_being_read);
  go.set_value();
  const ShownPreview shown = whenRead(preview, "/a", 0);
  ASSERT_TRUE(shown.layer);
  EXPECT_EQ(shown.layer->z_m, 0.5);
  EXPECT_FALSE(whenRead(preview, "/a", 1).layer) << "no such layer";
  EXPECT_FALSE(whenRead(preview, "/a", -1).layer);
  EXPECT_EQ(reads, 1);
}

TEST(ProgramPreview, ReadsAProgramOnceThatCannotBeRead) {
  std::atomic<int> reads{0};
  ProgramPreview preview([&](const std::string&, const std::atomic<bool>&) -> std::vector<LayerPreview> {
    ++reads;
    throw InvalidInput("too large");
  });
  EXPECT_THROW(whenRead(preview, "/a", 0), InvalidInput);
  for (int i = 0; i < 100; ++i) EXPECT_THROW(preview.layer("/a", i), InvalidInput);
  EXPECT_EQ(reads, 1);
}

TEST(ProgramPreview, LeavesAProgramForAnotherThatIsWanted) {
  std::promise<void> begun;
  ProgramPreview preview([&](const std::string& program, const std::atomic<bool>& is_unwanted) {
    if (program == "/b") return oneLayer(2.0);
    begun.set_value();
    while (!is_unwanted) std::this_thread::yield();
    return oneLayer(1.0);
  });
  EXPECT_TRUE(preview.layer("/a", 0).is_being_read);
  begun.get_future().wait();
  EXPECT_TRUE(preview.layer("/b", 0).is_being_read);
  EXPECT_EQ(whenRead(preview, "/b", 0).layer->z_m, 2.0);
}

}  // namespace
}  // namespace lamina::test
