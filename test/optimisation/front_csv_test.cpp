// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/random.hpp"
#include "lamina/optimisation/front_csv.hpp"
#include "support/scratch_folder.hpp"
#include "test_problems.hpp"

namespace lamina {
namespace {

class FrontCsvTest : public ::testing::Test {
 protected:
  FrontTable read(const std::string& text) const {
    writeFile(path_, text);
    return readFrontCsv(path_);
  }

  std::string refusal(const std::string& text) const {
    try {
      read(text);
    } catch (const InvalidInput& error) {
      return error.what();
    }
    return "";
  }

  const test::ScratchFolder folder_;
  const std::string path_ = folder_.file("front.csv");
};

TEST_F(FrontCsvTest, IsReadableByPeople) {
  const std::vector<Evaluation> front = {{{0.5, 2.0, 0.2, 1.0}, {120.5, 3.0}, ""},
                                         {{0.7, 1.0, 0.3, 0.0}, {NAN, 1e-9}, ""},
                                         {{0.9, 1.0, 0.3, 0.0}, {}, "too wide"}};
  EXPECT_EQ(frontCsv(mixedSpace(), {"time_s", "error_mm3"}, front),
            "# variables 4\n"
            "pitch_mm,walls,layer_mm,link,time_s,error_mm3\n"
            "0.5,2,0.2,average,120.5,3\n"
            "0.7,1,0.3,tangential,,1e-09\n"
            "0.9,1,0.3,tangential,,\n");
}

TEST_F(FrontCsvTest, ReadsBackWhatItWrote) {
  DesignSpace space = mixedSpace();
  space[3].choices = {"0,0,1", "average"};
  EXPECT_TRUE(rc::check([&](std::uint64_t seed) {
    Random random(seed);
    std::vector<Evaluation> front;
    for (int i = 0; i < 5; ++i)
      front.push_back({randomPoint(space, random), {random.normal(0.0, 1e9), random.uniform(0.0, 1.0)}, ""});
    const FrontTable table = read(frontCsv(space, {"time_s", "error_mm3"}, front));
    RC_ASSERT(table.variables == (std::vector<std::string>{"pitch_mm", "walls", "layer_mm", "link"}));
    RC_ASSERT(table.responses == (std::vector<std::string>{"time_s", "error_mm3"}));
    for (std::size_t i = 0; i < front.size(); ++i) {
      RC_ASSERT(table.rows[i].responses == front[i].responses);
      RC_ASSERT(table.rows[i].line == i + 3);
      for (std::size_t j = 0; j < space.size(); ++j)
        RC_ASSERT(valueOf(space[j], table.rows[i].values[j]) == front[i].point[j]);
    }
  }));
}

TEST_F(FrontCsvTest, SaysWhatIsWrongWithAFile) {
  EXPECT_TRUE(std::isnan(read("a,b\n# variables 1\n1,\n").rows[0].responses[0]));
  EXPECT_NE(refusal("a,b\n1,2\n").find("does not report which columns are variables"), std::string::npos);
  EXPECT_NE(refusal("# variables two\na,b\n1,2\n").find("'two' variables"), std::string::npos);
  EXPECT_NE(refusal("# variables 2\na,b\n1,2\n").find("below 2"), std::string::npos);
  EXPECT_NE(refusal("# variables 1\na,b\n").find("holds no point"), std::string::npos);
  EXPECT_NE(refusal("# variables 1\na,b\n1,2x\n").find("line 3: b is '2x'"), std::string::npos);
  EXPECT_NE(refusal("# variables 1\na,b\n1,inf\n").find("line 3: b is 'inf'"), std::string::npos);
  EXPECT_NE(refusal("# variables 1\na,b\n1\n").find("line 3"), std::string::npos);
}

}  // namespace
}  // namespace lamina
