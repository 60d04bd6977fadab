#pragma once
/// Reading a study from its file (TOML with units, docs/studies.md), and from its store alone.

#include <filesystem>
#include <string>

#include "dashpad/input/fault.hpp"
#include "dashpad/input/reading.hpp"
#include "dashpad/study/store.hpp"
#include "dashpad/study/study.hpp"

namespace dashpad::study {

/// Reads a study file and the files that it names, relative to it. `materials` and `standards` are the
/// folders of cards and presets. Reports all faults at once.
input::Reading<Study> read_study(const std::filesystem::path& file, const std::filesystem::path& materials,
                                 const std::filesystem::path& standards);

/// JSON in SI. Two studies with the same text here have the same rows.
std::string resolved_text(const Study& study);

/// The study of a store, exact to the last bit. Throws DamagedStore if the store does not hold it.
Study stored_study(const Store& store);

/// The labels of its table of rows alone, also of a store whose study another version cannot read. Throws
/// DamagedStore if they do not go with its rows.
std::vector<RowLabel> row_labels(const Store& store);

/// The standards that its study names, also of a store whose study another version cannot read. Throws
/// DamagedStore.
std::vector<std::string> stored_standards(const Store& store);

}  // namespace dashpad::study
