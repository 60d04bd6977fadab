#pragma once
/// Nose, pad and support of one of the two pictures, without what is written beside them.

#include <string>

#include "output/drawing/scene.hpp"

namespace dashpad::output {

/// The `<clipPath>` of a picture, ragged where what is drawn goes on.
std::string picture_clip(const Scene& scene, const Picture& picture);

std::string picture_of(const Scene& scene, const Picture& picture);

}  // namespace dashpad::output
