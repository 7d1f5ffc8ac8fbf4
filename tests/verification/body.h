// SPDX-License-Identifier: GPL-2.0-or-later
// An elastic body described by the text of a .prm, solved by the same objects
// as in the program, without phase-field steps and output.
#ifndef mixed_cracks_tests_verification_body_h
#define mixed_cracks_tests_verification_body_h

#include <core/simulation_material.h>
#include <core/simulation_setup.h>

#include <deal.II/distributed/tria.h>

#include <functional>
#include <string>

namespace MixedCracks
{
  namespace Testing
  {
    class Body
    {
    public:
      using Position =
        std::function<dealii::Point<2>(const dealii::Point<2> &)>;
      using Scalar = std::function<double(const dealii::Point<2> &)>;

      /// @p prm: entries as 'Subsection/Entry = value', one per line.
      /// @p shape: where the points of the coarse mesh are moved to.
      explicit Body(const std::string &prm, const Position &shape = {});

      /// The phase field the stiffness is degraded with; 1 at first.
      void set_phase_field(const Scalar &phase_field);

      /// Solve for displacement and pressure at @p time. Fails the test when
      /// Newton's method does not converge.
      NewtonOutcome solve(double time = 1.);

      /// Consistent reaction on a boundary, N per mm thickness, positive in
      /// tension.
      dealii::Tensor<1, 2> reaction(const std::string &boundary) const;

      /// The same by integrating stress times normal over the boundary; for
      /// intact bodies.
      dealii::Tensor<1, 2>
      integrated_traction(const std::string &boundary) const;

      /// Displacement at a vertex of the mesh, mm.
      dealii::Tensor<1, 2>
      displacement_at(const dealii::Point<2> &vertex) const;

      /// L2 norm of the difference to @p exact on the components from
      /// @p first on, @p n of them.
      double error(const dealii::Function<2> &exact,
                   unsigned int               first,
                   unsigned int               n) const;

      /// Largest and smallest pressure at the nodes, MPa.
      std::pair<double, double> pressure_range() const;

      dealii::types::boundary_id boundary_id(const std::string &boundary) const;

    private:
      struct ReadParameters : Parameters<2>
      {
        explicit ReadParameters(const std::string &prm);
      };

      void make_mesh_of(const Position &shape);

    public:
      const ReadParameters                            parameters;
      dealii::parallel::distributed::Triangulation<2> triangulation;
      Fields<2>                                       fields;
      Constraints<2>                                  constraints;
      std::unique_ptr<Material<2>>                    material;
      double                                          cell_size = 0.; // mm
      State                                           state;

    private:
      dealii::TimerOutput             timer;
      std::unique_ptr<Assembler<2>>   assembler;
      std::unique_ptr<ElasticStep<2>> elastic_step;
    };
  } // namespace Testing
} // namespace MixedCracks

#endif
