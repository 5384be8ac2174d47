// From a new mean to the picture in the window: the real window shows a skin of 1,260 cells in four poses, the fourth
// of which is taken away and given back. Of each giving back is measured what the solver takes, and how long it is
// until the 3D view has drawn the new result, on the clock and as CPU time of all threads. The command is in README.md.

#include "app/window/main_window/main_window.h"
#include "hexoderm/base/freed_memory.h"
#include "hexoderm/base/median.h"
#include "hexoderm/session/session_store.h"
#include "tests/benchmarks/cpu_time.h"
#include "tests/support/newcomer.h"
#include "tests/support/qt_wait.h"
#include "tests/support/simulated_skins.h"
#include "widgets/patch/scene_widget.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkNew.h>
#include <QElapsedTimer>
#include <QTextStream>
#include <vector>

namespace hexoderm {
namespace {

/// What one new mean took, in ms.
struct Refresh {
  std::vector<double> solved;   ///< as the result states it
  std::vector<double> result;   ///< until the window has the result
  std::vector<double> picture;  ///< until the 3D view has drawn it
  std::vector<double> window;   ///< of that, CPU time of the window's thread
  std::vector<double> process;  ///< and of all threads
};

class Measurement {
 public:
  explicit Measurement(MainWindow& window) : window_(window), controller_(window.controller()) {
    drawn_->SetClientData(this);
    drawn_->SetCallback([](vtkObject*, unsigned long, void* self, void*) { static_cast<Measurement*>(self)->draw(); });
    window.findChild<SceneWidget*>()->renderWindow()->AddObserver(vtkCommand::EndEvent, drawn_);
    QObject::connect(&controller_, &SessionController::reconstructionChanged, &window, [this] {
      has_result_ = true;
      result_ms_ = sinceMean_ms();
    });
  }

  Refresh run(Solver solver, int times) {
    SolverOptions options = controller_.solverOptions();
    options.solver = solver;
    controller_.setSolverOptions(options);
    settle();
    Refresh refresh;
    constexpr std::size_t kLast = 3;
    for (int k = 0; k <= times; ++k) {
      controller_.setPoseDisabled(kLast, true);
      settle();
      has_result_ = false;
      has_picture_ = false;
      clock_.start();
      const double window = cpuTime_ms(CLOCK_THREAD_CPUTIME_ID);
      const double process = cpuTime_ms(CLOCK_PROCESS_CPUTIME_ID);
      controller_.setPoseDisabled(kLast, false);
      if (!test::waitUntil([this] { return has_picture_; })) return {};
      if (k > 0) {  // the first one warms up
        refresh.window.push_back(window_ms_ - window);
        refresh.process.push_back(process_ms_ - process);
        refresh.result.push_back(result_ms_);
        refresh.picture.push_back(picture_ms_);
        refresh.solved.push_back(1e3 * controller_.reconstruction()->solve_seconds);
      }
      settle();
    }
    return refresh;
  }

 private:
  [[nodiscard]] double sinceMean_ms() const { return 1e-6 * static_cast<double>(clock_.nsecsElapsed()); }

  void draw() {
    if (!has_result_ || has_picture_) return;
    has_picture_ = true;
    picture_ms_ = sinceMean_ms();
    window_ms_ = cpuTime_ms(CLOCK_THREAD_CPUTIME_ID);
    process_ms_ = cpuTime_ms(CLOCK_PROCESS_CPUTIME_ID);
  }

  /// Until what was changed is shown, and nothing that was put off is left.
  void settle() {
    constexpr int kPause_ms = 400;
    test::waitUntil([this] { return controller_.isCurrent(); });
    QTest::qWait(kPause_ms);
  }

  MainWindow& window_;
  SessionController& controller_;
  const vtkNew<vtkCallbackCommand> drawn_;
  QElapsedTimer clock_;
  bool has_result_ = false;
  bool has_picture_ = false;
  double result_ms_ = 0;
  double picture_ms_ = 0;
  double window_ms_ = 0;
  double process_ms_ = 0;
};

int measure(const QString& folder) {
  constexpr std::size_t kRows = 30;
  constexpr std::size_t kColumns = 42;
  constexpr int kTimes = 25;
  const QString file = folder + QStringLiteral("/large.hexo");
  writeSessionStore(test::simulatedSession(test::bentSheet(kRows, kColumns, 3), 4), file.toStdString());
  MainWindow window;
  window.resize(1440, 900);
  window.show();
  if (!test::waitUntilExposed(window)) return 1;
  window.openFile(file);
  if (!test::waitUntil([&] { return window.controller().isCurrent(); })) return 1;
  QTextStream out(stdout);
  out << QStringLiteral("%1 cells; medians of %2 in ms\n").arg(kRows * kColumns).arg(kTimes)
      << "solver  solved  result  picture  CPU of the window's thread  of all threads\n";
  Measurement measurement(window);
  for (const Solver solver : {Solver::Tree, Solver::Global}) {
    const Refresh refresh = measurement.run(solver, kTimes);
    if (refresh.picture.empty()) return 1;
    out << QString::fromUtf8(std::string(solverName(solver)).c_str()).leftJustified(6);
    for (const auto& [values, width] :
         {std::pair(&refresh.solved, 8), std::pair(&refresh.result, 8), std::pair(&refresh.picture, 9),
          std::pair(&refresh.window, 28), std::pair(&refresh.process, 16)}) {
      out << QString::number(median(*values), 'f', 1).rightJustified(width);
    }
    out << '\n';
    out.flush();
  }
  return 0;
}

}  // namespace
}  // namespace hexoderm

int main(int argc, char** argv) {
  hexoderm::keepFreedMemory();  // as the program does
  const hexoderm::Newcomer newcomer;
  const QApplication application(argc, argv);
  hexoderm::applyTextFactor(1);
  return hexoderm::measure(newcomer.folder());
}
