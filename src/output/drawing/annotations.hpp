#pragma once
/// What is written around the pictures.

#include <string>
#include <vector>

#include "output/drawing/scene.hpp"

namespace dashpad::output {

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

}  // namespace dashpad::output
