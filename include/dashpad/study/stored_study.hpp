#pragma once
/// A study out of its store alone: the cards, data files and the base case that its file names need not be
/// there any more.

#include "dashpad/study/store.hpp"
#include "dashpad/study/study.hpp"

namespace dashpad::study {

/// The study whose rows the store holds, to the last bit. Throws DamagedStore where the store does not
/// tell.
Study stored_study(const Store& store);

}  // namespace dashpad::study
