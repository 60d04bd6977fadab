#pragma once
/// A study out of its file (TOML with units, docs/studies.md), and out of its store alone: the cards, data
/// files and the base case that its file names need not be there any more.

#include <filesystem>
#include <string>

#include "dashpad/input/fault.hpp"
#include "dashpad/input/reading.hpp"
#include "dashpad/study/store.hpp"
#include "dashpad/study/study.hpp"

namespace dashpad::study {

/// Reads a study, its base case, the cards and the CSV files that it names, relative to the study file.
/// All faults at once: of the study, of the case, of the factors.
input::Reading<Study> read_study(const std::filesystem::path& file, const std::filesystem::path& materials);

/// JSON in SI. Two studies with the same text here have the same rows.
std::string resolved_text(const Study& study);

/// The study whose rows the store holds, to the last bit. Throws DamagedStore where the store does not
/// tell.
Study stored_study(const Store& store);

}  // namespace dashpad::study
