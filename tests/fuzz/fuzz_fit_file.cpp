// Fit files, beside a test, a pulse and a case.

#include <cstdint>

#include "dashpad/fit/fit.hpp"
#include "reading.hpp"

namespace fs = std::filesystem;
using namespace dashpad;
using namespace dashpad::fuzz;

namespace {

const fs::path source = DASHPAD_SOURCE_DIR;

bool lay_out() {
  write("test.csv", "strain,stress_kPa,time_s\n0.1,10,1\n0.3,40,2\n0.5,120,3\n0.3,20,4\n0.1,2,5\n");
  write("drop.csv", "time_ms,acceleration_g\n0,0\n1,0\n2,10\n3,25\n4,30\n5,22\n6,9\n7,0\n8,0\n");
  fs::copy_file(source / "examples/helmet-pad-10fps.toml", folder() / "case.toml");
  return true;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  static const bool laid_out = lay_out();
  require(laid_out, "the files that fits name are there");
  const fs::path file = write("fit.toml", text_of(bytes, size));
  const auto read = read_or_refuse([&] { return fit::read_fit(file, source / "materials").value(); });
  if (read) require(fit::violations(read->fit).empty(), "a fit that was read breaks no rule");
  return 0;
}
