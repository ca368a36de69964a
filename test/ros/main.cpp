// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// One executable holds the suites of all rostests, since the headers of ROS are the most that there is to
// compile.
//
//   lamina_rostests SUITE...   runs these; GTEST_FILTER chooses among all tests instead
#include <gtest/gtest.h>
#include <ros/ros.h>

#include <iostream>
#include <string>

namespace {

bool isOfSuite(const std::string& suite, const std::string& name) {
  return name == suite || (name.size() > suite.size() &&
                           name.compare(name.size() - suite.size() - 1, std::string::npos, '/' + suite) == 0);
}

bool hasSuite(const std::string& suite) {
  const testing::UnitTest& all = *testing::UnitTest::GetInstance();
  for (int i = 0; i < all.total_test_suite_count(); ++i)
    if (isOfSuite(suite, all.GetTestSuite(i)->name())) return true;
  return false;
}

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "lamina_rostests");
  std::string filter;
  for (int i = 1; i < argc; ++i) {
    const std::string suite = argv[i];
    if (!hasSuite(suite)) {
      std::cerr << "suite " << suite << ": unknown; expected a name that a TEST has\n";
      return 2;
    }
    filter += suite + ".*:*/" + suite + ".*:";
  }
  if (filter.empty()) {
    std::cerr << "no suite is named; expected at least one\n";
    return 2;
  }
  if (testing::GTEST_FLAG(filter) == "*") testing::GTEST_FLAG(filter) = filter;
  const ros::NodeHandle keeps_ros_running;
  return RUN_ALL_TESTS();
}
