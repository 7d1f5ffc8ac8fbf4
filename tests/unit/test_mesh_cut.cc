// SPDX-License-Identifier: GPL-2.0-or-later
// Triangles, tetrahedra and prisms cut into quadrilaterals and hexahedra: the
// body and its boundary stay what they are, and an affine field is in the space
// of the pieces, in the derivative as well (the patch test).
#include <deal.II/base/function_lib.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparse_direct.h>
#include <deal.II/numerics/matrix_tools.h>
#include <deal.II/numerics/vector_tools.h>

#include <discretization/mesh_quality.h>

#include <problem/geometries/mesh_scan.h>

#include <gtest/gtest.h>

#include "mesh_files.h"

using namespace GeometryTests;
using dealii::Triangulation;

namespace
{
  // A square of side 2 with a node inside, moved from the middle: two triangles
  // at the left, one at the top, and a square beside them, [2, 3] x [0, 2]
  const std::string nodes_2d = "7\n1 0 0 0\n2 2 0 0\n3 2 2 0\n4 0 2 0\n"
                               "5 0.8 1.1 0\n6 3 0 0\n7 3 2 0\n";
  const std::string cells_2d = "7\n1 1 2 1 1 1 2\n2 1 2 2 2 4 1\n"
                               "11 2 2 7 1 1 2 5\n12 2 2 7 1 2 3 5\n"
                               "13 2 2 7 1 3 4 5\n14 2 2 7 1 4 1 5\n"
                               "15 3 2 8 1 2 6 7 3\n";

  // The unit cube as six tetrahedra around a diagonal, and a prism on top of
  // half of it
  const std::string nodes_3d =
    "11\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n5 0 0 1\n6 1 0 1\n7 1 1 1\n"
    "8 0 1 1\n9 0 0 2\n10 1 0 2\n11 1 1 2\n";
  const std::string cells_3d = "9\n1 2 2 1 1 1 3 2\n2 2 2 1 1 1 4 3\n"
                               "11 4 2 7 1 1 2 3 7\n12 4 2 7 1 1 3 4 7\n"
                               "13 4 2 7 1 1 4 8 7\n14 4 2 7 1 1 8 5 7\n"
                               "15 4 2 7 1 1 5 6 7\n16 4 2 7 1 1 6 2 7\n"
                               "17 6 2 8 1 5 6 7 9 10 11\n";

  std::string
  gmsh(const std::string &nodes, const std::string &cells)
  {
    return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" + nodes +
           "$EndNodes\n$Elements\n" + cells + "$EndElements\n";
  }

  template <int dim>
  std::string
  text()
  {
    return dim == 2 ? gmsh(nodes_2d, cells_2d) : gmsh(nodes_3d, cells_3d);
  }

  template <int dim>
  void
  read(const std::string  &text,
       Triangulation<dim> &triangulation,
       const std::string  &cut = "true")
  {
    auto                     geometry = all_geometries<dim>().make("mesh file");
    dealii::ParameterHandler prm;
    geometry->add_parameters(prm);
    prm.set("File name", written(text));
    prm.set("Cut simplices", cut);
    geometry->create(triangulation);
  }

  template <int dim>
  std::string
  refusal(const std::string &text, const std::string &cut)
  {
    Triangulation<dim> triangulation;
    try
    {
      read<dim>(text, triangulation, cut);
    }
    catch (const InputError &error)
    {
      return error.what();
    }
    return "";
  }

  // Solves laplace u = 0 with the values of an affine function at the boundary
  // and returns how far the gradient is from that of the function, at most.
  template <int dim>
  double
  error_of_patch(const Triangulation<dim> &triangulation)
  {
    const dealii::FE_Q<dim> element(1);
    dealii::DoFHandler<dim> dofs(triangulation);
    dealii::Tensor<1, dim>  slope;
    for (unsigned int d = 0; d < dim; ++d)
      slope[d] = 1. + 2. * d;
    dofs.distribute_dofs(element);
    dealii::AffineConstraints<double>                   constraints;
    const dealii::ScalarFunctionFromFunctionObject<dim> affine(
      [&](const dealii::Point<dim> &p) { return 0.5 + slope * p; });
    for (const auto id : triangulation.get_boundary_ids())
      dealii::VectorTools::interpolate_boundary_values(
        dofs, id, affine, constraints);
    constraints.close();
    dealii::DynamicSparsityPattern pattern(dofs.n_dofs());
    dealii::DoFTools::make_sparsity_pattern(dofs, pattern, constraints);
    dealii::SparsityPattern sparsity;
    sparsity.copy_from(pattern);
    dealii::SparseMatrix<double> matrix(sparsity);
    dealii::Vector<double>       right(dofs.n_dofs()), u(dofs.n_dofs());
    const dealii::QGauss<dim>    points(3);
    dealii::MatrixCreator::create_laplace_matrix(
      dofs,
      points,
      matrix,
      dealii::Functions::ZeroFunction<dim>(),
      right,
      static_cast<const dealii::Function<dim> *>(nullptr),
      constraints);
    dealii::SparseDirectUMFPACK solver;
    solver.initialize(matrix);
    solver.vmult(u, right);
    constraints.distribute(u);
    dealii::FEValues<dim> values(element, points, dealii::update_gradients);
    std::vector<dealii::Tensor<1, dim>> gradients(points.size());
    double                              largest = 0.;
    for (const auto &cell : dofs.active_cell_iterators())
    {
      values.reinit(cell);
      values.get_function_gradients(u, gradients);
      for (const auto &gradient : gradients)
        largest = std::max(largest, (gradient - slope).norm());
    }
    return largest;
  }

  template <int dim>
  double
  measure_of_boundary(const Triangulation<dim>       &triangulation,
                      const MixedCracks::BoundaryIds &ids)
  {
    double measure = 0.;
    for (const auto &face : triangulation.active_face_iterators())
      if (face->at_boundary() && ids.contains(face->boundary_id()))
        measure += face->measure();
    return measure;
  }
} // namespace



TEST(MeshCut, TrianglesAndQuadrilaterals)
{
  Triangulation<2> mesh;
  read<2>(text<2>(), mesh);
  EXPECT_EQ(mesh.n_active_cells(), 4u * 3u + 4u);
  EXPECT_NEAR(dealii::GridTools::volume(mesh), 6., 1e-13);
  EXPECT_NEAR(measure_of_boundary(mesh, 1), 2., 1e-13);
  EXPECT_NEAR(measure_of_boundary(mesh, 2), 2., 1e-13);
  double area_of_8 = 0.;
  for (const auto &cell : mesh.active_cell_iterators())
    if (cell->material_id() == 8)
      area_of_8 += cell->measure();
  EXPECT_NEAR(area_of_8, 2., 1e-13);
  EXPECT_LT(error_of_patch(mesh), 1e-12);
  mesh.refine_global(1);
  EXPECT_LT(error_of_patch(mesh), 1e-12);
}



TEST(MeshCut, TetrahedraAndPrisms)
{
  Triangulation<3> mesh;
  read<3>(text<3>(), mesh);
  EXPECT_EQ(mesh.n_active_cells(), 6u * 4u + 6u);
  EXPECT_NEAR(dealii::GridTools::volume(mesh), 1.5, 1e-13);
  EXPECT_NEAR(measure_of_boundary(mesh, 1), 1., 1e-13);
  EXPECT_LT(error_of_patch(mesh), 1e-12);
  mesh.refine_global(1);
  EXPECT_NEAR(dealii::GridTools::volume(mesh), 1.5, 1e-13);
  EXPECT_LT(error_of_patch(mesh), 1e-12);
}



TEST(MeshCut, QuadrilateralsAloneStayWhole)
{
  Triangulation<2> mesh;
  read<2>(
    gmsh("4\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n", "1\n1 3 2 1 1 1 2 3 4\n"),
    mesh);
  EXPECT_EQ(mesh.n_active_cells(), 1u);
}



TEST(MeshCut, SetsOfNodesGoToThePieces)
{
  const std::string triangles =
    "*NODE\n1, 0, 0\n2, 1, 0\n3, 1, 1\n4, 0, 1\n*ELEMENT, TYPE=CPS3\n"
    "1, 1, 2, 3\n2, 1, 3, 4\n*NSET, NSET=low\n1, 2\n*NSET, NSET=diagonal\n"
    "1, 3\n*SURFACE, NAME=SS3\n2, S2\n";
  auto                     geometry = all_geometries<2>().make("mesh file");
  dealii::ParameterHandler prm;
  geometry->add_parameters(prm);
  prm.set("File name", written(triangles));
  prm.set("Cut simplices", "true");
  prm.set("Boundary names", "low = bottom ; SS3 = top");
  Triangulation<2> mesh;
  geometry->create(mesh);
  EXPECT_EQ(mesh.n_active_cells(), 6u);
  const auto ids = geometry->boundary_ids();
  EXPECT_NEAR(measure_of_boundary(mesh, ids.at("bottom")), 1., 1e-13);
  EXPECT_NEAR(measure_of_boundary(mesh, ids.at("top")), 1., 1e-13);
  EXPECT_NE(geometry->about_mesh().find("cut"), std::string::npos);
}



TEST(MeshCut, SecondOrderCountsByItsCorners)
{
  const std::string six_nodes =
    "6\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0.5 0 0\n5 0.6 0.6 0\n6 0 0.5 0\n";
  Triangulation<2> mesh;
  read<2>(gmsh(six_nodes, "2\n1 8 2 4 1 1 2 4\n2 9 2 7 1 1 2 3 4 5 6\n"), mesh);
  EXPECT_EQ(mesh.n_active_cells(), 3u);
  EXPECT_NEAR(dealii::GridTools::volume(mesh), 0.5, 1e-14);
  EXPECT_NEAR(measure_of_boundary(mesh, 4), 1., 1e-14);
}



TEST(MeshCut, Refusals)
{
  const auto expect_in = [](const std::string &part, const std::string &whole) {
    EXPECT_NE(whole.find(part), std::string::npos) << part << ": " << whole;
  };
  expect_in("Geometry/Mesh file/Cut simplices = true",
            refusal<2>(text<2>(), "false"));
  expect_in("triangles (element 11)", refusal<2>(text<2>(), "false"));
  expect_in("tetrahedra (element 11)", refusal<3>(text<3>(), "false"));
  const std::string twice = "2\n11 2 2 7 1 1 2 5\n12 2 2 8 1 2 5 1\n";
  expect_in("lists a cell twice, as the elements 11 and 12, with the materials "
            "7 and 8",
            refusal<2>(gmsh(nodes_2d, twice), "true"));
  expect_in(
    "element 11 has a corner of 180 degrees",
    refusal<2>(gmsh("3\n1 0 0 0\n2 1 0 0\n3 2 0 0\n", "1\n11 2 2 7 1 2 1 3\n"),
               "true"));
  expect_in("pyramids (element 4), which cannot be cut",
            refusal<3>(gmsh(nodes_3d, "1\n4 7 2 1 1 1 2 3 4 5\n"), "true"));
  expect_in("type 26",
            refusal<2>(gmsh(nodes_2d, "1\n4 26 2 1 1 1 2 3 4\n"), "true"));
}



TEST(MeshCut, QualityOfCells)
{
  // one quadrilateral with the angles 60 and 120 degrees
  const std::string rhombus =
    "4\n1 0 0 0\n2 1 0 0\n3 1.5 0.866025403784438647 0\n"
    "4 0.5 0.866025403784438647 0\n";
  Triangulation<2> mesh;
  read<2>(gmsh(rhombus, "1\n1 3 2 1 1 1 2 3 4\n"), mesh);
  const auto quality = quality_of_coarse_mesh(mesh);
  EXPECT_NEAR(quality.smallest, std::sqrt(0.75), 1e-14);
  EXPECT_EQ(quality.n_cells, 1u);
  EXPECT_EQ(quality.n_distorted, 0u);
  EXPECT_NEAR(quality.place[0], 0.75, 1e-14);
}
