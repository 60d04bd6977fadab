/// dashpad export --format iso-mme: a zip that Python's zipfile reads, with a test whose figures are those of
/// the run.

#include <cmath>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "command.hpp"

namespace dashpad::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

using IsoMmeExport = CommandTest;

/// Reads a channel with nothing of ours: names after ":", then a sample a line.
constexpr const char* reader = R"PY(
import json, sys, zipfile
archive = zipfile.ZipFile(sys.argv[1])
assert archive.testzip() is None
channels = {}
for name in archive.namelist():
    if not name[-3:].isdigit(): continue
    labels, values = {}, []
    for line in archive.read(name).decode().splitlines():
        if ':' in line and not values:
            label, _, value = line.partition(':')
            labels[label.strip()] = value.strip()
        else:
            values.append(float(line))
    assert int(labels['Number of samples']) == len(values)
    channels[labels['Channel code']] = {'unit': labels['Unit'], 'interval': float(labels['Sampling interval']), 'peak': max(map(abs, values)), 'samples': len(values)}
print(json.dumps({'names': sorted(archive.namelist()), 'channels': channels}))
)PY";

TEST_F(IsoMmeExport, IsReadBackByAnotherProgram) {
  const Outcome run = dashpad({"run", case_file(), "--json", "-"});
  const Outcome exported = dashpad(
      {"export", case_file(), "--format", "iso-mme", "--out", file("test.zip"), "--acceleration-in-g"});
  ASSERT_EQ(exported.exit_code, 0) << exported.err;
  write_file(file("read.py"), reader);
  const Outcome read = shell("python3 '" + file("read.py") + "' '" + file("test.zip") + "'");
  ASSERT_EQ(read.exit_code, 0) << read.err;
  const json result = json::parse(run.out), archive = json::parse(read.out);
  EXPECT_EQ(archive["names"].size(), 7U);
  const json acceleration = archive["channels"]["10HEAD000000ACX0"];
  EXPECT_EQ(acceleration["unit"], "g");
  EXPECT_EQ(acceleration["interval"], 1e-5);
  EXPECT_NEAR(double(acceleration["peak"]) / double(result["peak_acceleration_g"]), 1, 1e-3);
  EXPECT_NEAR(double(archive["channels"]["10HEAD000000FOX0"]["peak"]) / double(result["peak_force_N"]), 1,
              1e-3);
}

TEST_F(IsoMmeExport, HasTheFiguresOfTheRunInDashpadPulse) {
  const json run = json::parse(dashpad({"run", case_file(), "--json", "-"}).out)["injury"];
  ASSERT_EQ(dashpad({"export", case_file(), "--format", "iso-mme", "--out", file("test.zip")}).exit_code, 0);
  const Outcome pulse = dashpad({"pulse", file("test.zip"), "--channel", "10HEAD000000ACX0", "--json", "-"});
  ASSERT_EQ(pulse.exit_code, 0) << pulse.err;
  const json figures = json::parse(pulse.out)["figures"];
  EXPECT_NEAR(double(figures["hic36"]["value"]) / double(run["hic36"]["value"]), 1, 1e-3);
  EXPECT_NEAR(double(figures["clip_3ms"]["value_g"]) / double(run["clip_3ms"]["value_g"]), 1, 1e-3);
}

TEST_F(IsoMmeExport, TheSameCaseGivesTheSameBytes) {
  for (const char* name : {"a.zip", "b.zip"})
    ASSERT_EQ(dashpad({"export", case_file(), "--format", "iso-mme", "--out", file(name)}).exit_code, 0);
  EXPECT_EQ(read_file(file("a.zip")), read_file(file("b.zip")));
}

TEST_F(IsoMmeExport, RefusesBranchesOverPenetrationAndUnits) {
  const Outcome branch = dashpad({"export", case_file(), "--format", "iso-mme", "--out", file("test.zip"),
                                  "--curves", "loading", "--system", "t-mm-s"});
  EXPECT_EQ(branch.exit_code, 2);
  EXPECT_THAT(branch.err, HasSubstr("loading: iso-mme accepts only curves over time"));
  EXPECT_THAT(branch.err, HasSubstr("--system t-mm-s"));
  EXPECT_FALSE(fs::exists(file("test.zip")));
}

}  // namespace
}  // namespace dashpad::test
