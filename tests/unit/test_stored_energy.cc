// SPDX-License-Identifier: GPL-2.0-or-later
// The elastic energy of a state whose equilibrium was found with another phase
// field: that of its displacements and of its own phase field. An even state
// in a box, energies by hand.
#include "materials.h"

#include <assembly/assembler.h>

#include <deal.II/distributed/tria.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/numerics/vector_tools.h>

#include <gtest/gtest.h>

#include <memory>

using namespace MixedCracks;
using namespace MixedCracks::Testing;

namespace
{
  using dealii::Point;

  constexpr double kappa = 1e-3, relaxation = 0.7; // those of description()
  constexpr double lagged = 0.8, present = 0.3;    // phase fields
  constexpr double size = 2.;                      // mm

  double
  degradation(const double phi)
  {
    return (1. - kappa) * phi * phi + kappa;
  }

  // the volumetric stiffness at a point (MPa), as doc/model.md has it
  double
  bulk(const std::string &law, const double g)
  {
    if (law == "relaxed bulk")
      return 1. / (1. / lambda + (1. - g) / (g * relaxation * mu));
    return law == "degraded divergence" ? g * g * lambda : g * lambda;
  }

  // the pressure that its constraint gives at a volume change of 1
  double
  pressure(const std::string &law, const double g)
  {
    if (law == "relaxed bulk")
      return bulk(law, g);
    return law == "degraded divergence" ? g * lambda : lambda;
  }

  // a box with an even strain, and the pressure of the lagged phase field
  template <int dim>
  class EvenBox
  {
  public:
    EvenBox(const std::string &law, const bool mixed)
      : material(description("none", law, 3))
      , mesh(MPI_COMM_WORLD)
      , fields(mesh, {mixed, mixed ? 2u : 1u})
    {
      dealii::GridGenerator::subdivided_hyper_cube(mesh, 2, 0., size);
      fields.distribute();
      assembler = std::make_unique<Assembler<dim>>(fields, material);
      assembler->reinit();
      std::vector<std::function<double(const Point<dim> &)>> values;
      for (unsigned int d = 0; d < dim; ++d)
        values.push_back(
          [d](const Point<dim> &x) { return stretch(d) * x[d]; });
      if (mixed)
        values.push_back([&](const Point<dim> &) {
          return pressure(law, degradation(lagged)) * volume_change();
        });
      LinearAlgebra::Vector owned = fields.owned_vector(fields.elastic_dofs);
      dealii::VectorTools::interpolate(
        fields.mapping,
        fields.elastic,
        dealii::FunctionFromFunctionObjects<dim>(values),
        owned);
      elastic = fields.ghosted_vector(fields.elastic_dofs);
      elastic = owned;
    }

    static double
    stretch(const unsigned int d)
    {
      return d == 0 ? 0.03 : -0.01;
    }

    static double
    volume_change()
    {
      return 0.03 - 0.01 * (dim - 1);
    }

    // of the whole body; mJ, in 2-d per mm of thickness
    static double
    by_hand(const std::string &law, const double g)
    {
      const double square = 0.03 * 0.03 + 0.01 * 0.01 * (dim - 1);
      return std::pow(size, dim) *
             (g * mu * square +
              0.5 * bulk(law, g) * volume_change() * volume_change());
    }

    LinearAlgebra::Vector
    even(const double phi) const
    {
      LinearAlgebra::Vector owned =
        fields.owned_vector(fields.phase_field_dofs);
      owned = phi;
      LinearAlgebra::Vector result =
        fields.ghosted_vector(fields.phase_field_dofs);
      result = owned;
      return result;
    }

    const Material<dim>                               material;
    dealii::parallel::distributed::Triangulation<dim> mesh;
    Fields<dim>                                       fields;
    std::unique_ptr<Assembler<dim>>                   assembler;
    LinearAlgebra::Vector                             elastic;
  };

  template <typename Dimension>
  class StoredEnergy : public ::testing::Test
  {};

  TYPED_TEST_SUITE(StoredEnergy, Dimensions);
} // namespace



TYPED_TEST(StoredEnergy, IsThatOfThePhaseFieldOfTheStep)
{
  constexpr int dim = TypeParam::value;
  for (const std::string &law : all_pressure_laws().names())
    for (const bool mixed : {true, false})
    {
      SCOPED_TRACE(law + (mixed ? ", mixed" : ", displacement"));
      EvenBox<dim> box(law, mixed);
      for (const double phi : {present, lagged, 0., 1.})
        EXPECT_NEAR(
          box.assembler->energies(box.elastic, box.even(lagged), box.even(phi))
            .elastic,
          box.by_hand(law, degradation(phi)),
          1e-12 * box.by_hand(law, 1.));
    }
}



TYPED_TEST(StoredEnergy, FieldsAddUpToItWhileStressesAreThoseOfEquilibrium)
{
  constexpr int dim = TypeParam::value;
  for (const std::string &law : all_pressure_laws().names())
  {
    SCOPED_TRACE(law);
    EvenBox<dim> box(law, true);
    const auto   data =
      box.assembler->cell_data(box.elastic, box.even(lagged), box.even(present))
        .values;
    const double g = degradation(lagged);
    for (const auto &cell : box.mesh.active_cell_iterators())
      if (cell->is_locally_owned())
      {
        const unsigned int i = cell->active_cell_index();
        EXPECT_NEAR(data.at("strain_energy_density")(i),
                    box.by_hand(law, degradation(present)) /
                      std::pow(size, dim),
                    1e-6);
        EXPECT_NEAR(data.at("stress_xx")(i),
                    g * 2. * mu * box.stretch(0) +
                      bulk(law, g) * box.volume_change(),
                    1e-6);
      }
  }
}
