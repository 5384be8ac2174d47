#pragma once

#include "tests/support/patience.h"
#include "tests/support/pipe.h"

#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>

#include <chrono>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

namespace hexoderm::test {

/// A program in a process of its own, with pipes for its standard streams, which ends with this object.
class ChildProcess {
 public:
  /// What becomes of what the program writes: it is read; it is never read, and its pipe is full from the start; it
  /// goes where the test's own goes; it goes where the program's output goes.
  enum class Stream { Read, Never, Inherited, AsOutput };

  explicit ChildProcess(std::vector<std::string> words, const std::string& folder = ".", Stream out = Stream::Read,
                        Stream err = Stream::Inherited) {
    if (out == Stream::Never) out_.fill();
    if (err == Stream::Never) err_.fill();
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    process_ = ::fork();
    if (process_ == 0) {
      ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // a test that is killed leaves nothing behind
      ::dup2(in_.ends[0], STDIN_FILENO);
      ::dup2(out_.ends[1], STDOUT_FILENO);
      if (err == Stream::AsOutput) ::dup2(STDOUT_FILENO, STDERR_FILENO);
      if (err == Stream::Read || err == Stream::Never) ::dup2(err_.ends[1], STDERR_FILENO);
      // As in a terminal, not as behind the & of a script.
      ::signal(SIGINT, SIG_DFL);
      if (::chdir(folder.c_str()) != 0) ::_exit(126);
      ::execv(arguments[0], arguments.data());
      ::_exit(127);
    }
    in_.closeEnd(0);
    out_.closeEnd(1);
    err_.closeEnd(1);
  }
  ~ChildProcess() { kill(); }
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  void write(const std::string& text) const { in_.write(text); }
  /// A line typed, and its answer.
  std::string type(const std::string& line) const {
    write(line + "\n");
    return readLine();
  }
  std::string readLine() const {
    std::string line;
    for (char c = 0; ::read(out_.ends[0], &c, 1) == 1 && c != '\n';) line += c;
    return line;
  }
  /// The end of its output that is read here.
  [[nodiscard]] int output() const { return out_.ends[0]; }
  void waitForOutput(const std::string& text) const { waitFor(text, out_.ends[0]); }
  void waitForError(const std::string& text) const { waitFor(text, err_.ends[0]); }
  void closeInput() { in_.closeEnd(1); }
  /// Until it sleeps in the kernel, or has ended: it does nothing by itself any more.
  void waitUntilIdle() const {
    const auto until = std::chrono::steady_clock::now() + kPatience;
    int idle = 0;
    while (idle < 10 && std::chrono::steady_clock::now() < until) {
      std::ifstream file("/proc/" + std::to_string(process_) + "/stat");
      std::string line;
      std::getline(file, line);
      const std::size_t state = line.rfind(')');
      idle = state != std::string::npos && line.at(state + 2) != 'R' ? idle + 1 : 0;
      ::poll(nullptr, 0, 5);
    }
  }

  /// As a terminal does for Ctrl+C.
  void interrupt() const { ::kill(process_, SIGINT); }
  /// Its exit code, or 128 and the number of the signal that ended it; nothing if it does not end.
  std::optional<int> wait() {
    const auto until = std::chrono::steady_clock::now() + kPatience;
    int status = 0;
    while (::waitpid(process_, &status, WNOHANG) == 0) {
      if (std::chrono::steady_clock::now() > until) return std::nullopt;
      ::poll(nullptr, 0, 5);
    }
    process_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }
  /// Ends it like a crash, or a plug that is pulled.
  void kill(int signal = SIGKILL) {
    if (process_ <= 0) return;
    ::kill(process_, signal);
    ::waitpid(std::exchange(process_, -1), nullptr, 0);
  }

 private:
  static void waitFor(const std::string& text, int from) {
    std::string all;
    for (char c = 0; all.find(text) == std::string::npos; all += c) {
      if (::read(from, &c, 1) != 1) throw std::runtime_error("ended after: " + all);
    }
  }

  Pipe in_, out_, err_;
  pid_t process_ = -1;
};

}  // namespace hexoderm::test
