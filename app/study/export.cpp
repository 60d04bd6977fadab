// dashpad study export: the rows of a store for other programs.

#include <cerrno>
#include <filesystem>
#include <stdexcept>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include "dashpad/study/store.hpp"
#include "output_files.hpp"
#include "parts/parts.hpp"
#include "study/study.hpp"

namespace dashpad::app {

namespace fs = std::filesystem;

namespace {

constexpr const char* study_export_footer = R"(Examples:
  dashpad study examples/studies/speed-and-thickness.toml --out rows.db
  dashpad study export rows.db --csv rows.csv
  dashpad study export rows.db --hdf5 rows.h5
  dashpad study export rows.db --csv - | head

Writes all computed rows in order of row number: status, error, factors and responses, in SI units with accelerations
in g; the column names include the units. Values that an impact does not have are empty in CSV and NaN in HDF5. Memory
use does not depend on the number of rows.

Files: - as FILE of --csv means standard output. An existing file is not overwritten unless --force is given. A file
is written completely or not at all.

Exit codes: 0 success, 1 a file could not be written, 2 invalid input (nothing was written).)";

struct StudyExportRequest {
  std::string store_file;
  OutputFiles files;
};

void write_csv(const study::Store& store, const fs::path& file, const std::string& shown) {
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_TRUNC | O_CLOEXEC);
  int problem = descriptor < 0 ? errno : 0;
  const auto check = [&] {
    if (problem != 0)
      throw std::runtime_error(
          fmt::format("could not write {}: {}", shown, std::generic_category().message(problem)));
  };
  check();
  try {
    study::export_csv(store, [&](std::string_view text) {
      problem = write_all(descriptor, text);
      check();
    });
  } catch (...) {
    ::close(descriptor);
    throw;
  }
  if (::close(descriptor) != 0) problem = errno;
  check();
}

/// Writes the files, then standard output.
void write_files(const study::Store& store, const StudyExportRequest& request) {
  std::vector<PendingFile> files;
  for (const Target& target : request.files.targets()) {
    if (target.is_standard_output()) continue;
    const bool is_csv = target.option == "--csv";
    files.emplace_back(
        target,
        [&store, is_csv, shown = target.file](const fs::path& file) {
          (is_csv ? write_csv : write_hdf5)(store, file, shown);
        },
        request.files.force);
  }
  for (PendingFile& file : files) file.publish();
  if (request.files.of("--csv") == "-")
    study::export_csv(store, [](std::string_view text) { write_result(text); });
}

int run_export(const StudyExportRequest& request) {
  const study::Store store = open_stored(request.store_file);
  std::vector<std::string> errors;
  judge_files(request.files, files_of_store(request.store_file), errors);
  if (request.files.targets().empty()) errors.emplace_back("--csv or --hdf5: at least one is required");
  if (const std::string& file = request.files.of("--hdf5"); file == "-" || is_device(file))
    errors.push_back(fmt::format("--hdf5 {}: needs the name of a file", file));
  if (!errors.empty()) throw Refused(std::move(errors));
  write_files(store, request);
  std::string line = fmt::format("{} rows", store.rows_done());
  if (store.rows_done() < store.rows()) line += fmt::format("; NOT COMPLETE: the study has {}", store.rows());
  (request.files.of("--csv") == "-" ? write_error : write_output)(line + "\n");
  return exit_done;
}

}  // namespace

void add_study_export(CLI::App& study, Action& action) {
  const auto [sub, request] = add_subcommand<StudyExportRequest>(
      study, action, "export", "Write the rows as CSV or HDF5", study_export_footer, run_export);
  add_option(sub, "FILE", request.store_file, "The store of a study")->required();
  add_file(sub, request.files, "--csv", "Write a CSV file (- for standard output)");
  add_file(sub, request.files, "--hdf5", "Write an HDF5 file");
  add_force(sub, request.files.force);
}

}  // namespace dashpad::app
