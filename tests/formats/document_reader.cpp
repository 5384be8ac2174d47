// Reads documents as the program does, one after the other, and says of each whether it takes it: many thousands of
// them would take long with a program for each.
//
// Each line of standard input is {"as": "session", "text": "..."} (or calibration, cell_model, placements), or {"as":
// "joints", "text": "...", "urdf": "..."}. Each gets a line: null if it is taken, else the complaint; of a table of
// joint angles that is taken its rows.

#include "hexoderm/base/error.h"
#include "hexoderm/io/calibration_json.h"
#include "hexoderm/io/placements_json.h"
#include "hexoderm/io/session_json.h"
#include "hexoderm/robots/joint_angles_csv.h"
#include "hexoderm/skin/cell_model.h"

#include <iostream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

namespace hexoderm {
namespace {

using nlohmann::json;

json rowsOf(const JointAnglesTable& table) {
  json rows = json::array();
  for (const JointAnglesRow& row : table.rows) {
    json angles = json::object();
    for (const auto& [joint, position] : row.angles.positions) angles[joint] = position;
    rows.push_back({{"pose", row.pose ? json(row.pose->value()) : json()},
                    {"time_s", row.time_s ? json(*row.time_s) : json()},
                    {"angles", angles}});
  }
  return rows;
}

json read(const std::string& as, const std::string& text, const json& request) {
  if (as == "joints") {
    return rowsOf(
        parseJointAnglesCsv(text, "t.csv", RobotModel::parse(request.at("urdf").get<std::string>(), "r.urdf")));
  }
  if (as == "session") {
    parseSessionJson(text, "d.json");
  } else if (as == "calibration") {
    parseCalibrationJson(text, "d.json");
  } else if (as == "cell_model") {
    cellModelFromJson(text, "d.json");
  } else if (as == "placements") {
    placementsFromJson(text, "d.json");
  } else {
    throw std::invalid_argument("there is no reader of " + as);
  }
  return nullptr;
}

json answer(const json& request) {
  try {
    return read(request.at("as").get<std::string>(), request.at("text").get<std::string>(), request);
  } catch (const FormatError& error) {
    return error.what();
  }
}

}  // namespace
}  // namespace hexoderm

int main() {
  for (std::string line; std::getline(std::cin, line);) {
    std::cout << hexoderm::answer(nlohmann::json::parse(line)).dump() << std::endl;
  }
}
