// SPDX-License-Identifier: GPL-2.0-or-later
// Which rigid motions prescribed displacements leave free.
#include <deal.II/distributed/tria.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

#include <discretization/free_motions.h>

#include <gtest/gtest.h>

using namespace MixedCracks;
using namespace dealii;

namespace
{
  template <int dim>
  using Mesh = parallel::distributed::Triangulation<dim>;

  template <int dim>
  PrescribedPoint<dim>
  held(const Point<dim> &point, const unsigned int component)
  {
    return {point, component, nullptr};
  }

  // the body [0, 8] x [0, 2], held there
  std::vector<std::string>
  of_beam(const std::vector<PrescribedComponent<2>> &components,
          const std::vector<PrescribedPoint<2>>     &points)
  {
    Mesh<2> mesh(MPI_COMM_WORLD);
    GridGenerator::subdivided_hyper_rectangle(
      mesh, {8, 2}, Point<2>(), Point<2>(8., 2.), true);
    mesh.refine_global(1);
    return free_rigid_motions(mesh, components, points);
  }

  using Words = std::vector<std::string>;
} // namespace



TEST(FreeMotions, NoneOfABeamOnThreePoints)
{
  const Point<2> left(0., 0.), right(8., 0.), middle(4., 2.);
  EXPECT_EQ(of_beam({}, {held(left, 0), held(left, 1), held(right, 1)}),
            Words());
  EXPECT_EQ(of_beam({}, {held(left, 1), held(right, 1), held(middle, 1)}),
            Words({"the body can move in x"}));
}



TEST(FreeMotions, OfOneSideHeldInOneDirection)
{
  // boundary ids: left, right, bottom, top
  EXPECT_EQ(of_beam({{3, 1, nullptr}}, {}), Words({"the body can move in x"}));
  EXPECT_EQ(of_beam({{3, 0, nullptr}, {3, 1, nullptr}}, {}), Words());
  EXPECT_EQ(
    of_beam({{3, 0, nullptr}}, {}),
    Words({"the body can move in y", "the body can rotate about (4, 2)"}));
}



TEST(FreeMotions, RotationAboutTheOnlyPointThatIsHeld)
{
  EXPECT_EQ(of_beam({}, {held(Point<2>(2., 2.), 0), held(Point<2>(2., 2.), 1)}),
            Words({"the body can rotate about (2, 2)"}));
  // two rollers whose normals meet there
  EXPECT_EQ(of_beam({}, {held(Point<2>(0., 2.), 1), held(Point<2>(3., 0.), 0)}),
            Words({"the body can rotate about (0, 0)"}));
}



TEST(FreeMotions, AllOfABodyThatNothingHolds)
{
  EXPECT_EQ(of_beam({}, {}),
            Words({"the body can move in x and y",
                   "the body can rotate about (4, 1)"}));
}



TEST(FreeMotions, InThreeDimensions)
{
  Mesh<3> mesh(MPI_COMM_WORLD);
  GridGenerator::subdivided_hyper_rectangle(
    mesh, {2, 2, 2}, Point<3>(), Point<3>(2., 2., 2.), true);
  mesh.refine_global(1);
  const auto free = [&](const std::vector<PrescribedComponent<3>> &components,
                        const std::vector<PrescribedPoint<3>>     &points) {
    return free_rigid_motions(mesh, components, points);
  };
  EXPECT_EQ(free({{0, 0, nullptr}, {2, 1, nullptr}, {4, 2, nullptr}}, {}),
            Words());
  // symmetry in x only
  EXPECT_EQ(
    free({{0, 0, nullptr}}, {}),
    Words({"the body can move in y and z",
           "the body can rotate about the axis in x through (1, 1, 1)"}));
  // hinged along an edge
  std::vector<PrescribedPoint<3>> edge;
  for (const double z : {0., 2.})
    for (unsigned int d = 0; d < 3; ++d)
      edge.push_back(held(Point<3>(2., 0., z), d));
  EXPECT_EQ(
    free({}, edge),
    Words({"the body can rotate about the axis in z through (2, 0, 1)"}));
  EXPECT_EQ(free({}, {}).size(), 4u); // the translations are one sentence
}



TEST(FreeMotions, OfAPartThatNothingHolds)
{
  // two squares with a gap, both ends of the left one held
  Triangulation<2> left, right;
  GridGenerator::subdivided_hyper_rectangle(
    left, {2, 2}, Point<2>(0., 0.), Point<2>(2., 2.), true);
  GridGenerator::subdivided_hyper_rectangle(
    right, {2, 2}, Point<2>(3., 0.), Point<2>(5., 2.), false);
  Triangulation<2> both;
  GridGenerator::merge_triangulations(left, right, both);
  Mesh<2> mesh(MPI_COMM_WORLD);
  mesh.copy_triangulation(both);
  EXPECT_EQ(free_rigid_motions<2>(mesh,
                                  {},
                                  {held(Point<2>(0., 0.), 0),
                                   held(Point<2>(0., 0.), 1),
                                   held(Point<2>(2., 0.), 1)}),
            Words({"the part around (4, 1) can move in x and y",
                   "the part around (4, 1) can rotate about (2.5, 1)"}));
}



TEST(FreeMotions, OfPartsThatMeetAtAVertex)
{
  // two squares that share the corner (2, 2): a hinge
  Triangulation<2> lower, upper, both;
  GridGenerator::hyper_rectangle(lower, Point<2>(0., 0.), Point<2>(2., 2.));
  GridGenerator::hyper_rectangle(upper, Point<2>(2., 2.), Point<2>(4., 4.));
  GridGenerator::merge_triangulations(lower, upper, both);
  Mesh<2> mesh(MPI_COMM_WORLD);
  mesh.copy_triangulation(both);
  std::vector<PrescribedPoint<2>> points = {held(Point<2>(0., 0.), 0),
                                            held(Point<2>(0., 0.), 1),
                                            held(Point<2>(2., 0.), 1)};
  EXPECT_EQ(free_rigid_motions<2>(mesh, {}, points),
            Words({"the part around (3, 3) can rotate about (2, 2)"}));
  points.push_back(held(Point<2>(4., 4.), 1));
  EXPECT_EQ(free_rigid_motions<2>(mesh, {}, points), Words());
}
