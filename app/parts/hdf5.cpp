// HDF5 of a store, through the C interface: a part that is loaded when it is used.

#include "parts/parts.hpp"

#include <algorithm>
#include <stdexcept>
#include <system_error>
#include <utility>

#include <hdf5.h>

namespace dashpad::app {

namespace {

constexpr hsize_t rows_a_chunk = 16384;

/// Owns an identifier of HDF5; throws if it is invalid.
class Handle {
 public:
  using Close = herr_t (*)(hid_t);
  Handle(hid_t id, Close closed_by) : id_(id), close_(closed_by) {
    if (id < 0) throw std::runtime_error("HDF5 reported an error");
  }
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  Handle& operator=(Handle&&) = delete;
  [[nodiscard]] hid_t get() const { return id_; }
  /// Closes now, so that a failure is noticed.
  void close() { check(close_(std::exchange(id_, -1))); }
  static void check(herr_t result) {
    if (result < 0) throw std::runtime_error("HDF5 could not write to the disk");
  }

 private:
  hid_t id_;
  Close close_;
};

void write_attribute(const Handle& owner, const char* name, const std::string& text) {
  const Handle type{H5Tcopy(H5T_C_S1), H5Tclose};
  Handle::check(H5Tset_size(type.get(), text.empty() ? 1 : text.size()));
  Handle::check(H5Tset_cset(type.get(), H5T_CSET_UTF8));
  Handle::check(H5Tset_strpad(type.get(), H5T_STR_NULLPAD));
  const Handle space{H5Screate(H5S_SCALAR), H5Sclose};
  const Handle attribute{H5Acreate2(owner.get(), name, type.get(), space.get(), H5P_DEFAULT, H5P_DEFAULT),
                         H5Aclose};
  Handle::check(H5Awrite(attribute.get(), type.get(), text.c_str()));
}

/// A data set that grows by chunks.
class Column {
 public:
  Column(const Handle& group, const study::StoredColumn& stored_column, hid_t type, hsize_t rows)
      : exported_(study::exported(stored_column)), set_(make(group, exported_.name, type, rows)) {
    write_attribute(set_, "unit", exported_.unit);
    write_attribute(set_, "meaning", stored_column.meaning);
    values_.reserve(rows_a_chunk);
  }
  void add(double value) {
    values_.push_back(exported_.scale * value);
    if (values_.size() == rows_a_chunk) flush();
  }
  void flush() {
    const hsize_t count = values_.size();
    if (count == 0) return;
    const Handle memory{H5Screate_simple(1, &count, nullptr), H5Sclose};
    const Handle place{H5Dget_space(set_.get()), H5Sclose};
    Handle::check(H5Sselect_hyperslab(place.get(), H5S_SELECT_SET, &written_, nullptr, &count, nullptr));
    Handle::check(
        H5Dwrite(set_.get(), H5T_NATIVE_DOUBLE, memory.get(), place.get(), H5P_DEFAULT, values_.data()));
    written_ += count;
    values_.clear();
  }

 private:
  static Handle make(const Handle& group, const std::string& name, hid_t type, hsize_t rows) {
    const Handle space{H5Screate_simple(1, &rows, nullptr), H5Sclose};
    const Handle properties{H5Pcreate(H5P_DATASET_CREATE), H5Pclose};
    if (rows > 0) {
      const hsize_t chunk = std::min(rows_a_chunk, rows);
      Handle::check(H5Pset_chunk(properties.get(), 1, &chunk));
      Handle::check(H5Pset_shuffle(properties.get()));
      if (H5Zfilter_avail(H5Z_FILTER_DEFLATE) > 0) Handle::check(H5Pset_deflate(properties.get(), 4));
    }
    return {
        H5Dcreate2(group.get(), name.c_str(), type, space.get(), H5P_DEFAULT, properties.get(), H5P_DEFAULT),
        H5Dclose};
  }

  study::ExportedColumn exported_;
  Handle set_;
  std::vector<double> values_;
  hsize_t written_ = 0;
};

Handle group(const Handle& file, const char* name) {
  return {H5Gcreate2(file.get(), name, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose};
}

class Columns {
 public:
  Columns(const Handle& file, const study::Store& store) {
    const hsize_t rows = store.rows_done();
    const Handle about = group(file, "rows"), factors = group(file, "factors"),
                 responses = group(file, "responses");
    const auto add = [&](const char* name, const char* meaning, hid_t type) {
      columns_.emplace_back(about, study::StoredColumn{name, "", meaning}, type, rows);
    };
    add("row", "row number", H5T_STD_I64LE);
    add("status", "outcome; the names are in status_names", H5T_STD_U8LE);
    add("extrapolated", "beyond the range of the fit: 0 or 1", H5T_STD_U8LE);
    add("extrapolated_strain", "extrapolated in strain, where the stress is a guess: 0 or 1", H5T_STD_U8LE);
    add("extrapolated_rate", "extrapolated in rate, where the stress rests on the law alone: 0 or 1",
        H5T_STD_U8LE);
    add("bottomed", "pad fully compressed: 0 or 1", H5T_STD_U8LE);
    add("error", "largest relative error estimate", H5T_IEEE_F64LE);
    for (const auto& column : store.factors()) columns_.emplace_back(factors, column, H5T_IEEE_F64LE, rows);
    for (const auto& column : store.responses())
      columns_.emplace_back(responses, column, H5T_IEEE_F64LE, rows);
  }
  void add(const study::StoredRow& row) {
    std::size_t place = 0;
    const study::Outcome& outcome = row.outcome;
    for (const double value : {static_cast<double>(row.row), static_cast<double>(outcome.status),
                               outcome.extrapolated != 0 ? 1.0 : 0.0,
                               (outcome.extrapolated & study::extrapolated_strain) != 0 ? 1.0 : 0.0,
                               (outcome.extrapolated & study::extrapolated_rate) != 0 ? 1.0 : 0.0,
                               outcome.bottomed ? 1.0 : 0.0, outcome.error})
      columns_[place++].add(value);
    for (const auto* values : {&row.factors, &outcome.values})
      for (const double value : *values) columns_[place++].add(value);
  }
  void flush() {
    for (Column& column : columns_) column.flush();
  }

 private:
  std::vector<Column> columns_;
};

std::string status_names() {
  std::string names;
  for (const Status status : study::all_statuses)
    names += (names.empty() ? "" : ", ") + std::to_string(static_cast<int>(status)) + " " + to_string(status);
  return names;
}

void write_columns(const study::Store& store, const std::string& name) {
  Handle file{H5Fcreate(name.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose};
  write_attribute(file, "program", "dashpad " + store.program());
  write_attribute(file, "status_names", status_names());
  {
    const Handle study = group(file, "study");
    // The text is no attribute, since those are limited to 64 KiB.
    const Handle type{H5Tcopy(H5T_C_S1), H5Tclose};
    const std::string text = store.study_text();
    Handle::check(H5Tset_size(type.get(), std::max<std::size_t>(text.size(), 1)));
    const Handle space{H5Screate(H5S_SCALAR), H5Sclose};
    const Handle set{
        H5Dcreate2(study.get(), "text", type.get(), space.get(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
        H5Dclose};
    Handle::check(H5Dwrite(set.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, text.c_str()));
    Columns columns{file, store};
    store.visit_rows([&](const study::StoredRow& row) { columns.add(row); });
    columns.flush();
  }
  Handle::check(H5Fflush(file.get(), H5F_SCOPE_GLOBAL));
  file.close();
}

}  // namespace

void write_hdf5(const study::Store& store, const std::filesystem::path& file, const std::string& shown) {
  // After a write error HDF5 would try again at exit, and crash.
  H5dont_atexit();
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // our message, not HDF5's stack of calls
  try {
    write_columns(store, file.string());
  } catch (const std::runtime_error& error) {
    std::error_code ignored;
    std::filesystem::remove(file, ignored);
    throw std::runtime_error("could not write " + shown + ": " + error.what());
  }
}

}  // namespace dashpad::app

extern "C" const dashpad::app::Hdf5Part* dashpad_part() {
  static constexpr dashpad::app::Hdf5Part part{dashpad::app::write_hdf5};
  return &part;
}
