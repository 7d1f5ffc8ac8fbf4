// SPDX-License-Identifier: GPL-2.0-or-later
// Constants of the material that vary, as the loops over the cells see them:
// three ways to describe one body, residuals against differences of energies,
// and the crack energy of a given phase field.
#include "materials.h"

#include <assembly/assembler.h>

#include <deal.II/base/function_lib.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/numerics/vector_tools.h>

#include <discretization/constraints.h>

#include <simulation/simulation_material.h>

#include <gtest/gtest.h>

#include <fstream>

using namespace MixedCracks;
using namespace MixedCracks::Testing;

namespace
{
  constexpr int dim = 2;
  using dealii::Point;
  using Vector = LinearAlgebra::Vector;

  // The unit square with refined cells in a corner; the right half has the
  // material id 7
  class HalvedSquare : public ::testing::Test
  {
  protected:
    HalvedSquare()
      : triangulation(MPI_COMM_WORLD)
      , fields(triangulation, {false, 1})
      , constraints(fields, {})
      , material(without_constants())
    {
      dealii::Triangulation<dim> coarse;
      dealii::GridGenerator::subdivided_hyper_cube(coarse, 4);
      for (const auto &cell : coarse.active_cell_iterators())
        cell->set_material_id(cell->center()[0] > 0.5 ? 7 : 0);
      triangulation.copy_triangulation(coarse);
      for (const auto &cell : triangulation.active_cell_iterators())
        if (cell->is_locally_owned() && cell->center().norm() < 0.5)
          cell->set_refine_flag();
      triangulation.execute_coarsening_and_refinement();
      fields.distribute();
      constraints.reinit();
      parameters.youngs_modulus = "200";
      parameters.poisson_ratio  = "0.25";
      model.kinematics          = "plane strain";
    }

    // as describe_material() has it
    static MaterialDescription
    without_constants()
    {
      MaterialDescription result = description("none", "degraded bulk", 3);
      result.constants.reset();
      return result;
    }

    std::unique_ptr<Assembler<dim>>
    make_assembler() const
    {
      auto result = std::make_unique<Assembler<dim>>(
        fields,
        material,
        constants_function(model,
                           make_material_field(parameters, triangulation)));
      result->reinit();
      return result;
    }

    Vector
    interpolated(const dealii::DoFHandler<dim>           &handler,
                 const DofSets                           &dofs,
                 const dealii::AffineConstraints<double> &hanging,
                 const dealii::Function<dim>             &function) const
    {
      Vector owned = fields.owned_vector(dofs);
      dealii::VectorTools::interpolate(
        fields.mapping, handler, function, owned);
      hanging.distribute(owned);
      Vector result = fields.ghosted_vector(dofs);
      result        = owned;
      return result;
    }

    Vector
    displacement(const double phase) const
    {
      return interpolated(fields.elastic,
                          fields.elastic_dofs,
                          constraints.elastic_hanging_nodes(),
                          dealii::FunctionFromFunctionObjects<dim>(
                            {[phase](const Point<dim> &x) {
                               return std::sin(3. * x[0] + x[1] + phase);
                             },
                             [phase](const Point<dim> &x) {
                               return x[0] * x[1] * x[1] + phase * x[0];
                             }}));
    }

    Vector
    phase_field(const double phase) const
    {
      return interpolated(fields.phase_field,
                          fields.phase_field_dofs,
                          constraints.phase_field_hanging_nodes(),
                          dealii::ScalarFunctionFromFunctionObject<dim>(
                            [phase](const Point<dim> &x) {
                              return 0.5 +
                                     0.4 * std::sin(5. * x[0] * x[1] + phase);
                            }));
    }

    Vector
    owned(const Vector &ghosted, const DofSets &dofs) const
    {
      Vector result = fields.owned_vector(dofs);
      result        = ghosted;
      return result;
    }

    // start + step * direction, with ghosts
    Vector
    moved(const Vector  &start,
          const Vector  &direction,
          const double   step,
          const DofSets &dofs) const
    {
      Vector sum = owned(start, dofs);
      sum.add(step, owned(direction, dofs));
      Vector result = fields.ghosted_vector(dofs);
      result        = sum;
      return result;
    }

    Vector
    elastic_residual(Assembler<dim> &assembler) const
    {
      Vector residual = fields.owned_vector(fields.elastic_dofs);
      assembler.elastic_residual(displacement(0.),
                                 phase_field(0.),
                                 constraints.elastic_hanging_nodes(),
                                 residual);
      return residual;
    }

    Vector
    phase_field_residual(Assembler<dim> &assembler) const
    {
      Vector residual = fields.owned_vector(fields.phase_field_dofs);
      assembler.phase_field_system(phase_field(0.),
                                   assembler.driving_force(),
                                   constraints.phase_field_hanging_nodes(),
                                   residual,
                                   nullptr);
      return residual;
    }

    // elastic and phase-field residuals, one after the other
    std::vector<Vector>
    residuals() const
    {
      const auto          assembler = make_assembler();
      std::vector<Vector> result;
      result.push_back(elastic_residual(*assembler));
      result.push_back(phase_field_residual(*assembler));
      return result;
    }

    dealii::parallel::distributed::Triangulation<dim> triangulation;
    Fields<dim>                                       fields;
    Constraints<dim>                                  constraints;
    const Material<dim>                               material;
    MaterialParameters                                parameters;
    ModelParameters                                   model;
  };

  void
  expect_equal(const std::vector<Vector> &a, const std::vector<Vector> &b)
  {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i)
    {
      Vector difference(a[i]);
      difference.add(-1., b[i]);
      EXPECT_GT(a[i].linfty_norm(), 0.1);
      EXPECT_LT(difference.linfty_norm(), 1e-13 * a[i].linfty_norm());
    }
  }

  // One file for all ranks, as the first one reads it
  std::string
  written(const std::string &name, const std::string &text)
  {
    const std::string path = ::testing::TempDir() + name;
    if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      std::ofstream(path, std::ios::binary) << text;
    return path;
  }
} // namespace



TEST_F(HalvedSquare, ExpressionMaterialIdAndMapsDescribeOneBody)
{
  parameters.youngs_modulus               = "if(x > 0.5, 700, 200)";
  parameters.critical_energy_release_rate = "if(x > 0.5, 5, 1)";
  const std::vector<Vector> expected      = residuals();

  parameters.youngs_modulus               = "200";
  parameters.critical_energy_release_rate = "1";
  parameters.by_material_id =
    "7 : Young's modulus = 700, Critical energy release rate = 5";
  expect_equal(residuals(), expected);

  // black on the left, white on the right
  parameters.by_material_id               = "";
  parameters.youngs_modulus               = "200 + 500*map";
  parameters.critical_energy_release_rate = "1 + 4*map";
  parameters.map.file_name =
    written("mixed_cracks_halves.pgm", "P2 2 1 255\n0 255\n");
  expect_equal(residuals(), expected);

  parameters.youngs_modulus               = "map";
  parameters.critical_energy_release_rate = "if(map > 300, 5, 1)";
  parameters.map.file_name =
    written("mixed_cracks_halves.csv", "x,y,E\n0.25,0,200\n0.75,0,700\n");
  expect_equal(residuals(), expected);
}



TEST_F(HalvedSquare, APictureIsNotUpsideDown)
{
  parameters.critical_energy_release_rate = "if(y > 0.5, 5, 1)";
  const std::vector<Vector> expected      = residuals();
  parameters.critical_energy_release_rate = "1 + 4*map";
  parameters.map.file_name =
    written("mixed_cracks_upright.pgm", "P2 1 2 255\n255\n0\n");
  expect_equal(residuals(), expected);
}



TEST_F(HalvedSquare, ElasticResidualIsTheDerivativeOfTheEnergy)
{
  parameters.youngs_modulus = "200*(1 + x*x + 3*y)";
  parameters.poisson_ratio  = "0.1 + 0.3*y";
  for (const std::string kinematics : {"plane strain", "plane stress"})
  {
    model.kinematics      = kinematics;
    const auto     matter = make_assembler();
    const DofSets &dofs   = fields.elastic_dofs;
    const Vector   state = displacement(0.), direction = displacement(1.);
    const Vector   phi  = phase_field(0.);
    const double   step = 1e-3; // the energy is quadratic
    const double   expected =
      (matter->energies(moved(state, direction, step, dofs), phi, phi).elastic -
       matter->energies(moved(state, direction, -step, dofs), phi, phi)
         .elastic) /
      (2. * step);
    Vector along = owned(direction, dofs);
    constraints.elastic_hanging_nodes().set_zero(along);
    EXPECT_GT(std::abs(expected), 1.);
    EXPECT_NEAR(
      elastic_residual(*matter) * along, expected, 1e-9 * std::abs(expected));
  }
}



TEST_F(HalvedSquare, PhaseFieldResidualIsTheDerivativeOfTheCrackEnergy)
{
  parameters.critical_energy_release_rate = "1 + x + 2*y*y";
  const auto     matter                   = make_assembler();
  const DofSets &dofs                     = fields.phase_field_dofs;
  const Vector   rest  = fields.ghosted_vector(fields.elastic_dofs);
  const Vector   state = phase_field(0.), direction = phase_field(1.);
  // at rest nothing drives the crack
  Vector residual = fields.owned_vector(fields.elastic_dofs);
  matter->elastic_residual(
    rest, state, constraints.elastic_hanging_nodes(), residual);
  const double step = 1e-3; // the energy is quadratic
  const double expected =
    (matter->energies(rest, state, moved(state, direction, step, dofs)).crack -
     matter->energies(rest, state, moved(state, direction, -step, dofs))
       .crack) /
    (2. * step);
  Vector along = owned(direction, dofs);
  constraints.phase_field_hanging_nodes().set_zero(along);
  EXPECT_GT(std::abs(expected), 0.01);
  EXPECT_NEAR(
    phase_field_residual(*matter) * along, expected, 1e-9 * std::abs(expected));
}



TEST_F(HalvedSquare, CrackEnergyIsWeightedWithTheToughness)
{
  // phi = 0 everywhere: Wu's density is 1/(pi l) everywhere, and the energy
  // is the integral of G_c over pi l
  parameters.critical_energy_release_rate = "1 + x + 2*y*y";
  const auto   matter                     = make_assembler();
  const Vector rest   = fields.ghosted_vector(fields.elastic_dofs);
  const Vector broken = fields.ghosted_vector(fields.phase_field_dofs);
  EXPECT_NEAR(matter->energies(rest, broken, broken).crack,
              (1. + 1. / 2 + 2. / 3) / (dealii::numbers::PI * 0.3),
              1e-12);
  // so is the scale of the active set, without the density
  Vector sum = fields.owned_vector(fields.phase_field_dofs);
  matter->lumped_release_rate(constraints.phase_field_hanging_nodes(), sum);
  Vector ones(sum);
  ones = 1.;
  EXPECT_NEAR(sum * ones, 1. + 1. / 2 + 2. / 3, 1e-12);
}



TEST_F(HalvedSquare, ConstantsFollowTheMesh)
{
  parameters.critical_energy_release_rate = "if(x < 0.06, 9, 1)";
  const auto   matter                     = make_assembler();
  const Vector rest   = fields.ghosted_vector(fields.elastic_dofs);
  const auto   energy = [&]() {
    const Vector still  = fields.ghosted_vector(fields.elastic_dofs);
    const Vector broken = fields.ghosted_vector(fields.phase_field_dofs);
    return dealii::numbers::PI * 0.3 *
           matter->energies(still, broken, broken).crack;
  };
  const double coarse = energy();
  for (unsigned int i = 0; i < 3; ++i)
  {
    triangulation.refine_global();
    fields.distribute();
    constraints.reinit();
    matter->reinit();
  }
  const double exact = 1. + 8. * 0.06;
  EXPECT_LT(std::abs(energy() - exact), 0.25 * std::abs(coarse - exact));
  EXPECT_LT(std::abs(energy() - exact), 0.02 * exact);
}



TEST_F(HalvedSquare, TheErrorOfOneRankIsThrownByAll)
{
  // negative in the last cell only, which one rank owns
  parameters.critical_energy_release_rate = "if(x + y > 1.85, -1, 1)";
  try
  {
    make_assembler();
    ADD_FAILURE() << "a negative G_c is accepted";
  }
  catch (const InputError &error)
  {
    const std::string message = error.what();
    EXPECT_NE(message.find("Critical energy release rate"), std::string::npos)
      << message;
    EXPECT_NE(message.find("Found at (0.9"), std::string::npos) << message;
  }
}



TEST_F(HalvedSquare, RangesAreThoseOfTheWholeBody)
{
  parameters.youngs_modulus = "if(x > 0.5, 700, 200)";
  const MaterialRange range =
    material_range(make_material_field(parameters, triangulation), fields);
  EXPECT_NEAR(range.mu.smallest, 80., 1e-11);
  EXPECT_NEAR(range.mu.largest, 280., 1e-11);
  EXPECT_NEAR(range.ratio.largest, 1., 1e-12);
  EXPECT_FALSE(range.ratio.varies());
  EXPECT_TRUE(range.lambda.varies());
}
