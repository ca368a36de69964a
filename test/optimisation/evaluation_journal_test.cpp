// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <sys/resource.h>

#include <cmath>
#include <csignal>
#include <cstdio>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/random.hpp"
#include "lamina/optimisation/evaluation_journal.hpp"
#include "support/scratch_folder.hpp"
#include "test_problems.hpp"

namespace lamina {
namespace {

/// A file name for one test, without a file.
class EvaluationJournalTest : public ::testing::Test {
 protected:
  JournalSettings settings(EarlierJournal earlier = EarlierJournal::GoOn) const {
    return {path_, "part 1", earlier};
  }

  std::string refusal(const DesignSpace& space, const JournalSettings& settings) const {
    CountingEvaluator inner;
    try {
      const JournalledEvaluator journal(inner, space, settings);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  }

  const test::ScratchFolder folder_;
  const std::string path_ = folder_.file("journal.jsonl");
  NoProgress progress_;
};

TEST_F(EvaluationJournalTest, TriesNoPointTwice) {
  CountingEvaluator inner;
  JournalledEvaluator journal(inner, mixedSpace(), {});
  const std::vector<DesignPoint> points = {{0.5, 2.0, 0.2, 1.0}, {0.7, 1.0, 0.3, 0.0}, {0.5, 2.0, 0.2, 1.0}};
  int reported = 0;
  const auto first = journal.evaluate(
      points, [&](const Evaluation&) { ++reported; }, progress_);
  EXPECT_EQ(inner.tried(), 2);
  EXPECT_EQ(reported, 3);
  EXPECT_EQ(first[0].responses, first[2].responses);
  EXPECT_EQ(first[1].point, points[1]);
  journal.evaluate(points, {}, progress_);
  EXPECT_EQ(inner.tried(), 2);
  EXPECT_EQ(journal.evaluations().size(), 2U);
}

TEST_F(EvaluationJournalTest, ReadsBackWhatItWroteBitForBit) {
  EXPECT_TRUE(rc::check([this](std::uint64_t seed) {
    std::remove(path_.c_str());
    Random random(seed);
    std::vector<DesignPoint> points;
    for (int i = 0; i < 10; ++i) points.push_back(randomPoint(mixedSpace(), random));
    CountingEvaluator inner;
    const auto written = JournalledEvaluator(inner, mixedSpace(), settings()).evaluate(points, {}, progress_);
    CountingEvaluator untouched;
    const auto read =
        JournalledEvaluator(untouched, mixedSpace(), settings()).evaluate(points, {}, progress_);
    RC_ASSERT(untouched.tried() == 0);
    RC_ASSERT(textOf(written) == textOf(read));
  }));
}

TEST_F(EvaluationJournalTest, KeepsResponsesThatAreNoNumbers) {
  ParallelEvaluator inner({"a", "b", "c"}, [](const DesignPoint&, Progress&) {
    return std::vector<double>{NAN, INFINITY, -INFINITY};
  });
  JournalledEvaluator(inner, mixedSpace(), settings()).evaluate({{0.5, 2.0, 0.2, 1.0}}, {}, progress_);
  const JournalledEvaluator journal(inner, mixedSpace(), settings());
  const std::vector<double> responses = journal.evaluations().at(0).responses;
  EXPECT_TRUE(std::isnan(responses[0]));
  EXPECT_EQ(responses[1], INFINITY);
  EXPECT_EQ(responses[2], -INFINITY);
}

TEST_F(EvaluationJournalTest, RemembersFailuresAndRetriesThemIfAsked) {
  const std::vector<DesignPoint> points = {{0.4, 1.0, 0.2, 0.0}, {2.0, 1.0, 0.2, 0.0}};
  CountingEvaluator failing(1.0);
  const auto first = JournalledEvaluator(failing, mixedSpace(), settings()).evaluate(points, {}, progress_);
  EXPECT_TRUE(isEvaluated(first[0]));
  EXPECT_EQ(first[1].error, "pitch 2 is too great: \"\xC3\xA9\"\n");
  CountingEvaluator mended;
  const auto kept = JournalledEvaluator(mended, mixedSpace(), settings()).evaluate(points, {}, progress_);
  EXPECT_EQ(mended.tried(), 0);
  EXPECT_EQ(textOf(kept), textOf(first));
  const auto retried = JournalledEvaluator(mended, mixedSpace(), settings(EarlierJournal::RetryFailed))
                           .evaluate(points, {}, progress_);
  EXPECT_EQ(mended.tried(), 1);
  EXPECT_TRUE(isEvaluated(retried[1]));
  const JournalledEvaluator last(mended, mixedSpace(), settings());
  EXPECT_EQ(last.evaluations().size(), 2U);
  EXPECT_TRUE(isEvaluated(last.evaluations()[1]));
}

TEST_F(EvaluationJournalTest, DropsATornLastLineWhereverItIsTorn) {
  CountingEvaluator inner;
  JournalledEvaluator(inner, mixedSpace(), settings())
      .evaluate({{0.5, 2.0, 0.2, 1.0}, {0.7, 1.0, 0.3, 0.0}}, {}, progress_);
  const std::string whole = readFile(path_);
  const std::size_t header_end = whole.find('\n') + 1;
  const std::size_t first_end = whole.find('\n', header_end) + 1;
  for (std::size_t length = 0; length < whole.size(); ++length) {
    writeFile(path_, whole.substr(0, length));
    const JournalledEvaluator journal(inner, mixedSpace(), settings());
    EXPECT_EQ(journal.evaluations().size(), length < first_end ? 0U : 1U) << length;
    const std::size_t kept = length < first_end ? header_end : first_end;
    EXPECT_EQ(readFile(path_), whole.substr(0, kept)) << length;
  }
}

TEST_F(EvaluationJournalTest, RefusesTheJournalOfAnotherStudyAndLeavesItAsItWas) {
  CountingEvaluator inner;
  JournalledEvaluator(inner, mixedSpace(), settings()).evaluate({{0.5, 2.0, 0.2, 1.0}}, {}, progress_);
  const std::string whole = readFile(path_);
  JournalSettings other = settings();
  other.fingerprint = "part 2";
  EXPECT_NE(refusal(mixedSpace(), other).find("fingerprint \"part 1\"; expected \"part 2\""),
            std::string::npos);
  DesignSpace wider = mixedSpace();
  wider[0].high = 3.0;
  EXPECT_NE(refusal(wider, settings()).find("belongs to another study: variables"), std::string::npos);
  EXPECT_EQ(readFile(path_), whole);
  writeFile(path_, "my diary");
  EXPECT_NE(refusal(mixedSpace(), settings()).find("line 1 is no header"), std::string::npos);
  EXPECT_EQ(readFile(path_), "my diary");
  writeFile(path_, "{\"a\": 1}\n");
  EXPECT_NE(refusal(mixedSpace(), settings()).find("line 1 is no header"), std::string::npos);
}

TEST_F(EvaluationJournalTest, IsBegunAnewWhateverStoodInItUnlessAnotherRunWritesIt) {
  CountingEvaluator inner;
  const std::vector<DesignPoint> points = {{0.5, 2.0, 0.2, 1.0}};
  JournalledEvaluator(inner, mixedSpace(), settings()).evaluate(points, {}, progress_);
  const std::string whole = readFile(path_);
  JournalSettings anew = settings(EarlierJournal::BeginAnew);
  anew.fingerprint = "part 2";
  {
    const JournalledEvaluator other(inner, mixedSpace(), settings());
    EXPECT_NE(refusal(mixedSpace(), anew).find("written by another run"), std::string::npos);
    EXPECT_EQ(readFile(path_), whole);
  }
  JournalledEvaluator journal(inner, mixedSpace(), anew);
  EXPECT_TRUE(journal.evaluations().empty());
  journal.evaluate(points, {}, progress_);
  EXPECT_EQ(inner.tried(), 2);
  EXPECT_EQ(readFile(path_).find("part 1"), std::string::npos);
}

TEST_F(EvaluationJournalTest, NamesTheLineThatIsNoneOfAJournal) {
  CountingEvaluator inner;
  JournalledEvaluator(inner, mixedSpace(), settings())
      .evaluate({{0.5, 2.0, 0.2, 1.0}, {0.7, 1.0, 0.3, 0.0}}, {}, progress_);
  const std::string whole = readFile(path_);
  const std::size_t second = whole.find('\n') + 1;
  const std::vector<std::pair<std::string, std::string>> faults = {
      {"", "line 2 is no JSON"},
      {"{\"point\":[0.5,2.0,", "line 2 is no JSON"},
      {"[]", "line 2 has no list 'point'"},
      {R"({"point":[0.5,2,0.2],"responses":[1,2]})", "line 2 has 3 numbers in 'point'; expected 4"},
      {R"({"point":[9,2,0.2,"average"],"responses":[1,2]})", "line 2 variable pitch_mm: 9"},
      {R"({"point":[0.5,2,0.2,"radial"],"responses":[1,2]})", "line 2 variable link: 'radial'"},
      {R"({"point":[0.5,2,0.2,1],"responses":[1,2]})", "line 2 has 1 for link"},
      {R"({"point":[0.5,2,0.2,"average"],"responses":[1]})", "line 2 has 1 numbers in 'responses'"},
      {R"({"point":[0.5,2,0.2,"average"],"responses":[1,null]})", "line 2 has null where a number"},
      {R"({"point":[0.5,2,0.2,"average"]})", "line 2 has no list 'responses'"},
      {R"({"point":[0.5,2,0.2,"average"],"error":""})", "line 2 has an error that is no text"}};
  for (const auto& [line, message] : faults) {
    writeFile(path_, whole.substr(0, second) + line + "\n" + whole.substr(second));
    EXPECT_NE(refusal(mixedSpace(), settings()).find(message), std::string::npos)
        << refusal(mixedSpace(), settings());
  }
}

TEST_F(EvaluationJournalTest, ReadsAnyBytesOrRefusesThem) {
  CountingEvaluator inner;
  JournalledEvaluator(inner, mixedSpace(), settings())
      .evaluate({{0.5, 2.0, 0.2, 1.0}, {0.7, 1.0, 0.3, 0.0}}, {}, progress_);
  const std::string whole = readFile(path_);
  EXPECT_TRUE(rc::check([&](std::uint64_t seed) {
    Random random(seed);
    std::string broken = whole;
    for (std::uint64_t i = 0; i <= random.below(4); ++i) {
      const std::size_t at = random.below(broken.size());
      const auto byte = static_cast<char>(random.below(256));
      random.below(2) == 0 ? void(broken[at] = byte) : void(broken.erase(at, random.below(9)));
    }
    writeFile(path_, broken);
    const std::string reported = refusal(mixedSpace(), settings());
    // What is refused stays as it is; what is read is a prefix in whole lines, or a header anew.
    if (reported.empty()) {
      const std::string kept = readFile(path_);
      RC_ASSERT(kept.back() == '\n');
    } else {
      RC_ASSERT(readFile(path_) == broken);
    }
  }));
}

TEST_F(EvaluationJournalTest, IsWrittenByOneRunAtATime) {
  CountingEvaluator inner;
  const JournalledEvaluator first(inner, mixedSpace(), settings());
  EXPECT_NE(refusal(mixedSpace(), settings()).find("written by another run"), std::string::npos);
  EXPECT_NE(refusal(mixedSpace(), {"/no/such/folder/j", "", EarlierJournal::GoOn}).find("/no/such/folder/j"),
            std::string::npos);
}

TEST_F(EvaluationJournalTest, IsAFileAndNoDevice) {
  EXPECT_NE(refusal(mixedSpace(), {"/dev/full", "", EarlierJournal::GoOn}).find("is no file"),
            std::string::npos);
}

/// While it lives, no file of this process grows beyond so many bytes.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  void (*handler_)(int);
  rlimit before_{};
};

TEST_F(EvaluationJournalTest, SaysThatNoMoreCanBeWrittenAndCanBeReadAfterwards) {
  CountingEvaluator inner;
  const std::vector<DesignPoint> points = {{0.5, 2.0, 0.2, 1.0}, {0.7, 1.0, 0.3, 0.0}};
  JournalledEvaluator(inner, mixedSpace(), settings()).evaluate({points[0]}, {}, progress_);
  const std::string whole = readFile(path_);
  {
    JournalledEvaluator journal(inner, mixedSpace(), settings());
    {
      const FileSizeLimit full(whole.size() + 20);
      EXPECT_THROW(journal.evaluate(points, {}, progress_), FileError);
    }
    EXPECT_EQ(readFile(path_), whole);
    EXPECT_THROW(journal.evaluate(points, {}, progress_), FileError);
    EXPECT_EQ(readFile(path_), whole);
  }
  const JournalledEvaluator journal(inner, mixedSpace(), settings());
  EXPECT_EQ(journal.evaluations().size(), 1U);
}

/// Answers each point by another nearby, reports nobody, and forgets some.
class CarelessEvaluator final : public Evaluator {
 public:
  explicit CarelessEvaluator(std::size_t forgotten) : forgotten_(forgotten) {}
  const std::vector<std::string>& responseNames() const override { return names_; }
  std::vector<Evaluation> evaluate(const std::vector<DesignPoint>& points, const EvaluationListener&,
                                   Progress&) override {
    std::vector<Evaluation> evaluations;
    for (std::size_t i = forgotten_; i < points.size(); ++i)
      evaluations.push_back({{points[i][0] + 0.01, 2.0, 0.2, 1.0}, {points[i][0]}, ""});
    return evaluations;
  }

 private:
  std::vector<std::string> names_ = {"a"};
  std::size_t forgotten_;
};

TEST_F(EvaluationJournalTest, NotesAnswersAtThePointsAskedFor) {
  const std::vector<DesignPoint> points = {{0.5, 2.0, 0.2, 1.0}, {0.7, 1.0, 0.3, 0.0}, {0.5, 2.0, 0.2, 1.0}};
  CarelessEvaluator inner(0);
  int reported = 0;
  JournalledEvaluator journal(inner, mixedSpace(), settings());
  const auto found = journal.evaluate(
      points, [&](const Evaluation&) { ++reported; }, progress_);
  EXPECT_EQ(reported, 3);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(found[i].point, points[i]);
    EXPECT_EQ(found[i].responses, (std::vector<double>{points[i][0]}));
  }
  CarelessEvaluator forgetful(1);
  EXPECT_THROW(JournalledEvaluator(forgetful, mixedSpace(), {}).evaluate(points, {}, progress_), Error);
}

TEST_F(EvaluationJournalTest, RefusesPointsOutsideTheSpace) {
  CountingEvaluator inner;
  JournalledEvaluator journal(inner, mixedSpace(), settings());
  EXPECT_THROW(journal.evaluate({{9.0, 2.0, 0.2, 1.0}}, {}, progress_), InvalidInput);
  EXPECT_EQ(inner.tried(), 0);
}

}  // namespace
}  // namespace lamina
