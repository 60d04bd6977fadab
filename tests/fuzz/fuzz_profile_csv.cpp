// Profiles of noses.

#include <cmath>
#include <cstdint>

#include <fmt/format.h>

#include "input/case_tables.hpp"
#include "reading.hpp"

using namespace dashpad;
using namespace dashpad::fuzz;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const auto profile = read_or_refuse(
      [&] { return input::read_profile_csv(write("profile.csv", text_of(bytes, size))).value(); });
  if (!profile) return 0;
  require(profile->faults().empty(), "a profile that is read keeps its rules");

  std::string written = profile->of == Profile::Of::radius ? "depth_m,radius_m\n" : "depth_m,area_m2\n";
  for (const Profile::Point& point : profile->points)
    written += fmt::format("{},{}\n", point.depth, point.size);
  const Profile again = input::read_profile_csv(write("again.csv", written)).value();
  require(again.of == profile->of && again.points == profile->points, "what is written is read as the same");
  return 0;
}
