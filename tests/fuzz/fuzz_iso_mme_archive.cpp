// Tests in ISO-MME in an archive: zip, tar or gzipped tar.

#include <cstdint>

#include "dashpad/input/iso_mme/iso_mme.hpp"
#include "iso_mme_test.hpp"
#include "reading.hpp"

using namespace dashpad;
using namespace dashpad::fuzz;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const auto file = write("test.archive", text_of(bytes, size));
  if (input::is_iso_mme(file)) read_iso_mme_test(file);
  return 0;
}
