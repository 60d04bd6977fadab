/// Figures read off a track: peaks between its entries, and the work on the pad.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

#include "impact/figures.hpp"

namespace dashpad {
namespace {

using Path = std::function<double(double)>;

/// Entries at the given times.
Track track_of(const std::vector<double>& times, const Path& force, const Path& motion,
               const Path& velocity) {
  Track track;
  track.clear();
  for (const double t : times) {
    track.history.time.push_back(t);
    track.history.force.push_back(force(t));
    track.history.motion.push_back(motion(t));
    track.history.penetration.push_back(motion(t));
    track.history.velocity.push_back(velocity(t));
  }
  return track;
}

std::vector<double> uneven_times(int count, double end) {
  std::vector<double> times;
  for (int i = 0; i <= count; ++i) times.push_back(end * std::pow(static_cast<double>(i) / count, 1.3));
  return times;
}

const Path nothing = [](double) { return 0.0; };

TEST(figures, reads_the_peak_of_a_parabola_between_the_entries) {
  const Path force = [](double t) { return 100 - 7 * (t - 0.37) * (t - 0.37); };
  Figures figures;
  read_peaks(track_of({0, 0.1, 0.3, 0.45, 0.8, 1}, force, nothing, nothing), figures);
  EXPECT_NEAR(figures.peak_force, 100, 1e-12);
  EXPECT_NEAR(figures.time_of_peak_force, 0.37, 1e-12);
}

/// A force with a long tail of 1e-5 of its peak: what decides is where it leaves 0.1 % for the last time.
TEST(figures, reads_the_end_of_contact_at_a_thousandth_of_the_peak) {
  const Impactor impactor{.mass = 2};
  const Path force = [](double t) { return 100 * (t < 1 ? 1 - t * t : 0) + (t < 3 ? 1e-3 : 0); };
  const Path velocity = [](double t) { return 5 - 50 * std::min(t - t * t * t / 3, 2.0 / 3); };
  std::vector<double> times = uneven_times(200, 1);
  times.insert(times.end(), {2, 3});
  Figures figures;
  figures.ending = Status::released;
  figures.peak_force = 100;
  Track track = track_of(times, force, nothing, velocity);
  track.stretch_starts.push_back(200);  // a kink
  read_contact_end(track, impactor, figures);
  const double end = std::sqrt(1 - (0.1 - 1e-3) / 100);
  ASSERT_TRUE(figures.contact_end);
  EXPECT_NEAR(figures.contact_end->time, end, 1e-6);
  EXPECT_NEAR(figures.contact_end->velocity, velocity(end), 1e-4);
}

TEST(figures, finds_no_end_of_contact_where_the_force_is_still_up_or_the_run_was_cut) {
  const Path rising = [](double t) { return 100 * t; };
  Figures figures;
  figures.ending = Status::released;
  figures.peak_force = 100;
  read_contact_end(track_of({0, 0.5, 1}, rising, nothing, nothing), {.mass = 1}, figures);
  EXPECT_FALSE(figures.contact_end) << "the pad holds the impactor";
  const Path falling = [](double t) { return 100 * (1 - t); };
  for (const Status ending : {Status::time_limit, Status::tolerance_not_met, Status::bottomed_out}) {
    figures.ending = ending;
    read_contact_end(track_of({0, 0.5, 1}, falling, nothing, nothing), {.mass = 1}, figures);
    EXPECT_FALSE(figures.contact_end);
  }
}

TEST(figures, does_not_look_beyond_the_ends_of_a_stretch) {
  // A cusp at 0.5, where a new stretch begins: the peak is the entry itself.
  const Path force = [](double t) { return t < 0.5 ? t * t : 0.25 - 2 * (t - 0.5); };
  Track track = track_of({0, 0.2, 0.4, 0.5, 0.6, 0.8}, force, nothing, nothing);
  track.stretch_starts.push_back(3);
  Figures figures;
  read_peaks(track, figures);
  EXPECT_EQ(figures.peak_force, 0.25);
  EXPECT_EQ(figures.time_of_peak_force, 0.5);
}

TEST(figures, reads_the_largest_motion_where_the_velocity_is_zero) {
  const Path motion = [](double t) { return 3 * t - t * t * t; };  // cubic: at t = 1, exactly
  const Path velocity = [](double t) { return 3 - 3 * t * t; };
  Figures figures;
  read_peaks(track_of({0, 0.5, 0.98, 1.01, 1.3}, nothing, motion, velocity), figures);
  EXPECT_NEAR(figures.peak_motion, 2, 1e-5);
}

TEST(figures, of_a_rigid_stop_are_those_of_its_last_entry) {
  Figures figures;
  read_peaks(track_of(
                 {0, 1, 2}, [](double t) { return t; }, [](double t) { return 2 * t; }, nothing),
             figures);
  EXPECT_EQ(figures.peak_force, 2);
  EXPECT_EQ(figures.time_of_peak_force, 2);
  EXPECT_EQ(figures.peak_penetration, 4);
}

TEST(figures, takes_the_work_along_parabolas_exactly) {
  const Path force = [](double t) { return 5 + 3 * t - 2 * t * t; };
  const Path path = [](double t) { return 2 * t - t * t / 2; };
  // Integral of F dY/dt from 0 to 2.
  const double exact = 10 * 2 + (6 - 5) * 2.0 + (-4 - 3) * 8.0 / 3 + 2 * 4.0;
  EXPECT_NEAR(work_on_pad(track_of(uneven_times(9, 2), force, path, nothing)), exact, 1e-12);
}

TEST(figures, takes_the_work_of_a_smooth_path_with_more_than_second_order) {
  const Path force = [](double t) { return std::sin(t); };
  const Path path = [](double t) { return std::sin(2 * t); };
  // sin t * 2 cos 2t = sin 3t - sin t.
  const double work = (1 - std::cos(3.0)) / 3 - (1 - std::cos(1.0));
  double before = 0;
  for (const int count : {20, 40, 80}) {
    const double error = std::abs(work_on_pad(track_of(uneven_times(count, 1), force, path, nothing)) - work);
    EXPECT_TRUE(before == 0 || std::log2(before / error) > 2.6) << count << ": " << before << ", " << error;
    before = error;
  }
  EXPECT_LT(before, 1e-7);
}

TEST(figures, takes_the_work_of_each_stretch_on_its_own) {
  // The force has a kink at t = 1, and is a straight line on either side.
  Track track = track_of(
      {0, 0.5, 1, 1.1, 1.5, 2}, [](double t) { return t < 1 ? 2 - t : 5 * t - 4; },
      [](double t) { return t; }, nothing);
  track.stretch_starts.push_back(2);
  EXPECT_NEAR(work_on_pad(track), 1.5 + 3.5, 1e-14);
}

}  // namespace
}  // namespace dashpad
