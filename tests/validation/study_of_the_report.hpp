#pragma once
/// The study on the report's 33 tests. It takes a minute on two cores: the tests of it run in one process
/// (tests/CMakeLists.txt, validation.study), and share it.

#include "dashpad/input/case_file.hpp"
#include "dashpad/report1986/validation/study.hpp"
#include "shared/samples.hpp"

namespace dashpad::test {

inline const report1986::Study& study_of_the_report() {
  static const report1986::Study study = [] {
    std::vector<input::Fault> faults;
    const auto data = report1986::read_validation_data(source_folder / "data/validation", faults);
    EXPECT_TRUE(faults.empty());
    return run_study(data, input::read_material(material_folder / "ensolite-aac-9.toml").value());
  }();
  return study;
}

}  // namespace dashpad::test
