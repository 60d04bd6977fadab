#include "study/store_file.hpp"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "dashpad/study/study.hpp"
#include "dashpad/study/study_file.hpp"
#include "dashpad/version.hpp"
#include "json/json_values.hpp"
#include "quantities/text.hpp"

namespace dashpad::study {

namespace {

constexpr std::int64_t application = 0x44706164;  ///< "Dpad": tells tools whose file this is
constexpr std::int64_t layout = 1;

constexpr const char* tables = R"(
CREATE TABLE study (key TEXT PRIMARY KEY, value) WITHOUT ROWID;
CREATE TABLE factors (position INTEGER PRIMARY KEY, key TEXT NOT NULL, unit TEXT NOT NULL);
CREATE TABLE responses (position INTEGER PRIMARY KEY, name TEXT NOT NULL, unit TEXT NOT NULL, meaning TEXT NOT NULL);
CREATE TABLE materials (number INTEGER PRIMARY KEY, name TEXT NOT NULL);
CREATE TABLE batches (batch INTEGER PRIMARY KEY, rows INTEGER NOT NULL);
)";

/// The rows of a batch, the unit of loss and of waiting at an interruption: 256 rows take 5 ms to 3 s. Small
/// studies get enough batches for all cores.
std::uint64_t batch_size_of(std::uint64_t rows) {
  constexpr std::uint64_t most = 256, batches = 64;
  return std::clamp<std::uint64_t>(rows / batches, 1, most);
}

std::uint64_t bytes_per_row(const StoreHeading& heading) {
  constexpr std::uint64_t number = 9, other_columns = 50;  // a value and its type; row, status, flags, error
  return other_columns + number * (heading.factors.size() + heading.responses.size());
}

StoredColumn response_column(const std::string& name) {
  const ResultQuantity* kind = find_response_kind(name);
  if (kind == nullptr) throw std::invalid_argument("no response \"" + name + "\"");
  const bool is_of_blows = name != kind->key;
  return {name, kind->si_unit, is_of_blows ? response_title(name) : kind->meaning};
}

void write_facts(const Database& database, const StoreHeading& heading, const Study& study) {
  Statement fact{database, "INSERT INTO study VALUES (?, ?)"};
  fact.run_with("title", study.title);
  fact.run_with("text", heading.text);
  fact.run_with("resolved", heading.resolved);
  fact.run_with("program", heading.program);
  // The seed may need all 64 bits; SQLite's integers have a sign.
  fact.run_with("seed", std::to_string(study.seed));
  fact.run_with("rows", static_cast<std::int64_t>(heading.rows));
  fact.run_with("batch_size", static_cast<std::int64_t>(heading.batch_size));
}

std::int64_t single_integer(const Database& database, const std::string& select) {
  Statement statement{database, select};
  return statement.next() ? statement.integer(0) : 0;
}

/// The row of a fact; its value is in column 0.
Statement fact(const Database& database, const std::string& key) {
  Statement row{database, "SELECT value FROM study WHERE key = ?"};
  if (!row.bind(0, key).next()) database.damaged("the entry " + key + " is missing");
  return row;
}

std::uint64_t count_fact(const Database& database, const std::string& key) {
  return fact(database, key).count(0, std::numeric_limits<std::int64_t>::max());
}

std::vector<StoredColumn> read_columns(const Database& database, const char* select) {
  Statement statement{database, select};
  std::vector<StoredColumn> columns;
  while (statement.next()) {
    if (statement.count(0, columns.size()) != columns.size()) database.damaged("a column is missing");
    columns.push_back({statement.name(1), statement.name(2), statement.name(3)});
  }
  return columns;
}

/// A view in the place of a table may be anything that SQL can say, and go on for ever.
void check_tables(const Database& database) {
  if (single_integer(database,
                     "SELECT count(*) FROM sqlite_master WHERE type = 'table' AND rootpage > 0 AND name IN "
                     "('study', 'factors', 'responses', 'materials', 'batches', 'samples')") != 6)
    database.damaged("a table is missing");
}

void check_columns(const Database& database, const StoreHeading& heading) {
  constexpr std::size_t others = 5;  // row, status, extrapolated, bottomed, error
  if (single_integer(database, "SELECT count(*) FROM pragma_table_info('samples')") !=
      static_cast<std::int64_t>(others + heading.factors.size() + heading.responses.size()))
    database.damaged("a factor or response is missing");
}

/// Checks the units against those of the computation: a unit changed by hand would be read wrongly.
void check_units(const Database& database, const StoreHeading& heading) {
  const auto changed = [&](const std::string& name) {
    database.damaged(fmt::format("{} does not have the unit in which it was computed", quoted_part(name)));
  };
  for (const StoredColumn& column : heading.responses)
    if (const ResultQuantity* kind = find_response_kind(column.name);
        kind != nullptr && kind->si_unit != column.unit)
      changed(column.name);
  const Json resolved = Json::parse(heading.resolved, nullptr, false);
  const Json factors = resolved.is_object() ? resolved.value("factors", Json()) : Json();
  if (!factors.is_array() || factors.size() != heading.factors.size())
    database.damaged("the study cannot be read");
  for (std::size_t i = 0; i < factors.size(); ++i) {
    const StoredColumn& column = heading.factors[i];
    if (!factors[i].is_object() || factors[i].value("key", Json()) != column.name)
      database.damaged("the study cannot be read");
    if (factors[i].value("unit", Json()) != column.unit) changed(column.name);
  }
}

}  // namespace

StoreHeading heading_of(const Study& study) {
  StoreHeading heading{.program = fmt::format("{} ({})", version(), build_facts().git_commit),
                       .text = study.text,
                       .resolved = resolved_text(study),
                       .rows = Design{study}.rows(),
                       .factors = {},
                       .responses = {}};
  heading.batch_size = batch_size_of(heading.rows);
  for (const Factor& factor : study.factors) heading.factors.push_back({factor.key, factor.unit, ""});
  for (const std::string& name : study.responses) heading.responses.push_back(response_column(name));
  return heading;
}

bool is_empty(const Database& database) {
  return single_integer(database, "SELECT count(*) FROM sqlite_master") == 0;
}

void create_tables(Database& database, const Study& study, const StoreHeading& heading) {
  database.execute(fmt::format("PRAGMA application_id = {}; PRAGMA user_version = {};", application, layout));
  database.execute(tables);
  database.execute(
      "CREATE TABLE samples (row INTEGER PRIMARY KEY, status TEXT NOT NULL, extrapolated INTEGER NOT "
      "NULL, bottomed INTEGER NOT NULL, error REAL" +
      value_columns(heading, "", " REAL") + ")");
  write_facts(database, heading, study);

  Statement factor{database, "INSERT INTO factors VALUES (?, ?, ?)"};
  for (std::int64_t position = 0; const StoredColumn& column : heading.factors)
    factor.run_with(position++, column.name, column.unit);
  Statement response{database, "INSERT INTO responses VALUES (?, ?, ?, ?)"};
  for (std::int64_t position = 0; const StoredColumn& column : heading.responses)
    response.run_with(position++, column.name, column.unit, column.meaning);
  Statement material{database, "INSERT INTO materials VALUES (?, ?)"};
  for (std::int64_t number = 0; const Material& each : study.materials)
    material.run_with(number++, each.name);
}

StoreHeading read_heading(const Database& database) {
  if (single_integer(database, "PRAGMA application_id") != application)
    throw DamagedStore(database.name() + ": not the store of a study; give another name");
  if (const std::int64_t found = single_integer(database, "PRAGMA user_version"); found != layout)
    throw std::runtime_error(
        fmt::format("{}: the store has layout {}, but this version of Dashpad reads layout {}; use the "
                    "version that made it",
                    database.name(), found, layout));
  check_tables(database);
  StoreHeading heading{.program = fact(database, "program").name(0),
                       .text = fact(database, "text").text(0),
                       .resolved = fact(database, "resolved").text(0),
                       .rows = count_fact(database, "rows"),
                       .batch_size = count_fact(database, "batch_size"),
                       .factors = {},
                       .responses = {}};
  if (heading.batch_size == 0) database.damaged("the batches have no rows");
  heading.factors = read_columns(database, "SELECT position, key, unit, '' FROM factors ORDER BY position");
  heading.responses =
      read_columns(database, "SELECT position, name, unit, meaning FROM responses ORDER BY position");
  check_columns(database, heading);
  check_units(database, heading);
  return heading;
}

std::string value_columns(const StoreHeading& heading, const std::string& before, const std::string& after) {
  std::string columns;
  for (const auto* list : {&heading.factors, &heading.responses})
    for (const StoredColumn& column : *list)
      columns += fmt::format(", {}{}{}", before, sql_name(column.name), after);
  return columns;
}

std::uint64_t log_bytes_of_batch(const StoreHeading& heading) {
  constexpr std::uint64_t other_pages = 8;  // ends of tables, their indices, the first page
  return heading.batch_size * bytes_per_row(heading) + other_pages * page_bytes;
}

std::uint64_t bytes_of_tables(const StoreHeading& heading) {
  constexpr std::uint64_t pages = 12;  // seven tables with their heading, and texts that end within a page
  return pages * page_bytes + heading.text.size() + heading.resolved.size();
}

std::uint64_t bytes_of_rows(const StoreHeading& heading, std::uint64_t rows) {
  constexpr std::uint64_t index_of_log = 4 * page_bytes;
  return rows * bytes_per_row(heading) + 2 * log_bytes_of_batch(heading) + index_of_log;
}

}  // namespace dashpad::study
