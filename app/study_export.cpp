// dashpad study export: the rows of a store for other programs.

#include <cerrno>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include "dashpad/study/export_csv.hpp"
#include "output.hpp"
#include "streams.hpp"
#include "study.hpp"
#include "study_hdf5.hpp"

namespace dashpad {

namespace fs = std::filesystem;

namespace {

constexpr const char* footer = R"(Examples:
  dashpad study examples/studies/speed-and-thickness.toml --out rows.db
  dashpad study export rows.db --csv rows.csv
  dashpad study export rows.db --hdf5 rows.h5
  dashpad study export rows.db --csv - | head

All rows that are computed, by number: status, error, factors and responses, in SI; the CSV names the units in its
heading, the HDF5 in attributes. Values that an impact does not have are empty in the CSV and NaN in the HDF5.
Memory does not grow with the rows.

Files: - as the FILE of --csv is standard output. An existing file is kept unless --force is given. A file is
written whole or not at all.

Exit codes: 0 done, 1 a file could not be written, 2 refused and nothing was written.)";

struct Request {
  std::string store_file;
  std::optional<std::string> csv, hdf5;
  bool force = false;
};

std::vector<Target> targets(const Request& request) {
  std::vector<Target> wanted;
  if (request.csv) wanted.push_back({"--csv", *request.csv});
  if (request.hdf5) wanted.push_back({"--hdf5", *request.hdf5});
  return wanted;
}

/// A file too large for memory on its way to its name: written beside it by `write`, then named in one step.
void write_large(const Target& target, bool force, const std::function<void(const fs::path&)>& write) {
  const fs::path name{target.file};
  const fs::path draft = name.parent_path() / fmt::format(".dashpad-{}{}.part", ::getpid(), target.option);
  std::error_code error;
  try {
    write(draft);
    if (force)
      fs::rename(draft, name, error);
    else
      fs::create_hard_link(draft, name, error);
  } catch (...) {
    fs::remove(draft, error);
    throw;
  }
  const std::error_code failure = error;
  fs::remove(draft, error);
  if (failure)
    throw std::runtime_error(fmt::format("could not write {}: {}", target.file, failure.message()));
}

void write_csv(const study::Store& store, const fs::path& file, const std::string& shown) {
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
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
  if (::fsync(descriptor) != 0) problem = errno;
  if (::close(descriptor) != 0 && problem == 0) problem = errno;
  check();
}

int run_export(const Request& request) {
  const study::Store store = open_stored(request.store_file);
  std::vector<std::string> wrong = complaints(targets(request), request.store_file, request.force);
  if (targets(request).empty()) wrong.emplace_back("--csv or --hdf5: one of them is needed");
  if (request.hdf5 == "-") wrong.emplace_back("--hdf5 -: needs the name of a file");
  if (!wrong.empty()) throw Refused(std::move(wrong));
  for (const Target& target : targets(request)) {
    if (target.is_standard_output())
      study::export_csv(store, [](std::string_view text) { write_output(text); });
    else if (target.option == "--csv")
      write_large(target, request.force,
                  [&](const fs::path& draft) { write_csv(store, draft, target.file); });
    else
      write_large(target, request.force, [&](const fs::path& draft) { write_hdf5(store, draft); });
  }
  std::string line = fmt::format("{} rows", store.rows_done());
  if (store.rows_done() < store.rows()) line += fmt::format("; NOT COMPLETE: the study has {}", store.rows());
  (request.csv == "-" ? write_error : write_output)(line + "\n");
  return exit_done;
}

}  // namespace

void add_study_export(CLI::App& study, Action& action) {
  CLI::App* sub = study.add_subcommand("export", "Write the rows as CSV or HDF5");
  const auto request = std::make_shared<Request>();
  sub->add_option("FILE", request->store_file, "The store of a study")->required()->type_name("");
  sub->add_option("--csv", request->csv, "Write a CSV file (- for standard output)")->type_name("FILE");
  sub->add_option("--hdf5", request->hdf5, "Write an HDF5 file")->type_name("FILE");
  sub->add_flag("--force", request->force, "Overwrite existing files")->disable_flag_override();
  sub->footer(footer);
  sub->callback([request, &action] { action = [request] { return run_export(*request); }; });
}

}  // namespace dashpad
