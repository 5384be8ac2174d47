#pragma once

// Files that tests need. They stand in a header, and not on the command line of every source, so that ccache serves the
// other sources in any clone.

#include <test_paths.h>

#define HEXODERM_TEST_DATA HEXODERM_SOURCE_DIR "/tests/data"
#define HEXODERM_BASELINES HEXODERM_SOURCE_DIR "/tests/baselines"
#define HEXODERM_DEMO_ROBOT HEXODERM_SOURCE_DIR "/resources/robot/demo_arm.urdf"
#define HEXODERM_TRANSLATIONS HEXODERM_SOURCE_DIR "/resources/translations"
#define HEXODERM_SKINWIRE_SOURCES HEXODERM_SOURCE_DIR "/core/hexoderm/device/skinwire"
#define HEXODERM_CSV_SENDER HEXODERM_SOURCE_DIR "/tests/app/cli/csv_sender.py"
