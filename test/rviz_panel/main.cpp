// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <ros/init.h>

#include <QApplication>
#include <cstring>

#include "slow_incliner.hpp"

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "panel_test");
  if (argc > 1 && std::strcmp(argv[1], "--serve") == 0) return lamina::test::serveSlowly();
  const QApplication application(argc, argv);
  ros::start();
  const int result = RUN_ALL_TESTS();
  ros::shutdown();
  return result;
}
