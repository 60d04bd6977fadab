// The account that a store gives of its study: JSON.

#include <sqlite3.h>

#include <cstdint>

#include "reading.hpp"
#include "sound_store.hpp"

using namespace dashpad::fuzz;

namespace {

void set_account(const std::filesystem::path& file, std::string_view account) {
  sqlite3* database = nullptr;
  require(sqlite3_open(file.c_str(), &database) == SQLITE_OK, "the sound store can be opened");
  sqlite3_exec(database, "PRAGMA synchronous = OFF; PRAGMA journal_mode = MEMORY", nullptr, nullptr, nullptr);
  sqlite3_stmt* update = nullptr;
  sqlite3_prepare_v2(database, "UPDATE study SET value = ? WHERE key = 'resolved'", -1, &update, nullptr);
  sqlite3_bind_text(update, 1, account.data(), static_cast<int>(account.size()), SQLITE_TRANSIENT);
  require(sqlite3_step(update) == SQLITE_DONE, "the sound store can be changed");
  sqlite3_finalize(update);
  sqlite3_close(database);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const std::filesystem::path file = fresh_store();
  set_account(file, text_of(bytes, size));
  read_store(file);
  return 0;
}
