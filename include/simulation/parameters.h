// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_simulation_parameters_h
#define mixed_cracks_simulation_parameters_h

#include <output/crack_opening_parameters.h>
#include <output/event_parameters.h>
#include <output/parameters.h>
#include <output/point_displacement_parameters.h>
#include <output/traction_profile_parameters.h>
#include <output/watched_boundaries_parameters.h>

#include <problem/boundary_conditions.h>
#include <problem/fluid_parameters.h>
#include <problem/geometry.h>
#include <problem/initial_cracks.h>
#include <problem/mesh_parameters.h>
#include <problem/model_parameters.h>

#include <solvers/parameters.h>

#include <steps/coupling.h>
#include <steps/load_control.h>

namespace MixedCracks
{
  /// Everything a .prm says, gathered from the rooms. The entries of the
  /// ParameterHandler point into this object: it stays where it is.
  template <int dim>
  struct Parameters
  {
    GeometryParameters<dim> geometry;
    MeshParameters<dim>     mesh;
    ModelParameters         model;
    CouplingParameters      coupling;
    MaterialParameters      material;
    BoundaryConditions<dim> boundary_conditions;
    FluidParameters<dim>    fluid;
    InitialCracks<dim>      initial_cracks;
    LoadParameters          load;
    SolverParameters        solver;
    OutputParameters        output;

    CrackOpeningParameters<dim>      crack_opening;
    PointDisplacementParameters<dim> point_displacements;
    WatchedBoundariesParameters<dim> watched_boundaries;
    TractionProfileParameters        traction_profiles;
    EventParameters                  events;

    Parameters()                              = default;
    Parameters(const Parameters &)            = delete;
    Parameters &operator=(const Parameters &) = delete;

    void add_parameters(dealii::ParameterHandler &prm);

    /// All checks of the rooms, and those across rooms, before anything is
    /// allocated. Throws InputError.
    void check() const;

    /// What integrals over the mesh are multiplied with to get those over the
    /// body: the thickness (mm) in 2-d, 1 in 3-d.
    double
    thickness_factor() const
    {
      return dim == 2 ? material.thickness : 1.;
    }

    /// The change of the phase field above which a step lets a crack run, with
    /// energy to spare; infinity for couplings that lag, which a crack cannot
    /// outrun.
    double change_where_a_crack_ran() const;

    /// The boundary whose reaction is reported; empty when displacement is
    /// prescribed at points only, whose reaction it is then.
    std::string force_boundary() const;

    /// Whether products without a matrix can do what the model asks for: not in
    /// the displacement formulation, nor with pressures that follow a boundary.
    bool allows_matrix_free() const;

  private:
    void check_matrix_free() const;
  };
} // namespace MixedCracks

#endif
