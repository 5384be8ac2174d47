#include "hexoderm/base/zip.h"

#include "hexoderm/base/error.h"

#include <zip.h>
#include <memory>

namespace hexoderm {
namespace {

class ZipFault {
 public:
  ZipFault() { zip_error_init(&error_); }
  ~ZipFault() { zip_error_fini(&error_); }
  ZipFault(const ZipFault&) = delete;
  ZipFault& operator=(const ZipFault&) = delete;
  [[nodiscard]] zip_error_t* get() { return &error_; }
  [[nodiscard]] std::string words() { return zip_error_strerror(&error_); }

 private:
  zip_error_t error_{};
};

struct ZipSourceFree {
  void operator()(zip_source_t* source) const { zip_source_free(source); }
};
struct ZipDiscard {
  void operator()(zip_t* archive) const { zip_discard(archive); }
};
using ZipSource = std::unique_ptr<zip_source_t, ZipSourceFree>;
using ZipArchive = std::unique_ptr<zip_t, ZipDiscard>;

[[noreturn]] void failToZip(const std::string& why) {
  throw StorageError(message("The zip archive could not be made: {}", why));
}

std::string bytesOf(zip_source_t* source) {
  zip_stat_t stat;
  zip_stat_init(&stat);
  if (zip_source_stat(source, &stat) != 0 || (stat.valid & ZIP_STAT_SIZE) == 0 || zip_source_open(source) != 0) {
    failToZip(zip_error_strerror(zip_source_error(source)));
  }
  std::string bytes(stat.size, '\0');
  const zip_int64_t read = zip_source_read(source, bytes.data(), bytes.size());
  zip_source_close(source);
  if (read < 0 || static_cast<std::size_t>(read) != bytes.size()) {
    failToZip(zip_error_strerror(zip_source_error(source)));
  }
  return bytes;
}

}  // namespace

std::string zipBytes(std::span<const ZipEntry> entries) {
  ZipFault fault;
  const ZipSource target(zip_source_buffer_create(nullptr, 0, 0, fault.get()));
  if (!target) failToZip(fault.words());
  ZipArchive archive(zip_open_from_source(target.get(), ZIP_TRUNCATE, fault.get()));
  if (!archive) failToZip(fault.words());
  // The archive frees its source; this keeps it for the bytes.
  zip_source_keep(target.get());
  for (const ZipEntry& entry : entries) {
    zip_source_t* content = zip_source_buffer(archive.get(), entry.content.data(), entry.content.size(), 0);
    if (content == nullptr || zip_file_add(archive.get(), entry.name.c_str(), content, ZIP_FL_ENC_UTF_8) < 0) {
      zip_source_free(content);
      failToZip(zip_strerror(archive.get()));
    }
  }
  if (zip_close(archive.get()) != 0) failToZip(zip_strerror(archive.get()));
  static_cast<void>(archive.release());  // closing has freed it
  return bytesOf(target.get());
}

}  // namespace hexoderm
