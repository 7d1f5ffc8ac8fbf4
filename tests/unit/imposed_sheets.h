// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_tests_unit_imposed_sheets_h
#define mixed_cracks_tests_unit_imposed_sheets_h

#include <cracks/crack_observer.h>

#include <deal.II/base/function.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/numerics/vector_tools.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

namespace MixedCracks
{
  namespace Testing
  {
    using dealii::Point;
    using dealii::Tensor;
    using Distance = std::function<double(const Point<3> &)>;

    /// phi at a distance of x l from a crack, the optimal profiles of the three
    /// densities.
    inline double
    profile(const std::string &density, const double x)
    {
      if (density == "AT1")
        return x < 2. ? 1. - (1. - x / 2.) * (1. - x / 2.) : 1.;
      if (density == "AT2")
        return 1. - std::exp(-x);
      return x < 0.5 * M_PI ? std::sin(x) : 1.;
    }

    /// Where it is 0.5, in l.
    inline double
    distance_of_half(const std::string &density)
    {
      return density == "AT1"   ? 2. - std::sqrt(2.)
             : density == "AT2" ? std::log(2.)
                                : std::asin(0.5);
    }

    /// A box from (0, 0, 0) with sides that have the names of a box, and a
    /// phase field that is the profile of a distance.
    struct ImposedSheet
    {
      ImposedSheet(const std::array<double, 3>                 &lengths,
                   const double                                 h,
                   const double                                 length_scale,
                   const std::string                           &density,
                   const Distance                              &distance,
                   const std::function<bool(const Point<3> &)> &is_fine = {})
        : l(length_scale)
        , mesh(MPI_COMM_WORLD)
        , fields(mesh, {false, 1})
        , observer(fields, names())
      {
        std::vector<unsigned int> cells;
        Point<3>                  upper;
        for (unsigned int d = 0; d < 3; ++d)
        {
          upper[d] = lengths[d];
          cells.push_back(std::lround(lengths[d] / h));
        }
        dealii::GridGenerator::subdivided_hyper_rectangle(
          mesh, cells, Point<3>(), upper, /*colorize=*/true);
        if (is_fine)
        {
          for (const auto &cell : mesh.active_cell_iterators())
            if (cell->is_locally_owned() && is_fine(cell->center()))
              cell->set_refine_flag();
          mesh.execute_coarsening_and_refinement();
        }
        fields.distribute();
        impose(density, distance);
        state.damage_origins.reach = 3. * l;
        observer.reinit(l, distance_of_half(density));
      }

      void
      impose(const std::string &density, const Distance &distance)
      {
        LinearAlgebra::Vector owned =
          fields.owned_vector(fields.phase_field_dofs);
        dealii::VectorTools::interpolate(
          fields.mapping,
          fields.phase_field,
          dealii::ScalarFunctionFromFunctionObject<3>([&](const Point<3> &x) {
            return profile(density, distance(x) / l);
          }),
          owned);
        state.phase_field = fields.ghosted_vector(fields.phase_field_dofs);
        state.phase_field = owned;
      }

      static std::map<dealii::types::boundary_id, std::string>
      names()
      {
        return {{0, "left"},
                {1, "right"},
                {2, "bottom"},
                {3, "top"},
                {4, "back"},
                {5, "front"}};
      }

      TracedCracks
      trace() const
      {
        return observer.trace(state);
      }

      const double                                    l;
      dealii::parallel::distributed::Triangulation<3> mesh;
      Fields<3>                                       fields;
      State                                           state;
      CrackObserver<3>                                observer;
    };

    inline bool
    is_first_rank()
    {
      return dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
    }

    /// The largest distance of the vertices of a sheet.
    inline double
    largest_distance(const CrackSheet &sheet, const Distance &distance)
    {
      double largest = 0.;
      for (const Point<3> &vertex : sheet.vertices)
        largest = std::max(largest, std::abs(distance(vertex)));
      return largest;
    }
  } // namespace Testing
} // namespace MixedCracks

#endif
