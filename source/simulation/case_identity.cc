// SPDX-License-Identifier: GPL-2.0-or-later
// How a case is read, and what --case-id answers: the id of what is calculated,
// from all parameters and the files that they name. Derived defaults are asked
// of who derives them.

#include <base/finite_text.h>

#include <input/case_signature.h>
#include <input/parameter_paths.h>
#include <input/parameter_tree.h>

#include <problem/geometries/mesh_reader.h>

#include <simulation/case_identity.h>
#include <simulation/time_tables.h>

#include <limits>

namespace MixedCracks
{
  namespace
  {
    std::string
    exact(const double value)
    {
      return csv_number(value, std::numeric_limits<double>::max_digits10);
    }



    // read as a run would read them, with its messages
    void
    require_files(const dealii::ParameterHandler &prm,
                  const std::string              &geometry)
    {
      const ParameterTree tree(prm);
      for (const ParameterEntry &entry : tree.entries())
        if (names_input_file(entry) && !entry.value.empty() &&
            !is_of_other_geometry(entry.full_name(), geometry))
          read_file_once(entry.value, MPI_COMM_WORLD, entry.full_name());
    }
  } // namespace



  template <int dim>
  EffectiveValues
  derived_values(const Parameters<dim> &parameters)
  {
    EffectiveValues values{
      {"Load stepping/Force boundary", parameters.force_boundary()},
      {"Model/Displacement degree", std::to_string(parameters.model.degree())}};
    if (!parameters.model.strain.is_finite())
      values["Model/Deviator dimension"] =
        std::to_string(parameters.model.deviator(dim));
    const LoadSteps steps                 = parameters.load.steps();
    values["Load stepping/First step"]    = exact(steps.first);
    values["Load stepping/Largest step"]  = exact(steps.largest);
    values["Load stepping/Onset step"]    = exact(steps.onset);
    values["Load stepping/Smallest step"] = exact(steps.smallest);
    return values;
  }



  template <int dim>
  std::string
  case_identity(const Parameters<dim>          &parameters,
                const dealii::ParameterHandler &prm,
                const std::string              &scope)
  {
    require_files(prm, parameters.geometry.name_of_chosen());
    return case_id(case_id_text(prm, derived_values(parameters), scope));
  }



  template <int dim>
  void
  read_case(const std::vector<SourceLine> &source,
            const CommandLine             &command,
            Parameters<dim>               &parameters,
            dealii::ParameterHandler      &prm)
  {
    parameters.add_parameters(prm);
    read_parameters(source, command.set, prm);
    if (command.output)
    {
      prm.enter_subsection("Output");
      prm.set("Directory", *command.output);
      prm.leave_subsection();
    }
    read_time_tables(prm);
    parameters.check();
    require_time_tables_until(parameters.load.end_time, prm);
  }



  template void            read_case(const std::vector<SourceLine> &,
                                     const CommandLine &,
                                     Parameters<2> &,
                                     dealii::ParameterHandler &);
  template void            read_case(const std::vector<SourceLine> &,
                                     const CommandLine &,
                                     Parameters<3> &,
                                     dealii::ParameterHandler &);
  template EffectiveValues derived_values(const Parameters<2> &);
  template EffectiveValues derived_values(const Parameters<3> &);
  template std::string     case_identity(const Parameters<2> &,
                                         const dealii::ParameterHandler &,
                                         const std::string &);
  template std::string     case_identity(const Parameters<3> &,
                                         const dealii::ParameterHandler &,
                                         const std::string &);
} // namespace MixedCracks
