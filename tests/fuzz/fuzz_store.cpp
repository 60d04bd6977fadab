// Stores of studies that another tool changed: the input is what it did, in SQL, or the bytes of the whole
// file.

#include <sqlite3.h>

#include <cstdint>
#include <string>

#include "reading.hpp"
#include "sound_store.hpp"

namespace fs = std::filesystem;
using namespace dashpad::fuzz;

namespace {

constexpr std::string_view first_bytes = "SQLite format 3";
constexpr int longest_value = 1'000'000;  // bytes
constexpr int max_instructions = 100'000;

int stop(void*) { return 1; }

/// What is under test is the reading: the changes themselves must neither take long nor leave the file.
int only_this_file(void*, int action, const char* name, const char*, const char*, const char*) {
  const std::string_view pragma = action == SQLITE_PRAGMA && name != nullptr ? name : "";
  const bool harmless = action != SQLITE_ATTACH && action != SQLITE_DETACH &&
                        (action != SQLITE_PRAGMA || pragma == "application_id" || pragma == "user_version" ||
                         pragma == "writable_schema");
  return harmless ? SQLITE_OK : SQLITE_DENY;
}

void change(const fs::path& file, const std::string& sql) {
  sqlite3* database = nullptr;
  require(sqlite3_open(file.c_str(), &database) == SQLITE_OK, "the sound store can be opened");
  sqlite3_limit(database, SQLITE_LIMIT_LENGTH, longest_value);
  sqlite3_limit(database, SQLITE_LIMIT_ATTACHED, 0);
  sqlite3_set_authorizer(database, only_this_file, nullptr);
  sqlite3_progress_handler(database, max_instructions, stop, nullptr);
  sqlite3_exec(database, "PRAGMA synchronous = OFF", nullptr, nullptr, nullptr);
  sqlite3_exec(database, sql.c_str(), nullptr, nullptr, nullptr);
  sqlite3_close(database);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const std::string_view input = text_of(bytes, size);
  const fs::path file = fresh_store();
  if (input.starts_with(first_bytes))
    write("store.db", input);
  else
    change(file, std::string(input));
  read_store(file);
  return 0;
}
