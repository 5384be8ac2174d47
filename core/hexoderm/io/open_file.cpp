#include "hexoderm/io/open_file.h"

#include "hexoderm/base/error.h"
#include "hexoderm/base/file.h"
#include "hexoderm/base/json_reader.h"
#include "hexoderm/io/calibration_json.h"
#include "hexoderm/io/session_json.h"
#include "hexoderm/io/tum_xml.h"
#include "hexoderm/session/session_store.h"

#include <array>
#include <fstream>
#include <system_error>
#include <utility>

namespace hexoderm {
namespace {

Message expected() {
  return message(
      "expected a Hexoderm session (*.hexo, or format \"{}\"), a calibration (format \"{}\") or a TUM SkinConfig XML",
      kSessionFormat, kCalibrationFormat);
}

constexpr std::string_view kRecordingBegins = "SKINREC";

[[noreturn]] void refuseRecording(const std::filesystem::path& path) {
  throw FormatError(path.string(),
                    message("is a recording, which is not opened but played: connect to it as replay:FILE"));
}

/// Told by its first bytes alone, as it may be very large. A pipe is left as it is: it can be read only once.
bool isRecordingFile(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return false;
  std::array<char, kRecordingBegins.size()> first{};
  std::ifstream file(path, std::ios::binary);
  return file.read(first.data(), first.size()) && std::string_view(first.data(), first.size()) == kRecordingBegins;
}

/// The first character that says something: byte order mark and white space skipped, 0 if there is none.
char firstCharacter(std::string_view text) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first == std::string_view::npos ? '\0' : text[first];
}

}  // namespace

OpenedFile openFile(const std::filesystem::path& path, const CellModel& model_for_tum, TumAs tum) {
  if (isSessionStore(path)) return readSessionStore(path);
  if (isRecordingFile(path)) refuseRecording(path);
  const std::string text = readFile(path, kMaxSkinBytes);
  const std::string file = path.string();
  if (beginsAsSessionStore(text)) return parseSessionStore(text, file);
  if (text.starts_with(kRecordingBegins)) refuseRecording(path);
  switch (firstCharacter(text)) {
    case '<': {
      const TumSkinConfig config = parseTumXml(text, file);
      if (tum == TumAs::Session) return sessionFromTum(config, model_for_tum, file);
      return calibrationFromTum(config, model_for_tum, file);
    }
    case '{':
      break;
    case '\0':
      throw FormatError(file, message("the file is empty, {}", expected()));
    default:
      throw FormatError(file, message("is none of the files that Hexoderm reads, {}", expected()));
  }
  const std::optional<std::string> format = findJsonFormat(text);
  if (format == kSessionFormat) return parseSessionJson(text, file);
  if (format == kCalibrationFormat) return parseCalibrationJson(text, file);
  if (!format) static_cast<void>(parseJson(text, file));  // a text that is not even JSON is reported first
  throw FormatError(file, located("format", format ? message("{}, found \"{}\"", expected(), *format)
                                                   : message("{}, but there is none", expected())));
}

Session openSession(const std::filesystem::path& path) {
  OpenedFile opened = openFile(path, builtInCellModel("hex-bma150"));
  if (auto* session = std::get_if<Session>(&opened)) return std::move(*session);
  throw noSession(path);
}

std::shared_ptr<const Reconstruction> openCalibration(const std::filesystem::path& path,
                                                      const CellModel& model_for_tum) {
  OpenedFile opened = openFile(path, model_for_tum);
  if (auto* calibration = std::get_if<std::shared_ptr<const Reconstruction>>(&opened)) return std::move(*calibration);
  throw FormatError(path.string() +
                    ": this is a session, expected a calibration; \"hexoderm-cli solve\" makes one of it");
}

FormatError noSession(const std::filesystem::path& path) {
  return FormatError(path.string() + ": this is a calibration, expected a session (*.hexo or *.session.json)");
}

bool isSessionFileName(const std::filesystem::path& path) {
  const std::string name = path.filename().string();
  return name.ends_with(".hexo") || name.ends_with(".session.json");
}

void saveSession(const Session& session, const std::filesystem::path& path) {
  if (path.filename().string().ends_with(".hexo")) {
    writeSessionStore(session, path);
  } else {
    writeSessionJson(session, path);
  }
}

}  // namespace hexoderm
