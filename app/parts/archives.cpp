// Zip and tar: a part that is loaded when it is used.

#include "dashpad/output/deck/iso_mme_test.hpp"
#include "input/iso_mme/test_files.hpp"
#include "parts/parts.hpp"

extern "C" const dashpad::app::ArchivePart* dashpad_part() {
  static constexpr dashpad::app::ArchivePart part{dashpad::input::names_in_archive,
                                                  dashpad::input::read_from_archive, dashpad::output::zip_of};
  return &part;
}
