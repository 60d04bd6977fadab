/// The time loop takes no memory: a run allocates at most once, to clear its track, however many steps it
/// has. This test program counts every allocation, by its own operator new.

#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "impact/contacts.hpp"
#include "impact/march.hpp"
#include "shared/samples.hpp"

namespace {

std::atomic<std::size_t> allocations{0};

[[maybe_unused]] void* counted(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}

}  // namespace

// The address sanitizer brings an allocator of its own, which must not be mixed with this one.
#ifdef __SANITIZE_ADDRESS__  // by GCC
#define DASHPAD_OTHER_ALLOCATOR
#elif defined(__has_feature)  // by clang
#if __has_feature(address_sanitizer)
#define DASHPAD_OTHER_ALLOCATOR
#endif
#endif
#ifdef DASHPAD_OTHER_ALLOCATOR
constexpr bool counts = false;
#else
constexpr bool counts = true;
void* operator new(std::size_t size) { return counted(size); }
void* operator new[](std::size_t size) { return counted(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
#endif

namespace dashpad::test {
namespace {

TEST(allocation, is_counted) {
  if (!counts) GTEST_SKIP() << "the sanitizer's allocator is in use";
  const std::size_t before = allocations;
  const std::vector<double> some(1000);
  EXPECT_EQ(allocations, before + 1) << some.size();
}

/// Allocations in the time loop of an impact, at two resolutions.
void expect_none_in_the_time_loop(const ImpactCase& impact) {
  const Options options;
  Track track;
  track.reserve(options.max_steps + 2);
  Contacts().visit(impact, ColumnMath::vector, [&](auto& contact) {
    March march(impact, contact, options);
    // The first run makes room for the strains of layers.
    if (!impact.pad.layers.empty()) march.run(0.1, track);
    for (const double resolution : {0.1, 0.02}) {
      const std::size_t before = allocations;
      const Figures figures = march.run(resolution, track);
      const std::size_t after = allocations;
      EXPECT_EQ(after - before, 0U) << "speed " << impact.impactor.speed << ", " << track.size()
                                    << " steps, peak " << figures.peak_force;
    }
  });
}

template <class Law>
class AllocationOf : public testing::Test {};
TYPED_TEST_SUITE(AllocationOf, AllLaws);

/// Deep impacts included: stations are added as the pad bottoms, and it locks on the support.
TYPED_TEST(AllocationOf, TheTimeLoopIsNone) {
  for (const Support& support :
       {Support::rigid(), Support::linear(2e5), Support::through({{0.004, 300}, {0.01, 9000}})})
    for (const double speed : {1.0, 6.0}) {
      ImpactCase impact = impact_on(sample_law<TypeParam>(), support);
      impact.impactor.speed = speed;
      expect_none_in_the_time_loop(impact);
    }
}

TEST(allocation, of_layers_in_the_time_loop_is_none) {
  ImpactCase impact = impact_on(sample_law<Foam>(), Support::linear(2e5));
  PadLayer soft{.thickness = 0.01, .material = impact.pad.material};
  PadLayer hard = soft;
  hard.material.law = sample_law<CrushableFoam>();
  set_layers(impact.pad, {soft, hard});
  expect_none_in_the_time_loop(impact);
}

}  // namespace
}  // namespace dashpad::test
