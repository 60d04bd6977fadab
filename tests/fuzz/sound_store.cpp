#include "sound_store.hpp"

#include <cmath>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "dashpad/study/study.hpp"
#include "dashpad/study/study_file.hpp"
#include "reading.hpp"
#include "unit/small_study.hpp"

namespace dashpad::fuzz {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t rows = 4;

struct Made {
  std::string bytes;
  std::string account;
};

const Made& made() {
  static const Made made = [] {
    const fs::path file = folder() / "sound.db";
    std::string account;
    {
      study::Store store = study::Store::open_for(test::small_study(rows), file);
      test::fill(store);
      account = store.resolved_text();
    }
    // One file, without a log beside it.
    test::edit(file, "PRAGMA journal_mode = DELETE");
    std::ifstream stream(file, std::ios::binary);
    return Made{{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()}, account};
  }();
  return made;
}

void require_sound(const study::Study& study) {
  require(study::violations(study).empty(), "a study that was read breaks no rule");
  require(study.sampling >= study::Sampling::monte_carlo && study.sampling <= study::Sampling::sobol,
          "the sampling is one of three");
  const study::Design design(study);
  std::vector<double> values(study.factors.size());
  design.factors_of(design.rows() - 1, values);
  require_finite(values, "the factors of a row are finite");
}

}  // namespace

const std::string& sound_store() { return made().bytes; }
const std::string& sound_account() { return made().account; }

fs::path fresh_store() {
  for (const char* suffix : {"-wal", "-shm", "-journal"})
    fs::remove(folder() / (std::string("store.db") + suffix));
  return write("store.db", sound_store());
}

void read_store(const fs::path& file) {
  try {
    const study::Store store = study::Store::open_to_read(file);
    require_plain_text(store.program(), "the name of the program is plain text");
    store.visit_rows([&](const study::StoredRow& row) {
      require(row.row < store.rows(), "a row is one of the study's");
      require_finite(row.factors, "the factors of a row are finite");
      for (const double value : row.outcome.values) require(!std::isinf(value), "a response is no infinity");
      require(row.outcome.error >= 0, "an error is not negative");
    });
    for (const auto* columns : {&store.factors(), &store.responses()})
      for (const study::StoredColumn& column : *columns) {
        require_plain_text(column.name + column.unit + column.meaning, "a column has a plain name");
        require(store.column(column.name).size() == store.rows_done(), "a column has a value for each row");
      }
    require_sound(study::stored_study(store));
  } catch (const std::runtime_error& refusal) {
    require_plain_text(refusal.what(), "a refusal is plain text");
  }
}

}  // namespace dashpad::fuzz
