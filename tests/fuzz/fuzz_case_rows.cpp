// Tables of rows and of draws of a study.

#include <cstdint>

#include "dashpad/study/study.hpp"
#include "dashpad/study/study_file.hpp"
#include "reading.hpp"

namespace fs = std::filesystem;
using namespace dashpad;
using namespace dashpad::fuzz;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const fs::path source = DASHPAD_SOURCE_DIR;
  static const bool has_case =
      fs::copy_file(source / "examples/dashboard-20mph.toml", folder() / "case.toml");
  require(has_case, "the case is there");
  write("design.csv", text_of(bytes, size));
  for (const char* const key : {"rows", "samples_from"}) {
    const fs::path file =
        write("study.toml", std::string("case = \"case.toml\"\n") + key + " = \"design.csv\"\n" +
                                (key[0] == 's' ? "samples = 8\n" : ""));
    const auto study = read_or_refuse(
        [&] { return study::read_study(file, source / "materials", source / "standards").value(); });
    if (!study) continue;
    require(study::violations(*study).empty(), "a study that was read breaks no rule");
    const study::Design design(*study);
    std::vector<double> values(study->factors.size());
    for (const std::uint64_t row : {std::uint64_t{0}, design.rows() - 1}) {
      design.factors_of(row, values);
      require_finite(values, "the factors of a row are finite");
    }
    for (const study::RowLabel& label : study->labels)
      require(label.texts.size() == study::table_rows(*study), "a label has a text in each row");
  }
  return 0;
}
