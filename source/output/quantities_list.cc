// SPDX-License-Identifier: GPL-2.0-or-later
// The list of quantities: to add one, add an entry. Integrals over the mesh
// become those of the body by the thickness t (1 in 3-d):
//
//   elastic_energy    t integral of psi(eps, phi)                          mJ
//   crack_energy      t integral of G_c gamma(phi, grad phi), (M1)         mJ
//   external_work     sum of t/2 (f_(n-1) + f_n) . (u_n - u_(n-1)) over steps,
//                     f loads and reactions, + work of a fluid             mJ
//   energy_imbalance  external_work - growth of the two others since step 0
//   crack_length      integral of gamma: 1 per mm of crack, whatever G_c   mm
//   crack_volume      t integral of u . grad phi                           mm^3
//   mean_stress_ij    integral of P_ij over the volume of a periodic cell  MPa
//
// phi is that of the step, not the lagged one, but for forces, which balance
// with the phi~ they were solved with. Columns keep their order: what is new
// goes last.

#include <deal.II/base/mpi.h>

#include <output/crack_opening.h>
#include <output/quantities.h>

#include <algorithm>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    using Format     = Quantity::Format;
    using InSummary  = Quantity::InSummary;
    using Derivation = Quantity::Derivation;

    template <int dim>
    double
    component(const Tensor<1, dim> &vector, const unsigned int d)
    {
      return d < dim ? vector[d] : 0.;
    }

    template <int dim>
    double
    smallest_phase_field(const Measurement<dim> &step)
    {
      double smallest = 1.;
      for (const auto dof : step.fields.phase_field_dofs.owned)
        smallest = std::min(smallest, double(step.state.phase_field(dof)));
      return Utilities::MPI::min(smallest, step.fields.communicator());
    }

    const char *const periodic = "Geometry/Periodic sides";
    const char *const finite_periodic =
      "Geometry/Periodic sides and Model/Strains = finite";

    // components of a plane body are asked for in 3-d only where it has them
    template <int dim>
    double
    component(const Tensor<2, dim> &tensor,
              const unsigned int    i,
              const unsigned int    j)
    {
      return i < dim && j < dim ? tensor[i][j] : 0.;
    }

    // @p letters: component and normal, as "xy"
    Quantity
    mean_stress(const std::string &letters, const std::string &sentence)
    {
      const unsigned int i = letters[0] - 'x', j = letters[1] - 'x';
      return Quantity("mean_stress_" + letters,
                      "MPa",
                      sentence,
                      [i, j](const auto &step) {
                        return component(step.mean_stress, i, j);
                      })
        .only_with(periodic);
    }
  } // namespace



  const std::vector<Quantity> &
  all_quantities()
  {
    static const std::vector<Quantity> list = {
      Quantity("step",
               "",
               "number of the accepted step",
               [](const auto &step) { return step.step; })
        .written_as(Format::count),
      Quantity(
        "time", "s", "time", [](const auto &step) { return step.state.time; }),
      Quantity("displacement",
               "mm",
               "mean prescribed displacement magnitude of the boundary or "
               "point that is moved most; of periodic sides, of one against "
               "the other",
               [](const auto &step) { return step.displacement; }),
      Quantity("force_x",
               "N",
               "reaction on `Load stepping/Force boundary`, or what acts "
               "through it where it is a periodic side, positive in "
               "tension, of the whole body: in 2-d with thickness. On a "
               "boundary whose outward normal points against its axis "
               "(left, bottom) all components have the opposite sign of "
               "what acts on the body there, so that opposite boundaries "
               "in balance show the same force. Where displacement is "
               "prescribed at points only (and `Force "
               "boundary` is empty): the sum of the reactions at the "
               "points that move, or at all points where none does, as "
               "they act on the body, in the directions of the axes: a "
               "load that presses down has a negative y",
               [](const auto &step) { return component(step.force, 0); }),
      Quantity("force_y",
               "N",
               "likewise",
               [](const auto &step) { return component(step.force, 1); }),
      Quantity("force_z",
               "N",
               "likewise",
               [](const auto &step) { return component(step.force, 2); })
        .only_in_3d(),
      Quantity("elastic_energy",
               "mJ",
               "stored elastic energy of the whole body, degraded by the "
               "φ of the step",
               [](const auto &step) {
                 return step.thickness * step.energies.elastic;
               }),
      Quantity(
        "crack_energy",
        "mJ",
        "G_c ∫ γ dx, of the whole body; that of notch and initial "
        "cracks is included",
        [](const auto &step) { return step.thickness * step.energies.crack; }),
      Quantity("external_work",
               "mJ",
               "work of the reactions, of loads, of the mean strain of "
               "periodic sides, and of a fluid in the "
               "cracks since the start; loads that are there at t = 0 "
               "have done none then",
               [](const auto &step) { return step.external_work; }),
      Quantity("min_phase_field",
               "",
               "smallest φ; 0 from the start where there is a notch",
               [](const auto &step) { return smallest_phase_field(step); }),
      Quantity("max_phase_field_change",
               "",
               "largest decrease of φ in the step",
               [](const auto &step) { return step.effort.phase_field_change; }),
      Quantity("newton_iterations",
               "",
               "of the elastic fields, summed over the step",
               [](const auto &step) { return step.effort.newton_iterations; })
        .written_as(Format::count)
        .in_summary_as(InSummary::total),
      Quantity("linear_iterations",
               "",
               "of an iterative linear solver; 0 with a direct one",
               [](const auto &step) { return step.effort.linear_iterations; })
        .written_as(Format::count),
      Quantity("active_set_size",
               "",
               "phase-field nodes at one of their two bounds at the end "
               "of the step",
               [](const auto &step) { return step.effort.active_set_size; })
        .written_as(Format::count),
      Quantity("cells",
               "",
               "of the mesh in that step",
               [](const auto &step) {
                 return step.fields.elastic.get_triangulation()
                   .n_global_active_cells();
               })
        .written_as(Format::count)
        .in_summary_as(InSummary::size),
      Quantity("dofs",
               "",
               "of the mesh in that step",
               [](const auto &step) { return step.fields.n_dofs(); })
        .written_as(Format::count)
        .in_summary_as(InSummary::size),
      Quantity("wall_time",
               "s",
               "spent on the run so far, in all its pieces",
               [](const auto &step) { return step.totals.wall_time; })
        .written_as(Format::cost),
      Quantity("coupling_iterations",
               "",
               "how often (M9) was repeated; 1 unless the coupling is "
               "iterated, but for step 0, which always is",
               [](const auto &step) { return step.effort.coupling_iterations; })
        .written_as(Format::count)
        .in_summary_as(InSummary::total),
      Quantity("coupling_change",
               "",
               "last max abs(φ − φ̃): how far the equations were solved "
               "with another phase field than their own",
               [](const auto &step) { return step.effort.coupling_change; })
        .written_as(Format::cost),
      Quantity("factorizations",
               "",
               "of the matrix of the elastic fields, so far",
               [](const auto &step) { return step.totals.factorizations; })
        .written_as(Format::count),
      Quantity("rejected_steps",
               "",
               "tried and given up, so far",
               [](const auto &step) { return step.totals.rejected_steps; })
        .written_as(Format::count),
      Quantity("refinements",
               "",
               "changes of the mesh until here",
               [](const auto &step) { return step.n_refinements; })
        .written_as(Format::count),
      Quantity(
        "energy_imbalance",
        "mJ",
        "external work less the growth of stored and crack energy "
        "since the start",
        Derivation([](const StatisticsRow &row, const StatisticsRow &first) {
          return row.energy_imbalance(first);
        })),
      Quantity("crack_length",
               "mm",
               "∫ γ dx, how large the cracks are: notches with φ = 0, "
               "initial cracks and, with AT2, the little damage "
               "everywhere included; not times the thickness. On linear "
               "elements a crack of unit size has 1 + O(h/ℓ)",
               [](const auto &step) { return step.energies.crack_surface; })
        .called_in_3d("crack_area", "mm2")
        .in_summary_as(InSummary::result),
      Quantity("crack_volume",
               "mm3",
               "∫ u·∇φ dx times the thickness, the volume between the "
               "faces of all cracks",
               [](const auto &step) {
                 return step.thickness * crack_volume(step.fields,
                                                      step.state.elastic,
                                                      step.state.phase_field);
               })
        .only_with("Output/Crack volume")
        .in_summary_as(InSummary::result),
      Quantity(
        "min_jacobian",
        "",
        "smallest det F over the quadrature points, in plane stress that "
        "of the plane, det of the two by two part; cells turn inside out "
        "at 0. Of damaged material det(I + gamma grad u), 1 where it is "
        "broken (doc/model.md, section 8)",
        [](const auto &step) { return step.energies.smallest_jacobian; })
        .only_with("Model/Strains = finite")
        .in_summary_as(InSummary::result),
      mean_stress(
        "xx",
        "mean stress of the periodic cell, ∫ σ dx over the volume of the cell, "
        "that of holes included; at finite strain of the first "
        "Piola-Kirchhoff stress, the first letter the component, the second "
        "the normal. In a direction without periodic sides the cell is as wide "
        "as the body"),
      mean_stress("xy", "likewise"),
      mean_stress("xz", "likewise").only_in_3d(),
      mean_stress("yx", "likewise; at small strain that of xy")
        .only_with(finite_periodic),
      mean_stress("yy", "likewise"),
      mean_stress("yz", "likewise").only_in_3d(),
      mean_stress("zx", "likewise").only_with(finite_periodic).only_in_3d(),
      mean_stress("zy", "likewise").only_with(finite_periodic).only_in_3d(),
      mean_stress("zz", "likewise").only_in_3d()};
    return list;
  }
} // namespace MixedCracks
