// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/servo/servoj_frames.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace lamina {
namespace {

std::string hexOf(std::string_view bytes) {
  std::string text;
  for (const char byte : bytes) {
    const auto value = static_cast<unsigned char>(byte);
    text += "0123456789abcdef"[value >> 4U];
    text += "0123456789abcdef"[value & 15U];
  }
  return text;
}

CyclicTarget targetWith(const std::vector<double>& numbers, std::int64_t cycle) {
  CyclicTarget target;
  target.cycle = cycle;
  std::size_t next = 0;
  for (JointValues* const values :
       {&target.now.position, &target.now.velocity, &target.ahead.position, &target.ahead.velocity}) {
    values->resize(6);
    for (int j = 0; j < 6; ++j) (*values)[j] = numbers[next++ % numbers.size()];
  }
  return target;
}

TEST(ServojFrames, AreWholeNumbersWithTheHighestByteFirst) {
  const TargetBytes bytes = targetBytes(targetWith({1.0, -1.0, 0.5, 0.0, 0.0, 2e-6}, 258));
  const std::string joints = "000f4240fff0bdc00007a120000000000000000000000002";
  EXPECT_EQ(hexOf({bytes.data(), bytes.size()}), "00000102" + joints + joints + joints + joints);
  const TargetBytes end = endBytes();
  EXPECT_EQ(hexOf({end.data(), end.size()}), "ffffffff" + std::string(192, '0'));
  ServojReport report{ServojState::Silent, 3, JointValues::Zero(6)};
  report.position[5] = -2e-6;
  const ReportBytes reported = reportBytes(report);
  EXPECT_EQ(hexOf({reported.data(), reported.size()}),
            "4c53000200000003" + std::string(40, '0') + "fffffffe");
}

TEST(ServojFrames, AreReadAsTheyWereWritten) {
  EXPECT_EQ(targetOf(endBytes()).kind, TargetFrame::Kind::End);
  EXPECT_TRUE(rc::check("targets and reports come back to a millionth of a radian", [] {
    const auto micro = *rc::gen::container<std::vector<int>>(24, rc::gen::inRange(-20000000, 20000001));
    std::vector<double> numbers;
    numbers.reserve(micro.size());
    for (const int number : micro) numbers.push_back(1e-6 * number);
    const CyclicTarget target = targetWith(numbers, *rc::gen::inRange<std::int64_t>(1, 1LL << 31));
    const TargetFrame frame = targetOf(targetBytes(target));
    RC_ASSERT(frame.kind == TargetFrame::Kind::Target);
    RC_ASSERT(frame.target.cycle == target.cycle);
    RC_ASSERT((frame.target.now.position - target.now.position).norm() < 1e-9);
    RC_ASSERT((frame.target.ahead.velocity - target.ahead.velocity).norm() < 1e-9);
    const ServojReport report{static_cast<ServojState>(*rc::gen::inRange(0, 4)), target.cycle,
                              target.now.position};
    const auto read = reportOf(reportBytes(report));
    RC_ASSERT(read.has_value());
    RC_ASSERT(read->state == report.state && read->cycle == report.cycle);
    RC_ASSERT((read->position - report.position).norm() < 1e-9);
  }));
}

TEST(ServojFrames, CountCyclesFromOneAgainAfterTheGreatestNumber) {
  constexpr std::int64_t kGreatest = (1LL << 31) - 1;
  EXPECT_EQ(targetOf(targetBytes(targetWith({0.1}, kGreatest))).target.cycle, kGreatest);
  EXPECT_EQ(targetOf(targetBytes(targetWith({0.1}, kGreatest + 1))).target.cycle, 1);
  EXPECT_EQ(targetOf(targetBytes(targetWith({0.1}, 3 * kGreatest))).target.cycle, kGreatest);
  const auto report = reportOf(reportBytes({ServojState::Waiting, 0, JointValues::Zero(6)}));
  ASSERT_TRUE(report);
  EXPECT_EQ(report->cycle, 0) << "before the first target";
}

TEST(ReportReader, KnowsTheLastReportHoweverItsBytesCome) {
  std::string stream;
  for (int i = 1; i <= 3; ++i) {
    const ReportBytes bytes = reportBytes({ServojState::Following, i, JointValues::Constant(6, 0.1 * i)});
    stream.append(bytes.data(), bytes.size());
  }
  for (std::size_t split = 0; split <= stream.size(); ++split) {
    ReportReader reader;
    reader.add(std::string_view(stream).substr(0, split));
    EXPECT_EQ(reader.count(), split / sizeof(ReportBytes));
    reader.add(std::string_view(stream).substr(split));
    ASSERT_TRUE(reader.last());
    EXPECT_EQ(reader.last()->cycle, 3);
    EXPECT_NEAR(reader.last()->position[5], 0.3, 1e-9);
    EXPECT_FALSE(reader.isBroken());
  }
}

TEST(ReportReader, ReadsNothingBehindBytesThatAreNoReport) {
  const ReportBytes good = reportBytes({ServojState::Following, 1, JointValues::Zero(6)});
  ReportReader reader;
  reader.add({good.data(), good.size()});
  ReportBytes bad = good;
  bad[3] = 4;
  reader.add({bad.data(), bad.size()});
  EXPECT_TRUE(reader.isBroken());
  reader.add({good.data(), good.size()});
  EXPECT_EQ(reader.count(), 1U);
  EXPECT_TRUE(rc::check("random bytes are reports of joints that can be, or break the reader off", [] {
    const auto bytes = *rc::gen::container<std::string>(rc::gen::arbitrary<char>());
    ReportReader any;
    any.add(bytes);
    RC_ASSERT(any.isBroken() || bytes.size() < sizeof(ReportBytes) || any.count() > 0);
    if (any.last()) RC_ASSERT(any.last()->position.cwiseAbs().maxCoeff() <= 20.0);
  }));
  EXPECT_TRUE(rc::check("a report with one byte changed is one of joints that can be, or none", [&good] {
    ReportBytes changed = good;
    changed[*rc::gen::inRange<std::size_t>(0, changed.size())] = *rc::gen::arbitrary<char>();
    const auto read = reportOf(changed);
    if (read) RC_ASSERT(read->cycle >= 0 && read->position.cwiseAbs().maxCoeff() <= 20.0);
  }));
}

TEST(ServojFrames, ThatAreNoTargetsAreBroken) {
  EXPECT_TRUE(rc::check("any frame is a target of joints that can be, the end, or broken", [] {
    const auto bytes =
        *rc::gen::container<std::vector<char>>(sizeof(TargetBytes), rc::gen::arbitrary<char>());
    TargetBytes frame;
    std::copy(bytes.begin(), bytes.end(), frame.begin());
    const TargetFrame read = targetOf(frame);
    if (read.kind == TargetFrame::Kind::Target)
      RC_ASSERT(read.target.cycle > 0 && read.target.ahead.velocity.cwiseAbs().maxCoeff() <= 20.0);
  }));
  EXPECT_EQ(targetOf(TargetBytes{}).kind, TargetFrame::Kind::Broken) << "no cycle 0";
}

}  // namespace
}  // namespace lamina
