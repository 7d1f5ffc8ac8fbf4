// SPDX-License-Identifier: GPL-2.0-or-later
// Maps of the material: pictures and tables as they are read, values between
// their nodes against those of (multi)linear functions, and what is refused.
#include <problem/grid_data.h>

#include <gtest/gtest.h>

using namespace MixedCracks;

namespace
{
  constexpr auto nearest = GridData::Interpolation::nearest;
  constexpr auto linear  = GridData::Interpolation::linear;

  double
  affine(const double x, const double y, const double z)
  {
    return 3. + 2. * x - 5. * y + 0.5 * z;
  }

  // a table of that function, z fastest and x descending: no expected order
  std::string
  table_of_affine(const std::string &separator)
  {
    std::string text = "# made by hand\n";
    for (const double x : {4., 1., 0.})
      for (const double y : {-1., 0.5})
        for (const double z : {0., 1., 3.})
          text += std::to_string(x) + separator + std::to_string(y) +
                  separator + std::to_string(z) + separator +
                  std::to_string(affine(x, y, z)) + "\n";
    return text;
  }
} // namespace



TEST(GridData, LinearInterpolationReproducesAnAffineFunction)
{
  for (const std::string separator : {",", " ; ", "\t"})
  {
    Table table;
    ASSERT_EQ(read_table(table_of_affine(separator), 3, table), "");
    EXPECT_EQ(table.axes[0], std::vector<double>({0., 1., 4.}));
    const GridData grid(table.axes, table.values, linear);
    for (const double x : {0., 0.3, 1., 2.9, 4.})
      for (const double y : {-1., 0.1, 0.5})
        for (const double z : {0., 0.9, 2.5})
          EXPECT_NEAR(grid.value({{x, y, z}}), affine(x, y, z), 1e-5);
    // goes on as at the edge
    EXPECT_NEAR(grid.value({{9., -7., 5.}}), affine(4., -1., 3.), 1e-5);
    EXPECT_NEAR(grid.value({{-9., 7., -5.}}), affine(0., 0.5, 0.), 1e-5);
  }
}



TEST(GridData, NearestTakesTheValueOfTheNearestNode)
{
  Table table;
  ASSERT_EQ(read_table(table_of_affine(","), 3, table), "");
  const GridData grid(table.axes, table.values, nearest);
  EXPECT_NEAR(grid.value({{0.4, 0.2, 1.9}}), affine(0., 0.5, 1.), 1e-5);
  EXPECT_NEAR(grid.value({{2.6, -0.3, 2.1}}), affine(4., -1., 3.), 1e-5);
  EXPECT_NEAR(grid.value({{99., -99., -99.}}), affine(4., -1., 0.), 1e-5);
}



TEST(GridData, ThreeColumnsDoNotDependOnZ)
{
  for (const int dim : {2, 3})
  {
    Table table;
    ASSERT_EQ(read_table("x,y,value\n0,0,1\n2,0,3\n0,1,5\n2,1,7\n", dim, table),
              "");
    const GridData grid(table.axes, table.values, linear);
    EXPECT_NEAR(grid.value({{1., 0.5, 0.}}), 4., 1e-14);
    EXPECT_NEAR(grid.value({{1., 0.5, 77.}}), 4., 1e-14);
  }
}



TEST(GridData, BrokenTablesAreRefusedWithTheLine)
{
  Table      table;
  const auto problem = [&](const std::string &text, const int dim) {
    return read_table(text, dim, table);
  };
  EXPECT_NE(problem("", 2).find("no numbers"), std::string::npos);
  EXPECT_NE(problem("x,y,value\n", 2).find("no numbers"), std::string::npos);
  EXPECT_NE(problem("0,0,1\n1,0\n", 2).find("line 2"), std::string::npos);
  EXPECT_NE(problem("0,0,1\n1,0,soft\n", 2).find("'1,0,soft'"),
            std::string::npos);
  EXPECT_NE(problem("0,0,0,1\n", 2).find("'x, y, value'"), std::string::npos);
  EXPECT_NE(problem("0,0,nan\n", 2).find("no numbers"), std::string::npos);
  EXPECT_NE(problem("0,0,1\n1,0,nan\n", 2).find("line 2"), std::string::npos);
  // a corner is missing, or is there twice
  EXPECT_NE(problem("0,0,1\n1,0,1\n0,1,1\n", 2).find("2 x 2"),
            std::string::npos);
  EXPECT_NE(problem("0,0,1\n1,0,1\n0,1,1\n0,1,2\n", 2).find("no grid"),
            std::string::npos);
  EXPECT_EQ(problem("0,0,1\n1,0,1\n0,1,1\n1,1,2\n", 2), "");
}



TEST(GridData, PlainAndRawPicturesAreTheSame)
{
  const std::string plain = "P2 # plain\n3 2\n# white\n200\n"
                            "0 50 100\n150 200 20\n";
  std::string       raw   = "P5\n3 2\n200\n";
  for (const int gray : {0, 50, 100, 150, 200, 20})
    raw += static_cast<char>(static_cast<unsigned char>(gray));
  // two bytes for each pixel, the high one first
  std::string wide = "P5 3 2 400\n";
  for (const int gray : {0, 100, 200, 300, 400, 40})
  {
    wide += static_cast<char>(static_cast<unsigned char>(gray / 256));
    wide += static_cast<char>(static_cast<unsigned char>(gray % 256));
  }
  const std::vector<double> expected = {0., 0.25, 0.5, 0.75, 1., 0.1};
  for (const std::string &text : {plain, raw, wide})
  {
    ASSERT_TRUE(looks_like_picture(text));
    Picture picture;
    ASSERT_EQ(read_picture(text, picture), "");
    EXPECT_EQ(picture.width, 3u);
    EXPECT_EQ(picture.height, 2u);
    EXPECT_EQ(picture.values, expected);
  }
}



TEST(GridData, BrokenPicturesAreRefused)
{
  const auto problem = [](const std::string &text) {
    Picture picture;
    return read_picture(text, picture);
  };
  EXPECT_NE(problem("P6\n1 1\n255\nabc").find("PGM"), std::string::npos);
  EXPECT_NE(problem("\x89PNG\r\n").find("PGM"), std::string::npos);
  EXPECT_TRUE(looks_like_picture("\x89PNG\r\n"));
  EXPECT_FALSE(looks_like_picture("0, 0, 1\n"));
  EXPECT_NE(problem("P2\n2 two\n255\n").find("head"), std::string::npos);
  EXPECT_NE(problem("P2\n0 2\n255\n").find("0 x 2"), std::string::npos);
  EXPECT_NE(problem("P5\n999999999 999999999 255\n").find("claims"),
            std::string::npos);
  EXPECT_NE(problem("P2\n2 2\n0\n1 1 1 1").find("white"), std::string::npos);
  EXPECT_NE(problem("P2\n2 2\n9\n1 1 1").find("last pixel"), std::string::npos);
  EXPECT_NE(problem("P2\n2 2\n9\n1 1 1 10").find("pixel of 10"),
            std::string::npos);
  EXPECT_NE(problem("P5\n2 2\n255\nabc").find("last pixel"), std::string::npos);
  EXPECT_NE(problem("P2\n2 2\n9\n1 1 x 1 1 1").find("something else"),
            std::string::npos);
}
