#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>

#include "dashpad/report1986/validation/simulations.hpp"

namespace dashpad::report1986 {

namespace {

/// On the linear plate a support's later slopes say nothing.
Program that_runs(Program program, TestSupport support) {
  if (support == TestSupport::load_cell) return program;
  if (program == Program::mended_support_1984) return Program::printed_1984;
  if (program == Program::accurate_first_slope) return Program::accurate;
  return program;
}

struct Job {
  Program program = Program::accurate;
  Setup setup;
  friend bool operator==(const Job&, const Job&) = default;
};

/// Runs the jobs on all cores, each result in its place. The first exception of a job is thrown again.
class Workers {
 public:
  Workers(const ValidationData& data, const Material& ensolite, const std::vector<Job>& jobs,
          const Progress& progress)
      : data_(data), ensolite_(ensolite), jobs_(jobs), progress_(progress), results_(jobs.size()) {}

  std::vector<Prediction> run() {
    {
      std::vector<std::jthread> threads;
      const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
      for (std::size_t i = 1; i < std::min(cores, jobs_.size()); ++i)
        threads.emplace_back([this] { work(); });
      work();
    }
    if (fault_) std::rethrow_exception(fault_);
    return std::move(results_);
  }

 private:
  void work() {
    for (std::size_t i = next_++; i < jobs_.size(); i = next_++) {
      try {
        results_[i] = predict(data_, ensolite_, jobs_[i].program, jobs_[i].setup);
        const std::lock_guard lock(mutex_);
        if (progress_) progress_(++done_, jobs_.size());
      } catch (...) {
        const std::lock_guard lock(mutex_);
        if (!fault_) fault_ = std::current_exception();
        next_ = jobs_.size();
      }
    }
  }

  const ValidationData& data_;
  const Material& ensolite_;
  const std::vector<Job>& jobs_;
  const Progress& progress_;
  std::vector<Prediction> results_;
  std::atomic<std::size_t> next_ = 0;
  std::size_t done_ = 0;
  std::exception_ptr fault_;
  std::mutex mutex_;
};

}  // namespace

std::vector<Prediction> predict_all(const ValidationData& data, const Material& ensolite,
                                    const std::vector<Program>& which, const std::vector<Setup>& setups,
                                    const Progress& progress) {
  std::vector<Job> jobs;
  std::vector<std::size_t> job_of;
  for (const Setup& setup : setups)
    for (const Program program : which) {
      const Job job{that_runs(program, setup.support), setup};
      const auto place = std::ranges::find(jobs, job);
      job_of.push_back(static_cast<std::size_t>(place - jobs.begin()));
      if (place == jobs.end()) jobs.push_back(job);
    }
  const std::vector<Prediction> results = Workers(data, ensolite, jobs, progress).run();
  std::vector<Prediction> predictions;
  for (std::size_t i = 0; i < job_of.size(); ++i) {
    predictions.push_back(results[job_of[i]]);
    predictions.back().program = which[i % which.size()];
  }
  return predictions;
}

}  // namespace dashpad::report1986
