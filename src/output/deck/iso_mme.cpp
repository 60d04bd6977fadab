// Curves as a test in ISO-MME.

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "dashpad/impact/solution.hpp"
#include "dashpad/injury/cfc_filter.hpp"
#include "dashpad/output/deck/exports.hpp"
#include "dashpad/output/deck/iso_mme_test.hpp"
#include "dashpad/version.hpp"

namespace dashpad::output {

namespace {

struct CurveChannel {
  const char* curve;
  const char* code;
  const char* name;
  const char* dimension;
};

constexpr CurveChannel channels[] = {
    {"acceleration", computed_acceleration_code, "Acceleration of the impactor", "Acceleration"},
    {"force", computed_force_code, "Force on the impactor", "Force"},
    {"velocity", "10HEAD000000VEX0", "Velocity of the impactor", "Velocity"},
    {"motion", "10HEAD000000DSX0", "Motion of the impactor", "Displacement"},
    {"penetration", "10PADS000000DSX0", "Penetration of the pad", "Displacement"},
};

const CurveChannel* channel_of(const std::string& curve) {
  const auto* const found =
      std::ranges::find_if(channels, [&](const CurveChannel& channel) { return curve == channel.curve; });
  return found == std::end(channels) ? nullptr : found;
}

IsoMmeHistory history_of(const Curve& curve, bool in_g) {
  const CurveChannel* channel = channel_of(curve.name);
  if (channel == nullptr) throw std::invalid_argument("ISO-MME: " + curve.name + " is not over time");
  IsoMmeHistory history{channel->code, channel->name, channel->dimension, curve.ordinate.si_unit,
                        injury::resampled({curve.x, curve.y}, iso_mme_interval).acceleration};
  if (in_g && curve.name == "acceleration") {
    history.unit = "g";
    for (double& value : history.values) value /= standard_gravity;
  }
  return history;
}

}  // namespace

bool is_over_time(const std::string& curve_name) { return channel_of(curve_name) != nullptr; }

std::string iso_mme_zip(const CurveFile& file) {
  IsoMmeTest test;
  test.title = file.title;
  test.laboratory = "computed";
  test.comment = fmt::format("dashpad {}", version());
  for (const std::string& line : file.origin) test.comment += "; " + line;
  for (const std::string& flag : file.flags) test.comment += "; " + flag;
  test.sampling_interval = iso_mme_interval;
  for (const FileCurve& of : file.curves)
    test.histories.push_back(history_of(of.curve, file.acceleration_in_g));
  return zip_of(iso_mme_files(test));
}

}  // namespace dashpad::output
