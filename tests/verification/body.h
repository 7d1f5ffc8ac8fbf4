// SPDX-License-Identifier: GPL-2.0-or-later
// An elastic body described by the text of a .prm, solved by the same objects
// as in the program, without phase-field steps and output.
// Body: in 2-d; BodyIn<3>: in 3-d.
#ifndef mixed_cracks_tests_verification_body_h
#define mixed_cracks_tests_verification_body_h

#include <deal.II/distributed/tria.h>

#include <simulation/simulation_material.h>
#include <simulation/simulation_setup.h>

#include <functional>
#include <string>

namespace MixedCracks
{
  namespace Testing
  {
    template <int dim>
    class BodyIn
    {
    public:
      using Position =
        std::function<dealii::Point<dim>(const dealii::Point<dim> &)>;
      using Scalar    = std::function<double(const dealii::Point<dim> &)>;
      using MeshMaker = std::function<void(const Geometry<dim> &,
                                           dealii::Triangulation<dim> &)>;

      /// @p prm: entries as 'Subsection/Entry = value', one per line.
      /// @p shape: where the points of the coarse mesh are moved to.
      explicit BodyIn(const std::string &prm, const Position &shape = {});

      /// @p coarse_mesh: makes it, with the boundaries that the geometry of
      /// @p prm has.
      BodyIn(const std::string &prm, const MeshMaker &coarse_mesh);

      /// The phase field the stiffness is degraded with; 1 at first.
      void set_phase_field(const Scalar &phase_field);

      /// Solve for displacement and pressure at @p time; at finite strain from
      /// what is predicted. Fails the test when Newton's method does not
      /// converge.
      NewtonOutcome solve(double time = 1.);

      /// The same with a new matrix in each iteration: the residuals, relative
      /// to the terms that cancel in them, from the start to the one that is
      /// below @p tolerance.
      std::vector<double> newton_history(double time, double tolerance);

      /// Of the last solution: forces of the supports times the displacements
      /// that they hold; N mm (2-d: per mm thickness).
      double reaction_times_displacement() const;

      /// Consistent reaction on a boundary, N (2-d: per mm thickness), positive
      /// in tension.
      dealii::Tensor<1, dim> reaction(const std::string &boundary) const;

      /// The same by integrating stress times normal over the boundary; for
      /// intact bodies.
      dealii::Tensor<1, dim>
      integrated_traction(const std::string &boundary) const;

      /// Displacement at a vertex of the mesh, mm.
      dealii::Tensor<1, dim>
      displacement_at(const dealii::Point<dim> &vertex) const;

      /// L2 norm of the difference to @p exact on the components from
      /// @p first on, @p n of them.
      double error(const dealii::Function<dim> &exact,
                   unsigned int                 first,
                   unsigned int                 n) const;

      /// Largest and smallest pressure at the nodes, MPa.
      std::pair<double, double> pressure_range() const;

      BoundaryIds boundary_ids(const std::string &boundary) const;

    private:
      struct ReadParameters : Parameters<dim>
      {
        explicit ReadParameters(const std::string &prm);
      };

      void make_mesh_of(const MeshMaker &coarse_mesh);

      /// Time, prescribed displacements, and where Newton's method starts.
      void start(double time);

    public:
      const ReadParameters                              parameters;
      dealii::parallel::distributed::Triangulation<dim> triangulation;
      Fields<dim>                                       fields;
      Constraints<dim>                                  constraints;
      std::unique_ptr<Material<dim>>                    material;
      double                                            cell_size = 0.; // mm
      State                                             state;

    private:
      PhaseTimer                        timer;
      std::unique_ptr<Assembler<dim>>   assembler;
      std::unique_ptr<ElasticStep<dim>> elastic_step;
    };

    using Body = BodyIn<2>;
  } // namespace Testing
} // namespace MixedCracks

#endif
