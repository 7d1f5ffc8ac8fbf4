// SPDX-License-Identifier: GPL-2.0-or-later
// From a .prm to parameters, in stages that each report all errors they find,
// so that a file is not mended one error per run:
//
//   statements   parameter_source.cc   lines, with file and number; includes
//   assignments  parameter_parser.cc   known entries, values that fit patterns
//   paths        parameter_paths.cc    of input files, made absolute
//   values       here                  set in deal.II's ParameterHandler
//
// The handler's own parser stops at the first error and knows neither files nor
// lines. It is used for what it is good at: entries with defaults, patterns and
// descriptions, bound to variables.

#include <base/errors.h>
#include <base/names.h>
#include <base/text.h>

#include <deal.II/base/exceptions.h>

#include <input/parameter_file.h>
#include <input/parameter_parser.h>
#include <input/parameter_paths.h>

#include <algorithm>
#include <sstream>

namespace MixedCracks
{
  namespace
  {
    constexpr std::size_t n_errors_shown = 10;

    void
    throw_if_any(const std::vector<std::string> &errors)
    {
      if (errors.empty())
        return;
      const std::size_t n_shown = std::min(errors.size(), n_errors_shown);
      std::string       text =
        join_names({errors.begin(), errors.begin() + n_shown}, "\n");
      if (errors.size() > n_shown)
        text +=
          "\n... and " + std::to_string(errors.size() - n_shown) + " more.";
      throw InputError(text);
    }

    // Why the handler, or the owner of the entry, refused a value.
    std::string
    refusal(const std::exception &exception)
    {
      const auto *const of_library =
        dynamic_cast<const dealii::ExceptionBase *>(&exception);
      if (of_library == nullptr)
        return exception.what();
      std::ostringstream stream;
      of_library->print_info(stream);
      return single_spaced(stream.str());
    }

    // Empty when the handler took the value.
    std::string
    set_entry(const ParameterAssignment &assignment,
              dealii::ParameterHandler  &prm)
    {
      const ParameterEntry &entry = *assignment.entry;
      std::string           problem;
      for (const std::string &subsection : entry.path)
        prm.enter_subsection(subsection);
      try
      {
        prm.set(entry.name, assignment.value);
      }
      catch (const InputError &error)
      {
        problem = assignment.place + ": " + error.what();
      }
      catch (const std::exception &exception)
      {
        problem = assignment.place + ": " + entry.full_name() + ": found " +
                  in_quotes(assignment.value) + ": " + refusal(exception);
      }
      for (std::size_t i = 0; i < entry.path.size(); ++i)
        prm.leave_subsection();
      return problem;
    }
  } // namespace



  void
  read_parameters(const std::string              &file_name,
                  const std::vector<std::string> &overrides,
                  dealii::ParameterHandler       &prm,
                  const MPI_Comm                  comm)
  {
    read_parameters(read_source(file_name, comm), overrides, prm, comm);
  }



  void
  read_parameters(const std::vector<SourceLine>  &source,
                  const std::vector<std::string> &overrides,
                  dealii::ParameterHandler       &prm,
                  const MPI_Comm                  comm)
  {
    const ParameterTree tree(prm);
    ParameterParser     parser(tree);
    parser.parse_file(source);
    for (const std::string &text : overrides)
      parser.parse_override(text);
    throw_if_any(parser.errors());

    std::vector<std::string> errors;
    for (const ParameterAssignment &assignment :
         with_absolute_paths(parser.assignments(), comm))
    {
      const std::string problem = set_entry(assignment, prm);
      if (!problem.empty())
        errors.push_back(problem);
    }
    throw_if_any(errors);
  }
} // namespace MixedCracks
