PRAGMA writable_schema = ON; UPDATE sqlite_master SET sql = 'CREATE TABLE batches (batch TEXT, rows BLOB)' WHERE name = 'batches'; PRAGMA user_version = 2
