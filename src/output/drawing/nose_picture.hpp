#pragma once
/// The outline of the nose, to scale.

#include <string>
#include <vector>

#include "dashpad/model/nose/nose.hpp"
#include "output/drawing/elements.hpp"

namespace dashpad::output {

/// Where the right half of a nose is drawn.
struct NoseFrame {
  double axis = 0;         ///< x, px
  double tip = 0;          ///< y, px
  double scale = 0;        ///< px/m
  double half_width = 0;   ///< of the picture, px; the nose may reach somewhat beyond
  double height = 0;       ///< of the picture above the tip, px; likewise
  bool is_buried = false;  ///< deeper than its widest section: its side goes on, as in the model
};

/// Depths behind the tip at which the outline has its corners, m, increasing from 0: as many as a smooth
/// curve of this size needs, up to the widest section or as far as the picture shows.
std::vector<double> outline_depths(const Sections& outline, const NoseFrame& frame);

/// The nose as one closed path.
std::string nose_picture(const Nose& nose, const NoseFrame& frame, std::string_view style);

}  // namespace dashpad::output
