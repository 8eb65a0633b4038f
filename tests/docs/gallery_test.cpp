// builds: clang++ all
// The program of a page of the gallery, without the part that writes files.
#define main bead_main
#include <docs/gallery/page.cpp>
#undef main

#include <gtest/gtest.h>

int gallery::page::write(const material& all) const {
  EXPECT_TRUE(holds()) << cause();
  EXPECT_EQ(proofs().size(), 2U);
  EXPECT_EQ(all.motion.shapes.size(), 2U) << all.motion.cause();
  EXPECT_EQ(all.parameters, Eigen::Vector2d(0.2, 5));
  EXPECT_GT(all.nanoseconds, 0);
  return holds() ? 0 : 1;
}

TEST(docs_gallery, page) { EXPECT_EQ(bead_main(0, nullptr), 0); }
