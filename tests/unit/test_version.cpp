#include "dashpad/version.hpp"

#include <gtest/gtest.h>

namespace dashpad {
namespace {

TEST(version, build_facts_are_all_known) {
  const BuildFacts& facts = build_facts();
  EXPECT_EQ(facts.version, version());
  for (const std::string_view fact : {facts.version, facts.git_commit, facts.compiler, facts.compiler_flags,
                                      facts.build_type, facts.system}) {
    EXPECT_FALSE(fact.empty());
    EXPECT_EQ(fact.find('@'), std::string_view::npos) << "a place of the template was not filled: " << fact;
  }
}

}  // namespace
}  // namespace dashpad
