CREATE TABLE artefact (id INTEGER PRIMARY KEY, sha256 TEXT NOT NULL UNIQUE, bytes INTEGER NOT NULL, kind TEXT NOT NULL,
  name TEXT NOT NULL, created REAL NOT NULL) STRICT;
CREATE TABLE job (id INTEGER PRIMARY KEY AUTOINCREMENT, digest TEXT NOT NULL, name TEXT NOT NULL, part TEXT NOT NULL,
  machine TEXT NOT NULL, state INTEGER NOT NULL, position INTEGER NOT NULL, created REAL NOT NULL, created_by TEXT NOT NULL,
  released_by TEXT NOT NULL DEFAULT '', is_removed INTEGER NOT NULL DEFAULT 0) STRICT;
CREATE TABLE job_artefact (job INTEGER NOT NULL REFERENCES job, artefact INTEGER NOT NULL REFERENCES artefact,
  kind TEXT NOT NULL, name TEXT NOT NULL, PRIMARY KEY (job, kind, name)) STRICT;
CREATE TABLE execution (id INTEGER PRIMARY KEY AUTOINCREMENT, job INTEGER NOT NULL REFERENCES job, attempt INTEGER NOT NULL,
  started REAL NOT NULL, ended REAL, outcome INTEGER, reason TEXT NOT NULL DEFAULT '', operator TEXT NOT NULL) STRICT;
CREATE UNIQUE INDEX one_open_execution ON execution (ended IS NULL) WHERE ended IS NULL;
CREATE TABLE progress (execution INTEGER PRIMARY KEY REFERENCES execution, sent_through INTEGER NOT NULL,
  taken_through INTEGER NOT NULL, layer INTEGER NOT NULL, path_mm REAL NOT NULL, laid_mm3 REAL NOT NULL,
  updated REAL NOT NULL) STRICT;
CREATE TABLE transition (id INTEGER PRIMARY KEY, time REAL NOT NULL, mode INTEGER NOT NULL, from_state INTEGER NOT NULL,
  to_state INTEGER NOT NULL, command INTEGER NOT NULL, source TEXT NOT NULL, reason TEXT NOT NULL) STRICT;
CREATE TABLE alarm (id INTEGER PRIMARY KEY, execution INTEGER REFERENCES execution, time REAL NOT NULL, alarm INTEGER NOT NULL,
  value REAL NOT NULL, category TEXT NOT NULL, message TEXT NOT NULL) STRICT;
CREATE INDEX alarm_by_execution ON alarm (execution, time);
CREATE TABLE counter (name TEXT PRIMARY KEY, value REAL NOT NULL) STRICT;
CREATE TABLE audit (id INTEGER PRIMARY KEY AUTOINCREMENT, time REAL NOT NULL, who TEXT NOT NULL, origin TEXT NOT NULL, what TEXT NOT NULL,
  result TEXT NOT NULL, digest TEXT NOT NULL) STRICT;
INSERT INTO job (id, digest, name, part, machine, state, position, created, created_by) VALUES (7, 'd', 'old', 'old.stl', 'gantry', 3, 1, 10.0, 'anna');
INSERT INTO execution (id, job, attempt, started, operator) VALUES (3, 7, 1, 20.0, 'anna');
INSERT INTO progress VALUES (3, 50, 40, 2, 0.0, 0.0, 30.0);
INSERT INTO alarm VALUES (1, 3, 25.0, 3202, 20.5, 'H', 'vacuum is 20.5 kPa');
PRAGMA user_version = 1;
