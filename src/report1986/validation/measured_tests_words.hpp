#pragma once
/// The words of the data files.

#include "dashpad/report1986/validation/measured_tests.hpp"
#include "report1986/validation/measured_tests_csv.hpp"

namespace dashpad::report1986 {

inline Projectile read_projectile(CsvTable& table, const CsvRecord& record) {
  return table.choice(record, "projectile", {"aluminium", "steel"}) == 1 ? Projectile::steel
                                                                         : Projectile::aluminium;
}

inline TestSupport read_support(CsvTable& table, const CsvRecord& record) {
  return table.choice(record, "support", {"load-cell", "plate"}) == 1 ? TestSupport::plate
                                                                      : TestSupport::load_cell;
}

}  // namespace dashpad::report1986
