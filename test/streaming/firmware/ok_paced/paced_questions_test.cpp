// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/firmware/ok_paced/paced_questions.hpp"

#include <gtest/gtest.h>

namespace lamina {
namespace {

SyncAnswer to(std::uint64_t question) {
  SyncAnswer answer;
  answer.question = question;
  return answer;
}

TEST(PacedQuestions, TheLastOneIsNumberedOnThroughAllPhases) {
  PacedQuestions questions;
  EXPECT_EQ(questions.ask(), 1U);
  EXPECT_EQ(questions.ask(), 2U);
  EXPECT_FALSE(questions.hear(to(1)));
  EXPECT_TRUE(questions.hear(to(2)));
  questions.keep(to(2));
  EXPECT_TRUE(questions.answer());
  questions.begin();
  EXPECT_FALSE(questions.answer());
  EXPECT_EQ(questions.ask(), 3U);
}

TEST(PacedQuestions, AnOkMoreThanQuestionsIsThatOfTheLine) {
  for (const int oks : {0, 1, 2}) {
    PacedQuestions questions;
    questions.ask();
    questions.begin();
    questions.ask();
    questions.ask();
    for (int i = 0; i < oks; ++i) questions.hearOk();
    EXPECT_TRUE(questions.hear(to(3)));
    EXPECT_EQ(questions.isLineAnswered(), oks == 2) << oks << " oks, of which one may be that of question 2";
  }
}

TEST(PacedQuestions, AnswersFromBeforeSayNothingOfTheLine) {
  PacedQuestions questions;
  questions.ask();
  questions.begin();
  questions.ask();
  questions.hearOk();
  questions.hearOk();
  EXPECT_FALSE(questions.hear(to(1)));
  EXPECT_FALSE(questions.isLineAnswered());
}

}  // namespace
}  // namespace lamina
