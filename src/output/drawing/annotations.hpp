#pragma once
/// What is written around the pictures.

#include <string>
#include <vector>

#include "output/drawing/scene.hpp"

namespace dashpad::output {

/// The title: that of the case, or what strikes what.
std::string drawing_title(const ImpactCase& impact);
/// The whole drawing for who does not see it, and what in it is not to scale.
std::string drawing_description(const Scene& scene);

/// Heading, mass, speed and drop height above the left picture.
std::string text_above_left(const Scene& scene);
/// Heading, what is struck through and strain above the right one.
std::string text_above_right(const Scene& scene);

/// Thickness of each layer.
std::string dimensions_left(const Scene& scene);
/// Penetration and what is left, way of the support.
std::string dimensions_right(const Scene& scene);

/// The names of the layers on the pad of the left picture, if each layer has room for its name; else none.
std::string names_on_pad(const Scene& scene);

/// Nose, pad and support in words, for below the left picture.
std::vector<std::string> caption_lines(const Scene& scene);

/// Places from above to below, each at least its own distance below the one before, within [lowest, highest]
/// as far as they have room there, and otherwise near where they were wanted.
std::vector<double> kept_apart(std::vector<double> wanted, const std::vector<double>& distance, double lowest,
                               double highest);

}  // namespace dashpad::output
