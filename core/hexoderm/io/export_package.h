#pragma once

#include "hexoderm/io/exporter.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

namespace hexoderm {

/// A file that a package carries along as it is: a report.
struct PackageAttachment {
  std::string name;  ///< without folders
  std::string bytes;
  Message what;
};

/// What goes into a package of several formats.
struct PackageContent {
  std::vector<ExportFormat> formats;
  bool calibration = false;  ///< Hexoderm's own file too, from which the others can be made again
  std::vector<PackageAttachment> attachments;
};

/// A file of a package, for the list before and after it is written.
struct PackageEntry {
  std::string name;
  Message what;             ///< what it is, one line
  Message frame;            ///< what its coordinates are in, with their unit; empty where it has none
  Message not_carried;      ///< what the calibration holds and this file can't
  Message left_out;         ///< patches of this calibration that are not in it
  std::uintmax_t size = 0;  ///< bytes; 0 before it is made
};

/// The files that exportPackage() will write, the manifest as the last one. A format that makes several files is one
/// entry, which says so. Throws as exportPackage().
std::vector<PackageEntry> previewPackage(const Reconstruction& reconstruction, const PackageContent& content,
                                         const ExportOptions& options = {});

/// Whether a package of this name is one file.
bool isZip(const std::filesystem::path& path);

/// Called on the thread that writes: the file that is being made, and how many are done, of how many.
using PackageProgress = std::function<void(const std::string& name, std::size_t done, std::size_t count)>;

/// What was written of a package.
struct WrittenPackage {
  std::vector<PackageEntry> entries;
  std::vector<std::filesystem::path> paths;  ///< of a folder its files, else the archive
};

/// Several formats, each as "skin" with its extension, and what else is asked for, with manifest.json (frames in words,
/// units, versions and hashes): in a folder or, if `path` ends in .zip, in an archive, there in a folder of the
/// archive's name. All of it or nothing: every file, or the archive, is read back and compared byte for byte before
/// anything gets its name. `stop` is looked at before every file, before the archive, and before the names of a folder
/// are given; a stopped one leaves nothing and returns no entries. Throws as exportReconstruction(); InvalidArgument
/// for a package of nothing or with a name twice.
WrittenPackage exportPackage(const Reconstruction& reconstruction, const PackageContent& content,
                             const std::filesystem::path& path, const ExportOptions& options = {},
                             const std::stop_token& stop = {}, const PackageProgress& progress = {});

}  // namespace hexoderm
