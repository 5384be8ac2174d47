#pragma once

#include "hexoderm/base/error.h"
#include "hexoderm/io/calibration_json.h"
#include "hexoderm/io/calibration_json_read.h"
#include "hexoderm/io/session_json.h"
#include "hexoderm/io/session_json_read.h"
#include "tests/support/session_matchers.h"

#include <gmock/gmock.h>

#include <memory>
#include <optional>
#include <string>

namespace hexoderm::test {

/// Which of the two readers of a format take a text: the quick one takes nothing that the thorough one does not.
enum class TakenBy { Nobody, Thorough, Both };

/// Expects that both readers take the same session from a text, or that the quick one takes none; that what is taken
/// can be written and read again, and that what is refused names the file.
inline TakenBy readSessionBothWays(const std::string& text) {
  const std::string file = "folder/s.session.json";
  std::optional<Session> thorough;
  try {
    thorough = sessionFromDocument(text, file);
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), ::testing::StartsWith(file + ": "));
  }
  if (thorough) {
    EXPECT_NO_THROW(sessionFromDocument(sessionToJson(*thorough), file)) << text;
  }
  const std::optional<Session> quick = scanSessionJson(text, file);
  if (!quick) return thorough ? TakenBy::Thorough : TakenBy::Nobody;
  EXPECT_TRUE(thorough) << "a session is taken that is refused: " << text;
  if (!thorough) return TakenBy::Nobody;
  expectSameSession(*quick, *thorough);
  EXPECT_EQ(quick->source().file, thorough->source().file);
  EXPECT_EQ(quick->source().sha256, thorough->source().sha256);
  EXPECT_EQ(quick->revision(), thorough->revision());
  EXPECT_EQ(sessionToJson(*quick), sessionToJson(*thorough));
  return TakenBy::Both;
}

/// The same of a calibration. What is written is the same only if every number is.
inline TakenBy readCalibrationBothWays(const std::string& text) {
  const std::string file = "folder/c.calibration.json";
  std::shared_ptr<const Reconstruction> thorough;
  try {
    thorough = calibrationFromDocument(text, file);
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), ::testing::StartsWith(file + ": "));
  }
  if (thorough) {
    EXPECT_NO_THROW(calibrationFromDocument(calibrationToJson(*thorough), file)) << text;
  }
  const std::shared_ptr<const Reconstruction> quick = scanCalibrationJson(text, file);
  if (!quick) return thorough ? TakenBy::Thorough : TakenBy::Nobody;
  EXPECT_TRUE(thorough) << "a calibration is taken that is refused: " << text;
  if (!thorough) return TakenBy::Nobody;
  EXPECT_EQ(calibrationToJson(*quick), calibrationToJson(*thorough));
  EXPECT_EQ(quick->layout.cells.size(), thorough->layout.cells.size());
  EXPECT_EQ(quick->layout.links.size(), thorough->layout.links.size());
  return TakenBy::Both;
}

}  // namespace hexoderm::test
