// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/web/web_store.hpp"

#include <gtest/gtest.h>
#include <sqlite3.h>
#include <sys/stat.h>

#include <fstream>
#include <iterator>

#include "lamina/base/error.hpp"
#include "lamina/base/scratch_folder.hpp"

namespace lamina::test {
namespace {

void runSql(const std::string& path, const std::string& statement) {
  sqlite3* database = nullptr;
  ASSERT_EQ(sqlite3_open(path.c_str(), &database), SQLITE_OK);
  EXPECT_EQ(sqlite3_exec(database, statement.c_str(), nullptr, nullptr, nullptr), SQLITE_OK);
  sqlite3_close(database);
}

TEST(WebStore, KeepsTokensByTheirDigestAlone) {
  const ScratchFolder folder;
  const std::string path = folder.path() + "/page.db";
  std::string token;
  {
    WebStore store(path);
    token = store.add({"anna", WebRole::Operator, 2000.0}, 1000.0);
    ASSERT_TRUE(store.holderOf(token, 1999.0));
    EXPECT_EQ(store.holderOf(token, 1999.0)->role, WebRole::Operator);
    EXPECT_FALSE(store.holderOf(token, 2000.0)) << "expired";
    EXPECT_FALSE(store.holderOf(token.substr(1), 1999.0));
    store.noteUse(1, 1500.0);
  }
  std::string bytes;
  for (const char* suffix : {"", "-wal"}) {
    std::ifstream file(path + suffix, std::ios::binary);
    bytes.append(std::istreambuf_iterator<char>(file), {});
  }
  EXPECT_EQ(bytes.find(token), std::string::npos);
  struct stat facts {};
  ASSERT_EQ(stat(path.c_str(), &facts), 0);
  EXPECT_EQ(facts.st_mode & 0777, 0600U);
  EXPECT_EQ(WebStore(path).tokens().at(0).last_used_s, 1500.0);
}

TEST(WebStore, SeesTokensThatAnotherProcessMakes) {
  const ScratchFolder folder;
  WebStore page(folder.path() + "/page.db");
  WebStore command(folder.path() + "/page.db");
  const std::string token = command.add({"anna", WebRole::Viewer, std::nullopt}, 1.0);
  EXPECT_TRUE(page.holderOf(token, 2.0));
  EXPECT_TRUE(command.remove(1));
  EXPECT_FALSE(page.holder(1, 2.0));
  EXPECT_FALSE(page.remove(1));
}

TEST(WebStore, RefusesNamesThatCannotBeShownAndFilesOfLaterVersions) {
  const ScratchFolder folder;
  const std::string path = folder.path() + "/page.db";
  {
    WebStore store(path);
    EXPECT_THROW(store.add({"", WebRole::Viewer, std::nullopt}, 1.0), InvalidInput);
    EXPECT_THROW(store.add({"a\nb", WebRole::Viewer, std::nullopt}, 1.0), InvalidInput);
    EXPECT_THROW(store.add({std::string(65, 'x'), WebRole::Viewer, std::nullopt}, 1.0), InvalidInput);
  }
  runSql(path, "PRAGMA user_version = 2");
  EXPECT_THROW(WebStore{path}, FileError);
}

TEST(WebStore, FindsTheFirstBadRowOfTheAudit) {
  const ScratchFolder folder;
  const std::string path = folder.path() + "/page.db";
  for (const char* change : {"UPDATE audit SET who = 'eve' WHERE id = 2", "DELETE FROM audit WHERE id = 3"}) {
    WebStore store(path);
    for (int i = 0; i < 3; ++i) store.add(AuditRow{1.0 * i, "anna", "127.0.0.1", "POST /x", "done"});
    if (store.audit(9).size() == 3) {
      EXPECT_EQ(store.firstBadAudit(), std::nullopt);
    }
    runSql(path, change);
    EXPECT_EQ(store.firstBadAudit(), 2) << change << ": the first change stays";
  }
}

TEST(WebStore, MakesKeysThatDiffer) {
  EXPECT_EQ(randomKey().size(), 64U);
  EXPECT_NE(randomKey(), randomKey());
}

}  // namespace
}  // namespace lamina::test
