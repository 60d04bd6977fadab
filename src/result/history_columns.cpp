#include "result/history_columns.hpp"

#include <array>

namespace dashpad {

std::span<const HistoryColumn> history_columns() {
  static constexpr std::array all{HistoryColumn{"time", &History::time},
                                  HistoryColumn{"force", &History::force},
                                  HistoryColumn{"acceleration", &History::acceleration},
                                  HistoryColumn{"velocity", &History::velocity},
                                  HistoryColumn{"motion", &History::motion},
                                  HistoryColumn{"penetration", &History::penetration},
                                  HistoryColumn{"support_deflection", &History::support_deflection},
                                  HistoryColumn{"contact_radius", &History::contact_radius},
                                  HistoryColumn{"axis_strain", &History::axis_strain},
                                  HistoryColumn{"pad_force", &History::pad_force, true},
                                  HistoryColumn{"transmitted_force", &History::transmitted_force, true},
                                  HistoryColumn{"body_motion", &History::body_motion, true}};
  return all;
}

}  // namespace dashpad
