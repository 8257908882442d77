#include "host/evaluate/published_table.h"

#include <gtest/gtest.h>

#include <string>

namespace isotouch::evaluate {
namespace {

TEST(PublishedTable, ThePapersRowsAreThoseOfItsTable1) {
  std::string names;
  std::size_t points = 0, inside = 0;
  double seconds = 0;
  for (const PaperRow& row : paper_table()) {
    names += std::string(row.name) + ' ';
    points += row.points;
    inside += row.inside_nodes;
    seconds += row.seconds;
  }
  EXPECT_EQ(names, "hydrant owl boy bomberman jaguar ");
  EXPECT_EQ(points, 20'818U);
  EXPECT_EQ(inside, 2'978'926U);
  EXPECT_NEAR(seconds, 217.7, 1e-9);
}

TEST(PublishedTable, OurObjectsAreAsLargeAsThePapersHeavy) {
  const PaperRow& paper = paper_table()[1];
  const PublishedRow owl = published_row(paper);
  EXPECT_EQ(owl.name, "owl");
  EXPECT_EQ(owl.points, paper.points);
  EXPECT_LE((owl.grid - paper.grid).cwiseAbs().maxCoeff(), 3) << owl.grid.transpose();
  EXPECT_NEAR(static_cast<double>(owl.inside_nodes), static_cast<double>(paper.inside_nodes), 0.05 * 824'436);
  EXPECT_GT(owl.seconds, 0);
}

}  // namespace
}  // namespace isotouch::evaluate
