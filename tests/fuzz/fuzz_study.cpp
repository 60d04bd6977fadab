// Study files, beside the cases of the examples and a file of measured values.

#include <cstdint>

#include "dashpad/study/study.hpp"
#include "dashpad/study/study_file.hpp"
#include "reading.hpp"

namespace fs = std::filesystem;
using namespace dashpad;
using namespace dashpad::fuzz;

namespace {

const fs::path source = DASHPAD_SOURCE_DIR;

/// Where the study files of the examples find what they name.
bool lay_out() {
  fs::create_directories(folder() / "studies");
  for (const fs::directory_entry& entry : fs::directory_iterator(source / "examples"))
    if (entry.is_regular_file()) fs::copy_file(entry, folder() / entry.path().filename());
  fs::copy(source / "examples/studies/cases", folder() / "studies/cases");
  write("studies/measured.csv", "sample;speed [mph]\n1;19,5\n2;20,5\n3;20,0\n");
  return true;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  static const bool laid_out = lay_out();
  require(laid_out, "the files that studies name are there");
  const fs::path file = write("studies/study.toml", text_of(bytes, size));
  const auto study = read_or_refuse(
      [&] { return study::read_study(file, source / "materials", source / "standards").value(); });
  if (!study) return 0;
  require(study::violations(*study).empty(), "a study that was read breaks no rule");
  const study::Design design(*study);
  require(design.rows() >= 1 && design.rows() <= study::max_rows, "a study has rows, and not too many");
  std::vector<double> values(study->factors.size());
  for (const std::uint64_t row : {std::uint64_t{0}, design.rows() / 2, design.rows() - 1}) {
    design.factors_of(row, values);
    require_finite(values, "the factors of a row are finite");
  }
  return 0;
}
