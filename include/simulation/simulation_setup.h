// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_simulation_simulation_setup_h
#define mixed_cracks_simulation_simulation_setup_h

#include <discretization/constraints.h>
#include <discretization/fields.h>
#include <discretization/mesh_estimate.h>
#include <discretization/refinement.h>

#include <simulation/parameters.h>

#include <steps/step.h>
#include <steps/step_elastic.h>
#include <steps/step_phase_field.h>

namespace MixedCracks
{
  // What the .prm says in names and expressions, made into what the rooms
  // below take: ids, functions, nodes.

  /// Where subsection "Mesh" wants finer cells from the start.
  /// @p triangulation: the coarse mesh, or a refined one.
  template <int dim>
  RefinementRegions<dim>
  refined_regions(const Parameters<dim>            &parameters,
                  const dealii::Triangulation<dim> &triangulation);

  /// Periodic sides and the mean strain.
  template <int dim>
  Periodicity<dim> periodicity(const Parameters<dim> &parameters);

  /// Join the periodic sides of a coarse mesh. Throws InputError, on all ranks,
  /// where they are not alike, or the mean strain makes no difference.
  template <int dim>
  void make_periodic(const Parameters<dim>      &parameters,
                     dealii::Triangulation<dim> &triangulation);

  /// From a point to its images in the cells around a periodic body, mm; the
  /// first is 0, and the only one of another body.
  template <int dim>
  std::vector<dealii::Tensor<1, dim>>
  shifts_to_images(const Parameters<dim>            &parameters,
                   const dealii::Triangulation<dim> &triangulation);

  /// The mesh of @p geometry, the chosen one or that with larger cells, with
  /// its periodic sides, not refined. Collective.
  template <int dim>
  void make_coarse_mesh(const Parameters<dim>      &parameters,
                        const Geometry<dim>        &geometry,
                        dealii::Triangulation<dim> &triangulation);

  /// Coarse mesh, refined as subsection "Mesh" says. Collective.
  template <int dim>
  void make_mesh(const Parameters<dim>      &parameters,
                 dealii::Triangulation<dim> &triangulation);

  /// The same for `--check`: a mesh of so many cells that building it takes
  /// long is refined only where the .prm names points, and what it would be is
  /// returned. Where already the coarse mesh has too many, one with larger
  /// cells takes its place. Collective.
  template <int dim>
  std::optional<MeshEstimate>
  make_mesh_to_check(const Parameters<dim>      &parameters,
                     const FieldLayout          &layout,
                     dealii::Triangulation<dim> &triangulation);

  /// Mean size of the cells of the finest level, measure^(1/dim), mm: the h
  /// of expressions. Collective.
  template <int dim>
  double finest_cell_size(const dealii::Triangulation<dim> &triangulation,
                          MPI_Comm                          communicator);

  template <int dim>
  std::vector<PrescribedComponent<dim>>
  prescribed_components(const Parameters<dim> &parameters,
                        unsigned int           n_components);

  /// @p entries with point sets as their points on this mesh.
  /// @p stands_for_finer: the points of the run need not be there
  /// yet, and the nearest do. Throws InputError on all ranks for a set without
  /// a point. Collective where there are sets.
  template <int dim>
  std::vector<PointEntry<dim>>
  placed_points(const Parameters<dim>              &parameters,
                const std::vector<PointEntry<dim>> &entries,
                const dealii::Triangulation<dim>   &triangulation,
                bool                                stands_for_finer = false);

  /// The entries of "Force at points", likewise, with the points that sets have
  /// on the mesh before adaptation.
  template <int dim>
  std::vector<PointEntry<dim>>
  points_with_forces(const Parameters<dim>            &parameters,
                     const dealii::Triangulation<dim> &triangulation,
                     bool stands_for_finer = false);

  /// For Constraints, from "Displacement at points" by placed_points().
  template <int dim>
  std::vector<PrescribedPoint<dim>>
  prescribed_points(const Parameters<dim>            &parameters,
                    unsigned int                      n_components,
                    const dealii::Triangulation<dim> &triangulation,
                    bool                              stands_for_finer = false);

  /// @p triangulation, @p stands_for_finer: see placed_points(). Collective
  /// where there are sets.
  template <int dim>
  Loads<dim> make_loads(const Parameters<dim>            &parameters,
                        unsigned int                      n_components,
                        const dealii::Triangulation<dim> &triangulation,
                        bool stands_for_finer = false);

  /// The fluid in the cracks; null where there is none.
  template <int dim>
  std::shared_ptr<FluidAssembler<dim>>
  make_fluid(const Parameters<dim> &parameters, const Fields<dim> &fields);

  /// 1 everywhere, 0 on slits and initial cracks; without ghosts. Throws
  /// InputError on all ranks, also for a crack that breaks no node. Collective.
  template <int dim>
  LinearAlgebra::Vector
  initial_phase_field(const Parameters<dim>  &parameters,
                      const Fields<dim>      &fields,
                      const Constraints<dim> &constraints);

  /// Evaluate the expressions in it only, for a mesh that is not the one of the
  /// run, whose finest cells are of @p cell_size (mm). Throws InputError on all
  /// ranks. Collective.
  template <int dim>
  void try_initial_phase_field(const Parameters<dim> &parameters,
                               const Fields<dim>     &fields,
                               double                 cell_size);

  /// Evaluate what is applied at t = 0, prescribed values and loads, wherever
  /// the run does. @p stands_for_finer: see placed_points(). Throws InputError
  /// on all ranks for a value that is not finite. Collective.
  template <int dim>
  void try_loads_at_start(const Parameters<dim>  &parameters,
                          const Fields<dim>      &fields,
                          const Constraints<dim> &constraints,
                          bool                    stands_for_finer);

  /// At rest, with the initial phase field.
  template <int dim>
  State undeformed_state(const Parameters<dim>  &parameters,
                         const Fields<dim>      &fields,
                         const Constraints<dim> &constraints);

  /// Where half of the body is within the unbreakable margin: a sentence, else
  /// "". Collective.
  template <int dim>
  std::string warning_about_unbreakable(const Parameters<dim> &parameters,
                                        const Fields<dim>     &fields);

  /// Nodes within the unbreakable margin.
  template <int dim>
  dealii::IndexSet unbreakable_nodes(const Parameters<dim> &parameters,
                                     const Fields<dim>     &fields);

  /// Values of the phase field prescribed on the boundary at @p time.
  template <int dim>
  std::map<dealii::types::global_dof_index, double>
  prescribed_phase_field(const Parameters<dim> &parameters,
                         const Fields<dim>     &fields,
                         double                 time);
} // namespace MixedCracks

#endif
