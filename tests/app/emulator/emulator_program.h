#pragma once

// The real hexoderm-emulator, started as a user would and ended with the test.

#include "tests/support/paths.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace hexoderm {

class Program {
 public:
  explicit Program(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), HEXODERM_EMULATOR);
    std::array<int, 2> in{};
    std::array<int, 2> out{};
    if (::pipe2(in.data(), O_CLOEXEC) != 0 || ::pipe2(out.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
    std::vector<char*> words;
    for (std::string& argument : arguments) words.push_back(argument.data());
    words.push_back(nullptr);
    process_ = ::fork();
    if (process_ == 0) {
      ::dup2(in[0], STDIN_FILENO);
      ::dup2(out[1], STDOUT_FILENO);
      ::execv(words[0], words.data());
      ::_exit(127);
    }
    ::close(in[0]);
    ::close(out[1]);
    input_ = in[1];
    output_ = out[0];
  }
  ~Program() {
    if (process_ > 0) {
      ::kill(process_, SIGTERM);
      ::waitpid(process_, nullptr, 0);
    }
    if (input_ >= 0) ::close(input_);
    ::close(output_);
  }
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  std::string readLine() const {
    std::string line;
    for (char c = 0; ::read(output_, &c, 1) == 1 && c != '\n';) line += c;
    return line;
  }
  /// A line typed, and its answer.
  std::string type(const std::string& line) const {
    const std::string text = line + "\n";
    if (::write(input_, text.data(), text.size()) < 0) return "";
    return readLine();
  }
  /// Ends the program like a crash, or a plug that is pulled.
  void kill() {
    ::kill(process_, SIGKILL);
    wait();
  }
  void closeInput() { ::close(std::exchange(input_, -1)); }
  int wait() {
    int status = 0;
    ::waitpid(std::exchange(process_, -1), &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

 private:
  pid_t process_ = -1;
  int input_ = -1;
  int output_ = -1;
};

/// A running emulator and where it is.
struct Emulator : Program {
  explicit Emulator(std::vector<std::string> arguments) : Program(std::move(arguments)) {
    const std::string first = readLine();
    constexpr std::string_view kListening = "listening on ";
    if (!first.starts_with(kListening)) throw std::runtime_error("the emulator said: " + first);
    address = first.substr(kListening.size());
    about = readLine();
  }
  std::string address;
  std::string about;
};

}  // namespace hexoderm
