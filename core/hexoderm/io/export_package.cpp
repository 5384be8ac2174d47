#include "hexoderm/io/export_package.h"

#include "hexoderm/base/covariance.h"
#include "hexoderm/base/error.h"
#include "hexoderm/base/file.h"
#include "hexoderm/base/kept_files.h"
#include "hexoderm/base/sha256.h"
#include "hexoderm/io/calibration_json.h"
#include "hexoderm/io/export_formats.h"
#include "hexoderm/io/export_selection.h"
#include "hexoderm/io/export_staging.h"

#include <zip.h>
#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <span>
#include <utility>

namespace hexoderm {
namespace {

/// A file of a bundle.
struct ManifestFile {
  std::string name;
  std::string sha256;
  const ExportFormatDescription* format = nullptr;  ///< null: none of the export formats
  ExportSelection selection;
  // Where there is no format.
  std::string what{};
  std::string coordinates{};  ///< in words; empty: it has none
};

inline constexpr const char* kManifestFile = "manifest.json";

using ManifestJson = nlohmann::ordered_json;

/// Names of files and sensors may hold what is not UTF-8.
std::string dumped(const ManifestJson& json) {
  return json.dump(2, ' ', false, ManifestJson::error_handler_t::replace) + "\n";
}

ManifestJson lengthUnitOf(const ExportFormatDescription& format, bool has_lengths, const ExportOptions& options) {
  if (!has_lengths || format.format == ExportFormat::Dot) return nullptr;
  if (format.format == ExportFormat::Stl && options.stl_unit == LengthUnit::Millimetres) return "mm";
  if (format.format == ExportFormat::Skinware) return "nm";
  return "m";
}

std::string coordinatesText(const Reconstruction& reconstruction, const ManifestFile& file) {
  if (!file.selection.mounted.empty()) {
    std::string words;
    for (const ExportMount& mount : file.selection.mounted) {
      words += std::string(words.empty() ? "" : "; ") + "the patch of cell " + toString(mount.patch->origin) +
               (mount.placed ? " placed on link " + mount.link
                             : " joined to link " + mount.link + " without any offset, for its place is not known");
    }
    return words;
  }
  return frameText(reconstruction, file.selection);
}

ManifestJson patchesLeftOutOf(const Reconstruction& reconstruction, const ExportSelection& selection) {
  ManifestJson origins = ManifestJson::array();
  for (const PatchReconstruction& patch : reconstruction.patches) {
    if (!patch.cells.empty() && std::ranges::find(selection.patches, &patch) == selection.patches.end()) {
      origins.push_back(patch.origin.value());
    }
  }
  return origins;
}

ManifestJson fileJson(const Reconstruction& reconstruction, const ManifestFile& file, const ExportOptions& options) {
  if (file.format == nullptr) {
    ManifestJson json = {{"file", file.name}, {"format", file.what}, {"sha256", file.sha256}};
    if (!file.coordinates.empty()) json["coordinates"] = file.coordinates;
    return json;
  }
  const CsvContents contents = file.format->format == ExportFormat::Csv ? csvContents(file.name) : CsvContents();
  ManifestJson json = {{"file", file.name},
                       {"format", file.format->name},
                       {"sha256", file.sha256},
                       {"length_unit", lengthUnitOf(*file.format, contents.lengths, options)}};
  if (contents.in_frame) json["coordinates"] = coordinatesText(reconstruction, file);
  if (!file.format->not_carried.empty()) json["not_carried"] = file.format->not_carried.english();
  json["patches_left_out"] = patchesLeftOutOf(reconstruction, file.selection);
  const auto taxels = [&] { return taxelMap(*reconstruction.model, file.selection.mounted, options); };
  if (file.format->format == ExportFormat::Icub) {
    ManifestJson cells = ManifestJson::array();
    for (const Taxel& taxel : taxels().taxels) cells.push_back(taxel.cell.value());
    json["cell_of_row"] = cells;
  }
  if (file.format->format == ExportFormat::Skinware) json["links"] = taxels().links;
  return json;
}

ManifestJson rowsOf(const Eigen::Matrix3d& R) {
  ManifestJson rows = ManifestJson::array();
  for (Eigen::Index row = 0; row < 3; ++row) {
    for (Eigen::Index col = 0; col < 3; ++col) rows.push_back(R(row, col));
  }
  return rows;
}

ManifestJson frameJson(const PatchReconstruction& patch, const CellPlacement& in_patch, const ExportOptions& options) {
  const PatchOnLink* place = placementOf(patch, options);
  const CellPlacement cell = place != nullptr ? onLink(in_patch, *place) : in_patch;
  const std::string into = place != nullptr ? "link " + place->link
                                            : "the patch of cell " + toString(patch.origin) + ", in that cell's frame";
  const SE3 T = rigid(cell.T_o_u);
  ManifestJson json = {{"cell", cell.cell.value()},
                       {"frame", place != nullptr ? place->link : "cell " + toString(patch.origin)},
                       {"words", "maps points of cell " + toString(cell.cell) + " into " + into},
                       {"R", rowsOf(T.R)},
                       {"t_m", {T.t.x(), T.t.y(), T.t.z()}}};
  if (cell.cov_t_r) json["cov_t_r"] = upperTriangle(*cell.cov_t_r);
  return json;
}

ManifestJson inputsJson(const Reconstruction& reconstruction, const ExportOptions& options) {
  ManifestJson inputs = ManifestJson::array();
  for (const ExportInput& input : options.inputs) {
    inputs.push_back({{"role", input.role}, {"file", input.file}, {"sha256", input.sha256}});
  }
  if (!reconstruction.source.sha256.empty()) {
    inputs.push_back(
        {{"role", "source"}, {"file", reconstruction.source.file}, {"sha256", reconstruction.source.sha256}});
  }
  return inputs;
}

/// manifest.json of a bundle: version of the program, units, inputs and files with their SHA-256, what each file does
/// not hold, and for every cell in words and numbers into which frame its placement maps, with its covariance.
std::string manifestText(const Reconstruction& reconstruction, std::span<const ManifestFile> files,
                         const ExportOptions& options) {
  ManifestJson json = {
      {"format", "hexoderm-manifest"},
      {"version", 1},
      {"program", "Hexoderm " HEXODERM_VERSION},
      {"units", {{"length", "m"}, {"angle", "rad"}}},
      {"conventions",
       "x_frame = R x_cell + t_m, R row-major; cov_t_r is the upper triangle of the covariance, position "
       "in the frame, then rotation, its error right-multiplied in the cell's frame; units are those of this document, "
       "and columns of a CSV file end in theirs"}};
  json["cell_model"] = reconstruction.model->name;
  json["inputs"] = inputsJson(reconstruction, options);
  ManifestJson list = ManifestJson::array();
  std::set<const PatchReconstruction*> exported;
  for (const ManifestFile& file : files) {
    list.push_back(fileJson(reconstruction, file, options));
    exported.insert(file.selection.patches.begin(), file.selection.patches.end());
  }
  json["files"] = list;
  ManifestJson frames = ManifestJson::array();
  for (const PatchReconstruction& patch : reconstruction.patches) {
    if (!exported.contains(&patch)) continue;
    for (const CellPlacement& cell : patch.cells) frames.push_back(frameJson(patch, cell, options));
  }
  json["frames"] = frames;
  return dumped(json);
}

/// A file in an archive; folders in its name are parted by slashes.
struct ZipEntry {
  std::string name;
  std::string content;
};

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

/// The bytes of a zip archive of these files, compressed. Throws StorageError if there is no memory for them.
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

constexpr std::string_view kPackageStem = "skin";
constexpr std::string_view kPackagedCalibration = "skin.calibration.json";

/// Thrown and caught here alone.
struct PackageStopped {};

Message frameOf(const Reconstruction& reconstruction, const ExportSelection& selection) {
  if (!selection.mounted.empty()) {
    std::vector<Message> places;
    for (const ExportMount& mount : selection.mounted) {
      places.push_back(
          mount.placed ? message("The patch of cell {} is in its place on link {}.", mount.patch->origin, mount.link)
                       : message("The patch of cell {} has its origin at link {}: its place on the robot is not known.",
                                 mount.patch->origin, mount.link));
    }
    return inRow(std::move(places));
  }
  if (!selection.frame_link.empty()) return message("Coordinates are in the frame of link {}.", selection.frame_link);
  const PatchReconstruction* only = selection.patches.size() == 1        ? selection.patches.front()
                                    : reconstruction.patches.size() == 1 ? &reconstruction.patches.front()
                                                                         : nullptr;
  if (only == nullptr) return message("Coordinates of each patch are in the frame of its origin cell.");
  return message("Coordinates are in the frame of cell {}, the origin of the patch.", only->origin);
}

Message unitOf(const ExportFormatDescription& format, const ExportOptions& options) {
  if (format.format == ExportFormat::Stl && options.stl_unit == LengthUnit::Millimetres) {
    return message("Lengths are in millimetres.");
  }
  if (format.format == ExportFormat::Skinware) return message("Lengths are in nanometres.");
  return message("Lengths are in metres.");
}

PackageEntry entryOf(const Reconstruction& reconstruction, const ExportFormatDescription& format,
                     const ExportOptions& options) {
  const ExportSelection selection = selectForExport(reconstruction, format, options);
  PackageEntry entry;
  entry.name = format.format == ExportFormat::Csv ? "cells.csv, links.csv, ..."
                                                  : std::string(kPackageStem) + std::string(format.extension);
  entry.what = format.summary;
  if (format.format != ExportFormat::Dot) {
    entry.frame = inRow({frameOf(reconstruction, selection), unitOf(format, options)});
  }
  entry.not_carried = format.not_carried;
  entry.left_out = leftOutText(patchesLeftOut(reconstruction, format.format, options));
  return entry;
}

PackageEntry calibrationEntry() {
  return {std::string(kPackagedCalibration),
          message("everything that is known, to be opened, compared and exported from again"),
          message("Coordinates of each patch are in the frame of its origin cell. Lengths are in metres."),
          {},
          {}};
}

PackageEntry manifestEntry() {
  return {
      kManifestFile, message("what each file is, in which frame, with its hash, and what it was made of"), {}, {}, {}};
}

std::vector<ExportFormat> eachOnce(const std::vector<ExportFormat>& formats) {
  std::vector<ExportFormat> once;
  for (const ExportFormat format : formats) {
    if (std::ranges::find(once, format) == once.end()) once.push_back(format);
  }
  return once;
}

void requireSomething(const PackageContent& content, const ExportOptions& options) {
  if (content.formats.empty() && !content.calibration && content.attachments.empty()) {
    throw InvalidArgument(message("a package of nothing: choose a format"));
  }
  options.validate();
  for (const ExportFormat format : content.formats) options.validateFor(format);
}

/// The options with the robot's file among the inputs, if one of the formats reads it.
ExportOptions withRobot(ExportOptions options, std::span<const ExportFormat> formats) {
  if (!options.robot_urdf.empty() && std::ranges::find(formats, ExportFormat::RobotUrdf) != formats.end()) {
    options.inputs.push_back(
        {"robot", options.robot_urdf.filename().string(), sha256Hex(readFile(options.robot_urdf))});
  }
  return options;
}

/// Makes the files of a package one after another, and the manifest of what was made.
class PackageMaker {
 public:
  PackageMaker(const Reconstruction& reconstruction, const PackageContent& content, const ExportOptions& options,
               const std::stop_token& stop, const PackageProgress& progress)
      : reconstruction_(reconstruction),
        content_(content),
        formats_(eachOnce(content.formats)),
        options_(withRobot(options, formats_)),
        stop_(stop),
        progress_(progress),
        count_(formats_.size() + (content.calibration ? 1 : 0) + content.attachments.size() + 1) {}

  void make() {
    for (const ExportFormat format : formats_) addFormat(exportFormatDescription(format));
    if (content_.calibration) addCalibration();
    for (const PackageAttachment& attachment : content_.attachments) addAttachment(attachment);
    addManifest();
  }
  [[nodiscard]] const std::vector<StagedFile>& files() const { return files_; }
  [[nodiscard]] std::vector<PackageEntry> entries() { return std::move(entries_); }

  void begin(const std::string& name) {
    if (stop_.stop_requested()) throw PackageStopped();
    if (progress_) progress_(name, std::min(done_, count_), count_);
    ++done_;
  }

 private:
  void addFormat(const ExportFormatDescription& format) {
    const PackageEntry entry = entryOf(reconstruction_, format, options_);
    begin(entry.name);
    FormatFiles made = formatFiles(reconstruction_, format.format, options_, std::string(kPackageStem));
    for (StagedFile& file : made.files) {
      listed_.push_back({file.name, sha256Hex(file.content), &format, made.selection});
      add(std::move(file), entry);
    }
  }

  void addCalibration() {
    const PackageEntry entry = calibrationEntry();
    begin(entry.name);
    ManifestFile listed{
        entry.name, {}, nullptr, {}, std::string(kCalibrationFormat), "each patch in the frame of its origin cell"};
    for (const PatchReconstruction& patch : reconstruction_.patches) listed.selection.patches.push_back(&patch);
    std::string text = calibrationToJson(reconstruction_);
    listed.sha256 = sha256Hex(text);
    listed_.push_back(std::move(listed));
    add({entry.name, std::move(text)}, entry);
  }

  void addAttachment(const PackageAttachment& attachment) {
    begin(attachment.name);
    listed_.push_back({attachment.name, sha256Hex(attachment.bytes), nullptr, {}, attachment.what.english(), {}});
    add({attachment.name, attachment.bytes}, {attachment.name, attachment.what, {}, {}, {}});
  }

  void addManifest() {
    begin(kManifestFile);
    add({kManifestFile, manifestText(reconstruction_, listed_, options_)}, manifestEntry());
  }

  void add(StagedFile file, PackageEntry entry) {
    if (!names_.insert(file.name).second) throw InvalidArgument(message("the package would hold {} twice", file.name));
    entry.name = file.name;
    entry.size = file.content.size();
    entries_.push_back(std::move(entry));
    files_.push_back(std::move(file));
  }

  const Reconstruction& reconstruction_;
  const PackageContent& content_;
  std::vector<ExportFormat> formats_;
  ExportOptions options_;
  const std::stop_token& stop_;
  const PackageProgress& progress_;
  std::size_t count_;
  std::size_t done_ = 0;
  std::vector<StagedFile> files_;
  std::vector<ManifestFile> listed_;
  std::vector<PackageEntry> entries_;
  std::set<std::string> names_;
};

void publishZip(const std::filesystem::path& path, const std::vector<StagedFile>& files, const std::stop_token& stop) {
  const std::string folder = path.stem().string() + "/";
  std::vector<ZipEntry> entries;
  for (const StagedFile& file : files) entries.push_back({folder + file.name, file.content});
  const std::string archive = zipBytes(entries);
  if (stop.stop_requested()) throw PackageStopped();
  writeFileAtomically(path, archive);
}

}  // namespace

bool isZip(const std::filesystem::path& path) {
  const std::string extension = path.extension().string();
  return extension == ".zip" || extension == ".ZIP";
}

std::vector<PackageEntry> previewPackage(const Reconstruction& reconstruction, const PackageContent& content,
                                         const ExportOptions& options) {
  requireSomething(content, options);
  std::vector<PackageEntry> entries;
  for (const ExportFormat format : eachOnce(content.formats)) {
    entries.push_back(entryOf(reconstruction, exportFormatDescription(format), options));
  }
  if (content.calibration) entries.push_back(calibrationEntry());
  for (const PackageAttachment& attachment : content.attachments) {
    entries.push_back({attachment.name, attachment.what, {}, {}, {}, attachment.bytes.size()});
  }
  entries.push_back(manifestEntry());
  return entries;
}

WrittenPackage exportPackage(const Reconstruction& reconstruction, const PackageContent& content,
                             const std::filesystem::path& path, const ExportOptions& options,
                             const std::stop_token& stop, const PackageProgress& progress) {
  requireSomething(content, options);
  if (path.empty()) throw InvalidArgument(message("expected the name of a file or folder to export to"));
  const KeptFile robot(options.robot_urdf);
  PackageMaker maker(reconstruction, content, options, stop, progress);
  try {
    maker.make();
    if (isZip(path)) {
      publishZip(path, maker.files(), stop);
      return {maker.entries(), {path}};
    }
    std::vector<std::filesystem::path> paths = publishFolder(path, maker.files(), [&stop] {
      if (stop.stop_requested()) throw PackageStopped();
    });
    return {maker.entries(), std::move(paths)};
  } catch (const PackageStopped&) {
    return {};
  }
}

std::vector<std::filesystem::path> exportBundle(const Reconstruction& reconstruction,
                                                std::span<const ExportFormat> formats,
                                                const std::filesystem::path& folder, const ExportOptions& options) {
  return exportPackage(reconstruction, {{formats.begin(), formats.end()}, false, {}}, folder, options).paths;
}

}  // namespace hexoderm
