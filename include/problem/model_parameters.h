// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_problem_model_parameters_h
#define mixed_cracks_problem_model_parameters_h

#include <deal.II/base/parameter_handler.h>

#include <model/material.h>

#include <problem/material_parameters.h>

#include <string>

namespace MixedCracks
{
  /// Subsection "Model": which equations are solved. How a load step couples
  /// them is in the same subsection, see CouplingParameters.
  struct ModelParameters
  {
    std::string formulation         = "mixed";
    std::string displacement_degree = "auto";
    std::string kinematics          = "plane stress";
    std::string deviator_dimension  = "auto";
    std::string crack_density       = "Wu";
    std::string energy_split        = "volumetric-deviatoric";
    std::string pressure_law        = "relaxed bulk";
    double      relaxation          = 1.;
    std::string length_scale        = "2*h";
    std::string residual_stiffness  = "0.001";

    StrainParameters strain;

    /// Enters the subsection itself.
    void add_parameters(dealii::ParameterHandler &prm);

    /// Throws InputError for values that cannot be combined in a @p dim
    /// -dimensional problem, and for expressions that cannot be read; whether
    /// one in h has a value that is allowed shows when the mesh is there.
    void check(int dim = 2) const;

    bool
    mixed() const
    {
      return formulation == "mixed";
    }

    /// Polynomial degree of the displacement.
    unsigned int degree() const;

    /// n of (M3) for a @p dim -dimensional problem.
    int deviator(int dim) const;

    bool
    is_plane_stress(const int dim) const
    {
      return dim == 2 && kinematics == "plane stress";
    }

    /// The constants of the law: at small strain reduced by (M6) in plane
    /// stress. At finite strain F_33 follows at each point (M14), and they are
    /// those of space.
    ElasticConstants in_kinematics(const ElasticConstants &constants,
                                   int                     dim) const;

    /// The constants at a point, as the laws take them.
    PointConstants at_point(const MaterialValues &values, int dim) const;

    /// The length scale (mm) for the cell size @p h (mm).
    double evaluate_length_scale(double h) const;

    /// kappa for the cell size @p h (mm).
    double evaluate_residual_stiffness(double h) const;
  };

  /// All that a Material needs, for the cell size @p h (mm). Constants that
  /// vary are not in it; see MaterialField.
  MaterialDescription describe_material(const ModelParameters    &model,
                                        const MaterialParameters &material,
                                        int                       dim,
                                        double                    h);
} // namespace MixedCracks

#endif
