#pragma once

#include "hexoderm/skin/patch_on_link.h"
#include "hexoderm/solve/result/reconstruction.h"

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hexoderm {

/// Everything that a calibration can be exported as.
enum class ExportFormat {
  Csv,
  Dot,
  Ply,
  Stl,
  Vtp,
  Urdf,
  RobotUrdf,
  TfRos1,
  TfRos2,
  TfYaml,
  Tum,
  Icub,
  Skinware,
  Obj,
  Gltf,
  Sdf,
  Mjcf,
};
/// The unit of lengths in a file.
enum class LengthUnit { Millimetres, Metres };

/// What a format can hold of a skin of several patches. How they lie to each other is not known, so that what has one
/// frame holds one patch, or those that are placed on one link.
enum class PatchesInFile {
  One,
  /// Every point names its patch, but programs draw all patches at the same place.
  AllIfAsked,
  All,      ///< rows that name their frame, or a drawing that is no map
  OnALink,  ///< those that are placed on one link; one patch, in its parent link, where none is placed
  OnLinks,  ///< those that are placed, each in the frame of its link; one patch where none is placed
};

/// How a URDF of the skin can be used.
enum class UrdfForm {
  Alone,  ///< defines the parent link, so that it can be loaded alone
  Part,   ///< links and joints without the parent link, to be included in a robot that has it
  Macro,  ///< a xacro macro for each patch, with its parent link and origin as parameters
};

/// A file that went into what is exported, for the manifest.
struct ExportInput {
  std::string role;  ///< "calibration", "robot"
  std::string file;
  std::string sha256;
};

/// Choices that belong to single formats, which others ignore, and the choice of the patches.
struct ExportOptions {
  LengthUnit stl_unit = LengthUnit::Millimetres;  ///< STL carries no unit of its own
  std::string model_name = "skin";                ///< of a URDF, SDF or MJCF model
  std::string parent_link = "base_link";          ///< of a patch that is not placed
  std::string prefix = "skin_";                   ///< of every link, joint and frame
  bool link_per_cell = true;  ///< false: one per patch, cells as visuals (RViz slows down with many links)
  UrdfForm urdf_form = UrdfForm::Alone;
  std::filesystem::path robot_urdf;  ///< the robot that gets the skin
  std::optional<CellId> patch;  ///< the patch that holds this cell, alone; none: as the format has it, or the largest
  bool all_patches = false;     ///< each in its own frame; refused by formats that hold one
  std::vector<PatchOnLink> placements;  ///< of the patches whose link is known
  std::string in_link;                  ///< coordinates in the frame of this link, of all patches that are placed on it
  std::vector<ExportInput> inputs;

  /// Throw InvalidArgument naming the option; validateFor() also if an option is missing that the format needs.
  void validate() const;
  void validateFor(ExportFormat format) const;  ///< the same, and throws if an option is missing that the format needs
};

/// A format, for help and dialogs.
struct ExportFormatDescription {
  ExportFormat format;
  std::string_view name;       ///< the name on the command line
  std::string_view extension;  ///< with the dot, no two formats have the same; CSV writes a folder and has none
  Message summary;             ///< one line for help and dialogs
  PatchesInFile patches = PatchesInFile::One;
  Message not_carried;  ///< what a calibration holds and the format can't, for a line before it is written
};
/// All formats, in the order in which they are listed to people.
std::span<const ExportFormatDescription> exportFormats();
const ExportFormatDescription& exportFormatDescription(ExportFormat format);  ///< the description of a format
std::string inWords(const std::vector<ExportFormat>& formats);                ///< "urdf, sdf"
/// Throws InvalidArgument listing the formats there are.
ExportFormat exportFormatFromName(std::string_view name);

/// An option of single formats as a value, so that a command line and a dialog offer all of them without knowing any.
struct ExportOptionDescription {
  /// What a dialog shows for it.
  enum class Kind { Text, Choice, File };
  /// One of the values that can be chosen.
  struct Choice {
    std::string_view value;
    Message label;
  };
  std::string_view name;  ///< on the command line, after "--"
  Message label;          ///< in front of a field
  Message help;
  Kind kind = Kind::Text;
  std::vector<Choice> choices;
  std::vector<ExportFormat> formats;  ///< that it belongs to
  std::string (*get)(const ExportOptions& options);
  void (*set)(ExportOptions& options, const std::string& value);  ///< of a choice one of its values
};
std::span<const ExportOptionDescription> exportOptions();  ///< all options of single formats

/// A patch that an export leaves out.
struct PatchLeftOut {
  PatchId patch;
  CellId origin;
  std::vector<CellId> cells;
  bool not_on_link = false;  ///< it is not placed on a link that the file holds; else how it lies is not known
};
/// What exportReconstruction() leaves out with the same arguments. InvalidArgument: the options and the format don't go
/// together, or no patch holds the cell.
std::vector<PatchLeftOut> patchesLeftOut(const Reconstruction& reconstruction, ExportFormat format,
                                         const ExportOptions& options = {});
/// "Not in the file: the patch of cell 20 (1 cell), because ..."; empty if nothing is left out.
Message leftOutText(const std::vector<PatchLeftOut>& patches);

/// Writes the reconstruction in one format. Returns the files written (one; for CSV the tables that
/// resources/formats/README.md describes and a manifest in the folder `path`). All-or-nothing: what fails leaves no
/// file, an earlier one stays as it was; storage problems, a file that reads back with other bytes among them, throw
/// StorageError. Links and what is no file are treated as by writeFileAtomically(). InvalidArgument: an option or
/// number makes no sense, or a mesh format (PLY, STL, OBJ, glTF) is asked for without any cells; the other formats then
/// hold none. Of several patches a format holds what patchesLeftOut() does not name.
std::vector<std::filesystem::path> exportReconstruction(const Reconstruction& reconstruction, ExportFormat format,
                                                        const std::filesystem::path& path,
                                                        const ExportOptions& options = {});

/// Several formats, each as "skin" with its extension, and manifest.json with frames in words, units, versions and
/// hashes, in a folder or, if its name ends in .zip, in an archive; all of them or none (see exportPackage()). Throws
/// as exportReconstruction().
std::vector<std::filesystem::path> exportBundle(const Reconstruction& reconstruction,
                                                std::span<const ExportFormat> formats,
                                                const std::filesystem::path& folder, const ExportOptions& options = {});

/// The bytes of a format that is one file. InvalidArgument for CSV, which is a folder of files.
std::string exportBytes(const Reconstruction& reconstruction, ExportFormat format, const ExportOptions& options);

}  // namespace hexoderm
