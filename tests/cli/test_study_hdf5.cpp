// dashpad study export --hdf5: what the HDF5 library reads is what the store has.

#include <cmath>
#include <cstdint>

#include <hdf5.h>

#include "command.hpp"
#include "dashpad/study/store.hpp"

namespace dashpad::test {
namespace {

using study::Store;

class StudyHdf5 : public CommandTest {
 protected:
  void SetUp() override {
    CommandTest::SetUp();
    write_file(file("study.toml"), R"(title = "Speeds"
case = "case.toml"
responses = ["peak_force", "rebound_speed"]
[factors."impactor.speed"]
from = "1 m/s"
to = "4 m/s"
count = 100
)");
    const Outcome made = dashpad({"study", file("study.toml"), "--out", file("s.db"), "--quiet"});
    ASSERT_TRUE(made.exit_code == 0 || made.exit_code == 3) << made.err;
  }
  [[nodiscard]] Outcome export_to(const std::string& name) const {
    return dashpad({"study", "export", file("s.db"), "--hdf5", file(name)});
  }
};

std::vector<double> values_of(hid_t file, const char* name) {
  const hid_t set = H5Dopen2(file, name, H5P_DEFAULT);
  if (set < 0) throw std::runtime_error(std::string{"no "} + name);
  const hid_t space = H5Dget_space(set);
  std::vector<double> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
  H5Dread(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
  H5Sclose(space);
  H5Dclose(set);
  return values;
}

std::string attribute_of(hid_t file, const char* object, const char* name) {
  const hid_t attribute = H5Aopen_by_name(file, object, name, H5P_DEFAULT, H5P_DEFAULT);
  if (attribute < 0) throw std::runtime_error(std::string{"no "} + name);
  const hid_t type = H5Aget_type(attribute);
  std::string text(H5Tget_size(type), '\0');
  H5Aread(attribute, type, text.data());
  H5Tclose(type);
  H5Aclose(attribute);
  return text;
}

TEST_F(StudyHdf5, has_every_column_with_its_unit) {
  ASSERT_EQ(export_to("s.h5").exit_code, 0);
  const Store store = Store::open_to_read(file("s.db"));
  const hid_t h5 = H5Fopen(file("s.h5").c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  ASSERT_GE(h5, 0);
  EXPECT_EQ(values_of(h5, "/factors/impactor.speed_m_per_s"), store.column("impactor.speed"));
  EXPECT_EQ(values_of(h5, "/responses/peak_force_N"), store.column("peak_force"));
  EXPECT_EQ(values_of(h5, "/rows/row"), store.column("row"));
  EXPECT_EQ(values_of(h5, "/rows/error"), store.column("error"));
  EXPECT_EQ(values_of(h5, "/rows/status").at(0), static_cast<double>(Status::released));
  EXPECT_EQ(attribute_of(h5, "/factors/impactor.speed_m_per_s", "unit"), "m/s");
  EXPECT_EQ(attribute_of(h5, "/responses/peak_force_N", "unit"), "N");
  EXPECT_FALSE(attribute_of(h5, "/responses/peak_force_N", "meaning").empty());
  EXPECT_NE(attribute_of(h5, "/", "status_names").find("1 released"), std::string::npos);
  EXPECT_NE(attribute_of(h5, "/", "program").find(store.program()), std::string::npos);
  H5Fclose(h5);
}

TEST_F(StudyHdf5, is_not_left_half_written_on_a_full_disk) {
  const Outcome full = shell("ulimit -f 4; exec \"$DASHPAD\" study export '" + file("s.db") + "' --hdf5 '" +
                             file("s.h5") + "'");
  EXPECT_EQ(full.exit_code, 1);
  EXPECT_NE(full.err.find("could not write to the disk"), std::string::npos) << full.err;
  for (const std::string& name : other_files()) EXPECT_EQ(name.find("h5"), std::string::npos) << name;
}

}  // namespace
}  // namespace dashpad::test
