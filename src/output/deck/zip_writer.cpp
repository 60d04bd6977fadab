#include <memory>
#include <stdexcept>

#include <archive.h>
#include <archive_entry.h>

#include "dashpad/output/deck/iso_mme_test.hpp"

namespace dashpad::output {

namespace {

using ZipArchive = std::unique_ptr<archive, decltype(&archive_write_free)>;
using Entry = std::unique_ptr<archive_entry, decltype(&archive_entry_free)>;

la_ssize_t append(archive*, void* bytes, const void* buffer, std::size_t size) {
  static_cast<std::string*>(bytes)->append(static_cast<const char*>(buffer), size);
  return static_cast<la_ssize_t>(size);
}

void require(const ZipArchive& zip, int result) {
  if (result == ARCHIVE_OK) return;
  const char* reason = archive_error_string(zip.get());
  throw std::runtime_error(std::string{"zip: "} + (reason == nullptr ? "unknown error" : reason));
}

}  // namespace

std::string zip_of(const std::map<std::string, std::string>& files) {
  std::string bytes;
  const ZipArchive zip(archive_write_new(), archive_write_free);
  require(zip, archive_write_set_format_zip(zip.get()));
  require(zip, archive_write_set_bytes_in_last_block(zip.get(), 1));  // no padding
  require(zip, archive_write_open(zip.get(), &bytes, nullptr, append, nullptr));
  for (const auto& [name, text] : files) {
    const Entry entry(archive_entry_new(), archive_entry_free);
    archive_entry_set_pathname(entry.get(), name.c_str());
    archive_entry_set_size(entry.get(), static_cast<la_int64_t>(text.size()));
    archive_entry_set_filetype(entry.get(), AE_IFREG);
    archive_entry_set_perm(entry.get(), 0644);
    archive_entry_set_mtime(entry.get(), 315'532'800, 0);  // 1980, the earliest year in a zip
    require(zip, archive_write_header(zip.get(), entry.get()));
    if (archive_write_data(zip.get(), text.data(), text.size()) != static_cast<la_ssize_t>(text.size()))
      require(zip, ARCHIVE_FATAL);
  }
  require(zip, archive_write_close(zip.get()));
  return bytes;
}

}  // namespace dashpad::output
