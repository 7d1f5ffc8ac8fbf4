// SPDX-License-Identifier: GPL-2.0-or-later
// Cracks in space. What is found on the mesh stays with the ranks that have it:
// the ridge of damage is sent to rank 0 as triangles, the parts of the body to
// all as a few numbers.

#include <cracks/crack_observer.h>
#include <cracks/sheet_outcome.h>

#include <deal.II/base/mpi.h>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    using BoundaryNames = std::map<types::boundary_id, std::string>;



    // With the faces f of all holes, sum A_f x_f / sum A_f.
    std::optional<HoleInSpace>
    find_hole(const Fields<3> &fields, const BoundaryNames &names)
    {
      std::optional<HoleInSpace> hole;
      std::vector<double>        sums(4, 0.), all(4);
      for (const auto &[id, name] : names)
        if (role_of_boundary(name) == BoundaryRole::hole)
        {
          hole = HoleInSpace{name, {}};
          for (const auto &cell : fields.phase_field.active_cell_iterators())
            if (cell->is_locally_owned())
              for (const unsigned int f : cell->face_indices())
                if (cell->face(f)->at_boundary() &&
                    cell->face(f)->boundary_id() == id)
                {
                  const double area = cell->face(f)->measure();
                  for (unsigned int d = 0; d < 3; ++d)
                    sums[d] += area * cell->face(f)->center()[d];
                  sums[3] += area;
                }
        }
      Utilities::MPI::sum(sums, fields.communicator(), all);
      if (!(all[3] > 0.))
        return {};
      for (unsigned int d = 0; d < 3; ++d)
        hole->center[d] = all[d] / all[3];
      return hole;
    }
  } // namespace



  TracedCracks
  trace_in_space(const Fields<3>     &fields,
                 const BoundaryNames &names,
                 const double         length_scale,
                 const double         front_lag,
                 const State         &state)
  {
    TracedCracks      traced;
    const DamageRidge ridge =
      damage_ridge(fields, state.phase_field, length_scale);
    if (ridge.cell_size == 0.)
      return traced;
    traced.separate_body = are_separate(
      intact_parts(fields, state.phase_field), names, length_scale);
    CrackSheetOptions options;
    options.length_scale   = length_scale;
    options.tip_lag        = front_lag;
    options.cell_size      = ridge.cell_size;
    options.nuclei         = state.damage_origins.nuclei;
    options.initial        = state.damage_origins.initial;
    options.boundary_names = names;
    const auto hole        = find_hole(fields, names);
    if (Utilities::MPI::this_mpi_process(fields.communicator()) == 0)
    {
      traced.sheets  = trace_sheets(ridge.triangles, options);
      traced.outcome = classify(traced.sheets,
                                traced.separate_body,
                                hole,
                                options.nuclei,
                                length_scale);
    }
    return traced;
  }
} // namespace MixedCracks
