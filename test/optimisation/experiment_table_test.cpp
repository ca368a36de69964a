// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/optimisation/experiment_table.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "optimisation/test_problems.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

const std::vector<std::string> kResponses = {"modulus_mpa", "time_s"};

DesignSpace smallSpace() {
  return {continuous("infill_percent", 20.0, 100.0),
          {"link", VariableKind::Categorical, 0.0, 0.0, {}, {"average", "tangential"}}};
}

class ExperimentTableTest : public ::testing::Test {
 protected:
  ExperimentTable read(const std::string& text) {
    writeFile(path_, text);
    return readExperimentTable(path_, smallSpace(), kResponses);
  }
  std::string refusalOf(const std::string& text) {
    try {
      read(text);
    } catch (const InvalidInput& error) {
      return error.what();
    }
    return "";
  }

  test::ScratchFolder folder_;
  std::string path_ = folder_.file("table.csv");
};

TEST_F(ExperimentTableTest, ReadsRowsInAnyOrderOfColumnsAndLeavesGaps) {
  const ExperimentTable table = read(
      "# typed\n"
      "time_s,iteration,link,remark,infill_percent,modulus_mpa\n"
      "95,,average,first,20,1447.4\n"
      "122,2,tangential,,69.39,\n"
      "122,1,tangential,,68.73,2166.6\n"
      ",,average,,100,\n");
  ASSERT_EQ(table.design.size(), 2U);
  EXPECT_EQ(table.design[0].point, (DesignPoint{20.0, 0.0}));
  EXPECT_EQ(table.design[0].responses, (std::vector<double>{1447.4, 95.0}));
  EXPECT_TRUE(std::isnan(table.design[1].responses[0]) && std::isnan(table.design[1].responses[1]));
  ASSERT_EQ(table.proposed.size(), 2U);
  EXPECT_EQ(table.proposed[0].point, (DesignPoint{68.73, 1.0}));
  EXPECT_TRUE(std::isnan(table.proposed[1].responses[0]));
}

TEST_F(ExperimentTableTest, NamesLineAndColumnOfWhatItCannotUse) {
  const std::string header = "infill_percent,link,modulus_mpa,time_s,iteration\n";
  EXPECT_NE(refusalOf("infill_percent,link,time_s\n20,average,5\n").find("has no column 'modulus_mpa'"),
            std::string::npos);
  EXPECT_NE(refusalOf(header + "120,average,1,1,\n").find("line 2: variable infill_percent: '120'"),
            std::string::npos);
  EXPECT_NE(refusalOf(header + "20,straight,1,1,\n").find("one of average, tangential"), std::string::npos);
  EXPECT_NE(refusalOf(header + "20,average,stiff,1,\n").find("response modulus_mpa: 'stiff'"),
            std::string::npos);
  EXPECT_NE(refusalOf(header + "20,average,1,1,0\n").find("iteration '0'"), std::string::npos);
  EXPECT_NE(
      refusalOf(header + "20,average,1,1,1\n30,average,1,1,1\n").find("line 3: iteration 1 stands twice"),
      std::string::npos);
  EXPECT_THROW(readExperimentTable(folder_.file("none.csv"), smallSpace(), kResponses), FileError);
}

TEST_F(ExperimentTableTest, WritesWhatItReads) {
  ExperimentTable table{kResponses,
                        {{{20.0, 0.0}, {1447.44, NAN}, ""}, {{100.0, 1.0}, {}, "nozzle clogged"}},
                        {{{68.73, 1.0}, {2166.62, 122.0}, ""}}};
  const std::string text = experimentTableCsv(smallSpace(), table);
  EXPECT_EQ(text,
            "iteration,infill_percent,link,modulus_mpa,time_s\n"
            ",20,average,1447.44,\n"
            ",100,tangential,,\n"
            "1,68.73,tangential,2166.62,122\n");
  EXPECT_EQ(experimentTableCsv(smallSpace(), read(text)), text);
}

TEST(TableEvaluatorTest, AnswersFromTheNearestUnusedRowOnly) {
  TableEvaluator evaluator(smallSpace(), kResponses,
                           {{{69.39, 1.0}, {2298.71, 122.0}, ""},
                            {{68.73, 1.0}, {2166.62, 122.0}, ""},
                            {{90.0, 0.0}, {2500.0, NAN}, ""}},
                           0.01);
  NoProgress progress;
  std::size_t reported = 0;
  const auto answers = evaluator.evaluate(
      {{68.7, 1.0}, {68.7, 1.0}, {68.7, 1.0}, {68.7, 0.0}, {90.0, 0.0}},
      [&](const Evaluation&) { ++reported; }, progress);
  EXPECT_EQ(reported, 5U);
  EXPECT_EQ(answers[0].point, (DesignPoint{68.73, 1.0}));
  EXPECT_EQ(answers[0].responses, (std::vector<double>{2166.62, 122.0}));
  EXPECT_EQ(answers[1].point, (DesignPoint{69.39, 1.0}));
  EXPECT_EQ(answers[2].error, "not in the table; measure infill_percent 68.7, link tangential");
  EXPECT_FALSE(isEvaluated(answers[3]));
  EXPECT_EQ(answers[4].error, "the table lacks time_s at infill_percent 90, link average");
  EXPECT_EQ(evaluator.responseNames(), kResponses);
}

TEST(NearnessTest, CountsContinuousVariablesByTheirRangeAndOthersExactly) {
  EXPECT_TRUE(isNear(smallSpace(), {50.0, 1.0}, {50.8, 1.0}, 0.011));
  EXPECT_FALSE(isNear(smallSpace(), {50.0, 1.0}, {50.8, 1.0}, 0.009));
  EXPECT_FALSE(isNear(smallSpace(), {50.0, 1.0}, {50.0, 0.0}, 1.0));
  EXPECT_TRUE(isNear(smallSpace(), {50.0, 1.0}, {50.0, 1.0}, 0.0));
}

}  // namespace
}  // namespace lamina
