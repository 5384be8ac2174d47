#pragma once

// The commands and options that the help lists, so that a test tries every one, new ones too.

#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace hexoderm::test {

struct ListedOption {
  std::string name;  ///< "--robot"; of an argument "input"
  std::string type;  ///< "FILE"
};

/// Of the program's own help.
inline std::vector<std::string> commandsIn(const std::string& help) {
  std::istringstream lines(help);
  std::vector<std::string> names;
  std::string line;
  while (std::getline(lines, line) && line != "Subcommands:") continue;
  const std::regex entry("  ([a-z]+) .*");
  for (std::smatch match; std::getline(lines, line);) {
    if (std::regex_match(line, match, entry)) names.push_back(match[1]);
  }
  return names;
}

/// Options and arguments of a command's help that take a value.
inline std::vector<ListedOption> optionsIn(const std::string& help) {
  std::istringstream lines(help);
  std::vector<ListedOption> options;
  const std::regex entry("(?:  ){1,2}([a-z]+|(?:-\\w,)?--[-a-z]+) ([A-Z]{3,}(?::\\{)?).*");
  std::string line;
  for (std::smatch match; std::getline(lines, line);) {
    if (!std::regex_match(line, match, entry)) continue;
    const std::string name = match[1];
    options.push_back({name.substr(name.find(',') + 1), match[2]});
  }
  return options;
}

}  // namespace hexoderm::test
