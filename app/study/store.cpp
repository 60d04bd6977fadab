// The store of a study, as the subcommands open and close it.

#include <system_error>

#include <fmt/format.h>

#include "dashpad/study/answers.hpp"
#include "streams.hpp"
#include "study/progress.hpp"
#include "study/stop_signal.hpp"
#include "study/study.hpp"

namespace dashpad::app {

namespace {

template <class Open>
study::Store opened(const std::string& file, Open open) {
  try {
    return open();
  } catch (const std::runtime_error& error) {
    const std::string what = error.what();
    throw Refused({what.find(file) == std::string::npos ? fmt::format("{}: {}", file, what) : what});
  }
}

}  // namespace

study::Store open_store(const study::Study& study, const std::string& file) {
  return opened(file, [&] { return study::Store::open_for(study, file); });
}

study::Store open_stored(const std::string& file) {
  return opened(file, [&] { return study::Store::open_to_read(file); });
}

std::vector<input::InputFile> files_of_store(const std::string& file) {
  std::vector<input::InputFile> files{{"the store", file}};
  std::error_code error;
  const std::string real = std::filesystem::weakly_canonical(file, error).string();
  for (const char* ending : {"-wal", "-shm", "-journal"})
    files.push_back({"a part of the store", (error ? file : real) + ending});
  return files;
}

int finish_study(const study::Store& store, const StudyRequest& request, std::uint64_t rows_before,
                 double seconds, bool complete) {
  store.check_in_place();
  const std::uint64_t rows = store.rows_done();
  const auto computed = static_cast<double>(rows - rows_before);
  if (!complete) {
    write_error(fmt::format("Stopped with {} rows in {}. The same command goes on where this one stopped.\n",
                            rows, request.store_file));
    return StopSignal::exit_code();
  }
  const auto [doubtful, struck_through] = study::row_counts(store);
  std::string line = fmt::format("{} rows in {}", rows, request.store_file);
  line += rows == rows_before ? "; they were all there"
                              : fmt::format("; {} computed in {:.3g} s, {}", rows - rows_before, seconds,
                                            rate_text(computed, seconds));
  line += fmt::format("; {} doubtful{}", doubtful,
                      doubtful > 0 ? " (tolerance not met, no valid case, or a figure missing)" : "");
  if (struck_through > 0) line += fmt::format("; {} bottomed out on a rigid support", struck_through);
  line += "\n";
  write_output(line);
  return doubtful > 0 ? exit_not_trusted : exit_done;
}

}  // namespace dashpad::app
