#include "experiment/batch.h"

#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <stdexcept>

#include "experiment/batch_worker.h"

namespace murosimf {

namespace {

constexpr int kWorkerFault = 1;        ///< exit code of a worker that could not write results
constexpr double kPatience = 10;       ///< after an interruption, until workers are killed [s]
constexpr useconds_t kPause = 10'000;  ///< between two looks at the workers [us]

volatile std::sig_atomic_t interruption = 0;

void interrupt(int) { interruption = 1; }

/// SIGINT and SIGTERM set the flag while this lives.
class InterruptionWatch {
 public:
  InterruptionWatch() {
    interruption = 0;
    struct sigaction action {};
    action.sa_handler = interrupt;
    sigaction(SIGINT, &action, &before_int_);
    sigaction(SIGTERM, &action, &before_term_);
  }
  ~InterruptionWatch() {
    sigaction(SIGINT, &before_int_, nullptr);
    sigaction(SIGTERM, &before_term_, nullptr);
  }
  InterruptionWatch(const InterruptionWatch&) = delete;
  InterruptionWatch& operator=(const InterruptionWatch&) = delete;

 private:
  struct sigaction before_int_ {
  }, before_term_{};
};

/// Signals by which the program itself fails; all others come from outside.
bool isCrash(int signal) {
  constexpr int kCrashes[] = {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGSYS, SIGTRAP};
  return std::find(std::begin(kCrashes), std::end(kCrashes), signal) != std::end(kCrashes);
}

class Supervisor {
 public:
  Supervisor(const std::vector<BatchRun>& runs, const ResultStore& store, const PlayRun& play,
             const BatchSettings& settings)
      : runs_(runs),
        store_(store),
        play_(play),
        settings_(settings),
        board_(settings.workers, runs.size()),
        workers_(static_cast<std::size_t>(settings.workers), -1),
        kills_(runs.size(), 0) {}

  BatchOutcome run() {
    findResults(settings_.retry_failed);
    const std::size_t open = board_.count(RunState::kOpen);
    if (!settings_.quiet && open < runs_.size())
      fmt::print(stderr, "{} of {} runs have results already\n", runs_.size() - open, runs_.size());
    if (open > 0) playOpenRuns(open);
    BatchOutcome outcome;
    outcome.done = static_cast<int>(board_.count(RunState::kDone));
    outcome.failed = static_cast<int>(board_.count(RunState::kFailed));
    outcome.missing = static_cast<int>(runs_.size()) - outcome.done - outcome.failed;
    outcome.restarts = restarts_;
    outcome.interrupted = interrupted_;
    return outcome;
  }

 private:
  void findResults(bool retry_failed) {
    for (std::size_t i = 0; i < runs_.size(); ++i) {
      if (board_.state(i) != RunState::kOpen) continue;
      const std::optional<RunResult> result = store_.read(runs_[i].identity);
      if (result && (result->failure.empty() || !retry_failed)) board_.settle(i, stateOf(*result));
    }
  }

  void playOpenRuns(std::size_t open) {
    const InterruptionWatch watch;
    for (std::size_t w = 0; w < workers_.size() && w < open; ++w) start(static_cast<int>(w));
    double since_interruption = 0;
    while (std::any_of(workers_.begin(), workers_.end(), [](pid_t pid) { return pid > 0; })) {
      int status = 0;
      const pid_t ended = waitpid(-1, &status, WNOHANG);
      if (ended > 0) {
        onEnd(ended, status);
        continue;
      }
      usleep(kPause);
      if (interruption == 0) continue;
      if (since_interruption == 0) signalWorkers(SIGTERM);
      since_interruption += 1e-6 * kPause;
      if (since_interruption > kPatience) signalWorkers(SIGKILL);
    }
    interrupted_ = interruption != 0;
    if (!fault_.empty()) throw std::runtime_error(fault_);
    findResults(false);  // of other machines
  }

  void start(int worker) {
    std::fflush(nullptr);
    const pid_t parent = getpid();
    const pid_t pid = fork();
    if (pid < 0) throw std::runtime_error(fmt::format("no process can be started: {}", std::strerror(errno)));
    if (pid == 0) becomeWorker(worker, parent);
    workers_[static_cast<std::size_t>(worker)] = pid;
  }

  [[noreturn]] void becomeWorker(int worker, pid_t parent) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    int code = 0;
    try {
      if (getppid() == parent) {
        BatchWorker(runs_, store_, play_, settings_, board_, worker).work([] { return interruption != 0; });
      }
    } catch (const std::exception& fault) {
      fmt::print(stderr, "error: {}\n", fault.what());
      code = kWorkerFault;
    }
    std::fflush(nullptr);
    _exit(code);  // what the parent opened is the parent's to close
  }

  void signalWorkers(int signal) {
    for (const pid_t pid : workers_)
      if (pid > 0) kill(pid, signal);
  }

  void onEnd(pid_t pid, int status) {
    const auto at = std::find(workers_.begin(), workers_.end(), pid);
    if (at == workers_.end()) return;
    *at = -1;
    const int worker = static_cast<int>(at - workers_.begin());
    const int run = board_.playing(worker);
    board_.setPlaying(worker, -1);
    if (WIFEXITED(status)) {
      if (WEXITSTATUS(status) != 0) fault_ = "a worker could not go on (above)";
      return;
    }
    if (interruption != 0) return;
    if (run >= 0 && board_.state(static_cast<std::size_t>(run)) == RunState::kOpen)
      judge(static_cast<std::size_t>(run), WTERMSIG(status));
    ++restarts_;
    start(worker);
  }

  /// A worker died by this signal while it played this run.
  void judge(std::size_t run, int signal) {
    if (isCrash(signal)) return recordCrash(run, signal);
    if (++kills_[run] < kMostKills) return;
    board_.settle(run, RunState::kGivenUp);
    fmt::print(stderr, "warning: {}: given up, its worker was killed {} times ({}); is there too little memory?\n",
               runs_[run].label, kMostKills, strsignal(signal));
  }

  void recordCrash(std::size_t run, int signal) {
    RunResult result;
    result.run = runs_[run].settings;
    result.program = settings_.program;
    result.failure = fmt::format("the program crashed: {}", strsignal(signal));
    const std::unique_ptr<RunClaim> claim = store_.claim(runs_[run].identity);
    if (claim == nullptr) return;  // somebody else tries it
    store_.write(runs_[run].identity, result, *claim);
    board_.settle(run, RunState::kFailed);
    if (settings_.quiet) return;
    fmt::print(stderr, "[{}/{}] {}: failed: {}\n", board_.settled(), board_.size(), runs_[run].label, result.failure);
  }

  const std::vector<BatchRun>& runs_;
  const ResultStore& store_;
  const PlayRun& play_;
  const BatchSettings& settings_;
  BatchBoard board_;
  std::vector<pid_t> workers_;
  std::vector<int> kills_;
  int restarts_ = 0;
  bool interrupted_ = false;
  std::string fault_;
};

}  // namespace

BatchOutcome playBatch(const std::vector<BatchRun>& runs, const ResultStore& store, const PlayRun& play,
                       const BatchSettings& settings) {
  return Supervisor(runs, store, play, settings).run();
}

}  // namespace murosimf
