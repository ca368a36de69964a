// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/web/web_store.hpp"

#include <gtest/gtest.h>
#include <sqlite3.h>
#include <sys/stat.h>

#include <atomic>
#include <fstream>
#include <iterator>
#include <thread>

#include "lamina/base/error.hpp"
#include "lamina/base/scratch_folder.hpp"
#include "lamina/base/sha256.hpp"

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
  runSql(path, "PRAGMA user_version = 3");
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

void overwrite(const std::string& path, std::streamoff at, const std::string& bytes) {
  std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
  file.seekp(at);
  file << bytes;
}

TEST(WebStore, IsBegunAnewWhereItsFileIsDamaged) {
  const ScratchFolder folder;
  const std::string path = folder.path() + "/page.db";
  EXPECT_EQ(moveDamagedStoreAside(path), "") << "there is none yet";
  int damaged = 0;
  // The head of the file, then what is behind its first page of 4096 bytes.
  for (const std::streamoff at : {std::streamoff{0}, std::streamoff{4096}}) {
    {
      WebStore store(path);
      store.add({"anna", WebRole::Operator, std::nullopt}, 1000.0);
      for (int i = 0; i < 100; ++i) store.add({1.0, "anna", "", std::string(200, 'x'), "done"});
    }
    EXPECT_EQ(moveDamagedStoreAside(path), "");
    overwrite(path, at, std::string(20000, '?'));
    const std::string aside = moveDamagedStoreAside(path);
    EXPECT_EQ(aside, path + ".damaged" + std::to_string(++damaged));
    EXPECT_EQ(std::ifstream(aside).seekg(at).get(), '?');
    EXPECT_TRUE(WebStore(path).tokens().empty());
  }
}

TEST(WebStore, BringsAStoreOfTheFirstVersionForward) {
  const ScratchFolder folder;
  const std::string path = folder.path() + "/page.db";
  std::string token;
  {
    WebStore store(path);
    token = store.add({"anna", WebRole::Operator, std::nullopt}, 1000.0);
  }
  runSql(path,
         "ALTER TABLE answer DROP COLUMN request; INSERT INTO answer VALUES ('1 k', 1000, 200, '{}');"
         "PRAGMA user_version = 1");
  WebStore store(path);
  EXPECT_TRUE(store.holderOf(token, 1001.0));
  EXPECT_FALSE(store.begin("1 k", "digest", 1001.0)) << "what it was of is not known";
  EXPECT_TRUE(store.begin("1 k", "digest", 1002.0));
}

TEST(WebStore, BeginsARequestOnceForADay) {
  const ScratchFolder folder;
  WebStore store(folder.path() + "/page.db");
  EXPECT_FALSE(store.begin("1 k", "a", 1000.0));
  ASSERT_TRUE(store.begin("1 k", "b", 1001.0));
  EXPECT_EQ(store.begin("1 k", "b", 1001.0)->request, "a");
  EXPECT_FALSE(store.begin("1 k", "b", 1001.0)->answer);
  store.keep("1 k", {201, "done"});
  ASSERT_TRUE(store.begin("1 k", "a", 87400.0)->answer);
  EXPECT_EQ(store.begin("1 k", "a", 87400.0)->answer->body, "done");
  EXPECT_FALSE(store.begin("1 k", "a", 87400.5)) << "a day later";
  store.forget("1 k");
  EXPECT_FALSE(store.begin("1 k", "a", 87401.0));
}

/// Fills an audit with whole rows in one transaction: each is chained as `AuditRow`s are.
void addManyRows(const std::string& path, int count) {
  std::string sql = "BEGIN;";
  std::string before;
  for (int i = 0; i < count; ++i) {
    before = sha256Of(before + "8:0.0000004:anna1:a1:b4:done");
    sql +=
        "INSERT INTO audit (time, who, origin, what, result, digest) VALUES (0, 'anna', 'a', 'b', 'done', '" +
        before + "');";
  }
  runSql(path, sql + "COMMIT");
}

TEST(WebStore, LooksTokensUpWhileTheAuditIsChecked) {
  const ScratchFolder folder;
  WebStore store(folder.path() + "/page.db");
  const std::string token = store.add({"anna", WebRole::Operator, std::nullopt}, 1.0);
  addManyRows(folder.path() + "/page.db", 30000);
  std::atomic<bool> is_checked{false};
  std::thread checking([&] {
    EXPECT_EQ(store.firstBadAudit(), std::nullopt);
    is_checked = true;
  });
  int found = 0;
  while (!is_checked) found += store.holderOf(token, 2.0) ? 1 : 0;
  checking.join();
  EXPECT_GT(found, 20) << "each waited for the audit";
}

TEST(WebStore, MakesKeysThatDiffer) {
  EXPECT_EQ(randomKey().size(), 64U);
  EXPECT_NE(randomKey(), randomKey());
}

}  // namespace
}  // namespace lamina::test
