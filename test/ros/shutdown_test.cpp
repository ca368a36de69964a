// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "shutdown.hpp"

#include <gtest/gtest.h>
#include <ros/ros.h>
#include <ros/xmlrpc_manager.h>
#include <std_msgs/Int32.h>
#include <sys/wait.h>
#include <unistd.h>
#include <xmlrpcpp/XmlRpcClient.h>
#include <xmlrpcpp/XmlRpcValue.h>

#include <csignal>
#include <string>
#include <vector>

#include "lamina/base/error.hpp"
#include "network/former_port.hpp"
#include "ros/wait_until.hpp"

namespace {

/// Exit code of a node with this body in a process of its own; -1 if it died of a signal.
int exitCodeOfNode(const lamina::NodeRun& run, const std::function<void()>& body) {
  const pid_t child = ::fork();
  if (child == 0) {
    char program[] = "shutdown_test";
    char* arguments[] = {program, nullptr};
    lamina::runNode(1, arguments, run, body);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/// What `rosnode kill` does to the node that calls this.
void killThisNode() {
  XmlRpc::XmlRpcClient client("127.0.0.1", static_cast<int>(ros::XMLRPCManager::instance()->getServerPort()));
  XmlRpc::XmlRpcValue request;
  XmlRpc::XmlRpcValue answer;
  request[0] = "/rosnode";
  request[1] = "user request";
  const bool is_answered = client.execute("shutdown", request, answer) && !client.isFault();
  client.close();
  if (!is_answered || answer.size() != 3 || static_cast<int&>(answer[0]) != 1)
    throw lamina::DeviceError("an answer of three values with the code 1 was expected");
}

TEST(RunNode, OnlyReportsOfRosnodeKillIfAskedTo) {
  const int exit_code = exitCodeOfNode({"killed", lamina::OnSignal::Request}, [] {
    killThisNode();
    ros::WallDuration(0.3).sleep();
    if (!lamina::isStopRequested() || !ros::ok())
      throw lamina::DeviceError("reported, and still there, was expected");
  });
  EXPECT_EQ(exit_code, 0);
}

TEST(RunNode, LeavesItsBodyOnRosnodeKill) {
  const int exit_code = exitCodeOfNode({"killed_spinning"}, [] {
    killThisNode();
    ros::spin();
    if (!lamina::isStopRequested()) throw lamina::DeviceError("an end as by a signal was expected");
  });
  EXPECT_EQ(exit_code, 0);
}

TEST(RunNode, OnlyReportsOfASignalIfAskedTo) {
  const int exit_code = exitCodeOfNode({"requested", lamina::OnSignal::Request}, [] {
    std::raise(SIGHUP);
    ros::WallDuration(0.1).sleep();
    ros::spinOnce();
    if (!lamina::isStopRequested() || !ros::ok())
      throw lamina::DeviceError("reported, and still there, was expected");
  });
  EXPECT_EQ(exit_code, 0);
}

TEST(RunNode, OffersNoListOfLoggersThatWouldCrashIt) {
  const int exit_code = exitCodeOfNode({"listless"}, [] {
    if (ros::service::exists("~get_loggers", false) || !ros::service::exists("~set_logger_level", false))
      throw lamina::DeviceError("of both logger services only the one that sets a level was expected");
  });
  EXPECT_EQ(exit_code, 0);
}

TEST(RunNode, IsKnownToTheMasterByItsPort) {
  const int exit_code = exitCodeOfNode({"known"}, [] {
    if (lamina::formerPort() != ros::XMLRPCManager::instance()->getServerPort())
      throw lamina::DeviceError(
          "the port of this node was expected, which the next of its name is not to get");
  });
  EXPECT_EQ(exit_code, 0);
}

TEST(RunNode, LeavesItsBodyOnSigterm) {
  const int exit_code = exitCodeOfNode({"terminated"}, [] {
    std::raise(SIGTERM);
    ros::spin();
  });
  EXPECT_EQ(exit_code, 0);
}

TEST(RunNode, LeavesItsBodyOnSigint) {
  const int exit_code = exitCodeOfNode({"interrupted"}, [] {
    std::raise(SIGINT);
    ros::spin();
  });
  EXPECT_EQ(exit_code, 0);
}

TEST(RunNode, LosesNoLastMessage) {
  const pid_t speaker = ::fork();
  if (speaker == 0) {
    char program[] = "shutdown_test";
    char* arguments[] = {program, nullptr};
    lamina::runNode(1, arguments, {"speaker", lamina::OnSignal::Request}, [] {
      ros::Publisher words = ros::NodeHandle().advertise<std_msgs::Int32>("last_words", 10);
      while (words.getNumSubscribers() == 0 && !lamina::isStopRequested()) ros::WallDuration(0.01).sleep();
      for (std_msgs::Int32 word; word.data < 5; ++word.data) words.publish(word);
      lamina::awaitDelivery();
    });
  }
  const int listener = exitCodeOfNode({"listener"}, [] {
    std::vector<int> heard;
    const boost::function<void(const std_msgs::Int32ConstPtr&)> on_word = [&](const auto& word) {
      heard.push_back(word->data);
    };
    const auto words = ros::NodeHandle().subscribe<std_msgs::Int32>("last_words", 10, on_word);
    if (!lamina::test::waitUntil([&] { return heard.size() == 5; }))
      throw lamina::DeviceError("five words were expected, " + std::to_string(heard.size()) + " were heard");
  });
  EXPECT_EQ(listener, 0);
  ::kill(speaker, SIGTERM);
  int status = 0;
  ::waitpid(speaker, &status, 0);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << status;
}

TEST(RunNode, GivesOneIfItsBodyThrows) {
  EXPECT_EQ(exitCodeOfNode({"refused"}, [] { throw lamina::InvalidConfig("walls.count is -1"); }), 1);
  EXPECT_EQ(exitCodeOfNode({"broken"}, [] { throw 42; }), 1);
}

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
