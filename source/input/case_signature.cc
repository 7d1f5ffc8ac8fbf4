// SPDX-License-Identifier: GPL-2.0-or-later
// Whether a checkpoint belongs to a case. The signature has a line for each
// entry, in two parts:
//
//   problem   entries that must not change: geometry, material, model ...;
//             files count by their contents (size and checksum)
//   attempt   the program, and entries that may change, but for Output: a step
//             that failed is tried again only if something here has changed
//
// The rules, one for each subsection or entry, are a list; the longest name
// that covers an entry decides. An expression that has ended a run, by a value
// that is not finite at a later time, may be mended: only the entry that the
// message names.

#include <base/checksum.h>
#include <base/errors.h>
#include <base/names.h>
#include <base/text.h>
#include <base/time_table.h>
#include <base/version.h>

#include <input/canonical_text.h>
#include <input/case_signature.h>
#include <input/parameter_tree.h>

#include <filesystem>
#include <map>
#include <sstream>

namespace MixedCracks
{
  namespace
  {
    bool
    covers(const std::string &rule, const std::string &full_name)
    {
      return full_name == rule || starts_with(full_name, rule + '/');
    }



    bool
    may_change(const ResumeRule &rule)
    {
      return rule.change == ResumeRule::yes;
    }



    // "Linear solver; Load stepping, but for Force boundary; of Mesh: ..."
    std::string
    what_may_change()
    {
      std::vector<std::string>           whole;
      std::map<std::string, std::string> entries;
      for (const ResumeRule &rule : resume_rules())
        if (rule.name.find('/') == std::string::npos && may_change(rule))
        {
          std::vector<std::string> exceptions;
          for (const ResumeRule &other : resume_rules())
            if (other.name != rule.name && covers(rule.name, other.name) &&
                !may_change(other))
              exceptions.push_back(other.name.substr(rule.name.size() + 1));
          whole.push_back(rule.name +
                          (exceptions.empty()
                             ? ""
                             : ", but for " + join_names(exceptions, ", ")));
        }
        else if (may_change(rule))
        {
          const auto   slash = rule.name.find('/');
          std::string &names = entries[rule.name.substr(0, slash)];
          names += (names.empty() ? "" : ", ") + rule.name.substr(slash + 1);
        }
      for (const auto &[subsection, names] : entries)
        whole.push_back("of " + subsection + ": " + names);
      return join_names(whole, "; ");
    }



    using Values = std::map<std::string, std::string>;

    std::string
    value_of(const Values &values, const std::string &name)
    {
      const auto entry = values.find(name);
      return entry == values.end() ? "" : entry->second;
    }



    // The default of an empty Load stepping/Force boundary, as
    // Parameters::force_boundary() has it; out of the text, since checkpoints
    // hold entries as they were written, those of older versions, too.
    std::string
    first_moved_boundary(const std::string &displacement,
                         const std::string &periodic_sides)
    {
      for (const std::string &item : split_list(displacement, ';'))
      {
        const std::vector<std::string> parts = split_list(item, ':');
        if (parts.size() == 3 && parts[1] != "phase field")
          return parts[0];
      }
      const auto pairs = split_list(periodic_sides, ';');
      return pairs.empty() ? "" : split_list(pairs.front(), ':').back();
    }



    // Those that the problem depends on, with defaults that follow from others
    // written out. Of checkpoints of older versions, too.
    Values
    values_of(const std::string &signature)
    {
      Values             values;
      std::istringstream lines(signature);
      for (std::string line; std::getline(lines, line);)
      {
        const auto sign = line.find(" = ");
        if (sign != std::string::npos)
          values[line.substr(0, sign)] = line.substr(sign + 3);
      }
      const std::string geometry = value_of(values, "Geometry/Name");
      for (auto entry = values.begin(); entry != values.end();)
        entry = is_of_other_geometry(entry->first, geometry)
                  ? values.erase(entry)
                  : std::next(entry);
      const auto force = values.find("Load stepping/Force boundary");
      if (force != values.end() && canonical_text(force->second).empty())
        force->second = first_moved_boundary(
          value_of(values, "Boundary conditions/Displacement"),
          value_of(values, "Geometry/Periodic sides"));
      return values;
    }



    // "Fluid/Pressure: the expression ..." is about Fluid/Pressure
    bool
    is_about(const std::string &message, const std::string &name)
    {
      return starts_with(message, name + ": ");
    }



    // 'boundary : component : expression ; ...', 'component : expression ; ...'
    // or an expression
    std::string
    without_expressions(const std::string &value)
    {
      std::string result;
      for (const std::string &item : split_list(value, ';'))
      {
        const auto colon = item.rfind(':');
        result +=
          (colon == std::string::npos ? "" : item.substr(0, colon)) + ';';
      }
      return canonical_text(result);
    }



    bool
    may_be_changed(const std::string &name,
                   const std::string &before,
                   const std::string &now,
                   const std::string &failure)
    {
      const ResumeRule *const rule = resume_rule(name);
      if (rule == nullptr)
        return false;
      if (rule->change == ResumeRule::if_empty)
        return before.empty();
      return rule->change == ResumeRule::if_failed && is_about(failure, name) &&
             without_expressions(before) == without_expressions(now);
    }



    [[noreturn]] void
    refuse(const std::string &name,
           const std::string &before,
           const std::string &now)
    {
      throw InputError("--resume: the case has changed. " + name +
                       ": the checkpoint was written with '" + before +
                       "', found now '" + now +
                       "'. Allowed to change: " + what_may_change() + ".");
    }
  } // namespace



  // What may change leaves the problem as it is: how it is solved, how fast it
  // is loaded, what is written of it. What may not: the body, its material,
  // its loads, the equations, their discretization, and the meaning of columns
  // that are being written.
  const std::vector<ResumeRule> &
  resume_rules()
  {
    using Rule                                 = ResumeRule;
    static const std::vector<ResumeRule> rules = {
      {"Geometry", Rule::no},
      {"Mesh/Global refinements", Rule::no},
      {"Mesh/Refined boxes", Rule::no},
      {"Mesh/Refined discs", Rule::no},
      {"Mesh/Refined surroundings", Rule::no},
      {"Mesh/Adaptation", Rule::no},
      {"Mesh/Adaptive levels", Rule::no},
      {"Mesh/Phase-field threshold", Rule::no},
      {"Mesh/Refinement margin", Rule::yes},
      {"Mesh/Refinement lookahead", Rule::yes},
      {"Mesh/Coarsening margin", Rule::yes},
      {"Model/Formulation", Rule::no},
      {"Model/Displacement degree", Rule::no},
      {"Model/Kinematics", Rule::no},
      {"Model/Strains", Rule::no},
      {"Model/Hyperelastic law", Rule::no},
      {"Model/Volumetric form", Rule::no},
      {"Model/Largest stretch", Rule::no},
      {"Model/Crack density", Rule::no},
      {"Model/Length scale", Rule::no},
      {"Model/Residual stiffness", Rule::no},
      {"Model/Energy split", Rule::no},
      {"Model/Deviator dimension", Rule::no},
      {"Model/Pressure law", Rule::no},
      {"Model/Relaxation constant", Rule::no},
      {"Model/Coupling", Rule::no},
      {"Model/Coupling tolerance", Rule::yes},
      {"Model/Running crack tolerance", Rule::yes},
      {"Model/Over-relaxation", Rule::yes},
      {"Model/Largest acceleration", Rule::yes},
      {"Model/Anderson depth", Rule::yes},
      {"Model/Largest number of coupling iterations", Rule::yes},
      {"Material", Rule::no},
      {"Boundary conditions", Rule::no},
      {"Boundary conditions/Displacement", Rule::if_failed},
      {"Boundary conditions/Displacement at points", Rule::if_failed},
      {"Boundary conditions/Force at points", Rule::if_failed},
      {"Boundary conditions/Phase field at points", Rule::if_failed},
      {"Boundary conditions/Traction", Rule::if_failed},
      {"Boundary conditions/Pressure", Rule::if_failed},
      {"Boundary conditions/Body force", Rule::if_failed},
      {"Boundary conditions/Mean strain", Rule::if_failed},
      {"Fluid", Rule::if_failed},
      {"Initial cracks", Rule::no},
      {"Load stepping", Rule::yes},
      {"Load stepping/Force boundary", Rule::no}, // the columns of the force
      {"Linear solver", Rule::yes},
      {"Output", Rule::yes},
      {"Output/Displacement at points", Rule::if_empty}, // columns of their own
      {"Output/Watched boundaries", Rule::no}}; // behind them, in each row
    return rules;
  }



  const ResumeRule *
  resume_rule(const std::string &full_name)
  {
    const ResumeRule *best = nullptr;
    for (const ResumeRule &rule : resume_rules())
      if (covers(rule.name, full_name) &&
          (best == nullptr || rule.name.size() > best->name.size()))
        best = &rule;
    return best;
  }



  // What is no file, and might never end, is refused by who needs it.
  std::string
  description_of_file(const std::string &path, const MPI_Comm communicator)
  {
    std::string result;
    if (!path.empty() &&
        dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
    {
      std::error_code error;
      const bool      is_file = std::filesystem::is_regular_file(path, error);
      result =
        std::to_string(is_file ? std::filesystem::file_size(path, error) : 0) +
        " bytes, checksum " +
        std::to_string(is_file ? file_checksum(path) : checksum(""));
    }
    return dealii::Utilities::MPI::broadcast(communicator, result);
  }



  std::string
  with_contents_of_tables(const std::string &value, const MPI_Comm communicator)
  {
    return replace_tables(value, [communicator](const TableCall &call) {
      return "table(" + description_of_file(call.path, communicator) + ')';
    });
  }



  bool
  is_of_other_geometry(const std::string &name, const std::string &geometry)
  {
    const auto begin = name.find("Geometry/");
    if (begin == std::string::npos || geometry.empty() ||
        (begin > 0 && name.compare(0, begin, "contents of ") != 0))
      return false;
    const std::vector<std::string> path = split_list(name.substr(begin), '/');
    // subsections begin with a capital letter, names do not
    return path.size() > 2 && path[1].substr(1) != geometry.substr(1);
  }



  CaseSignature
  case_signature(const dealii::ParameterHandler &prm,
                 const MPI_Comm                  communicator)
  {
    CaseSignature signature;
    signature.attempt = std::string("program = ") + MIXED_CRACKS_VERSION + ' ' +
                        MIXED_CRACKS_REVISION + '\n';
    const ParameterTree tree(prm);
    for (const ParameterEntry &entry : tree.entries())
    {
      const std::string name    = entry.full_name();
      const ResumeRule *rule    = resume_rule(name);
      const bool        is_free = rule != nullptr && may_change(*rule);
      const std::string line =
        name + " = " + with_contents_of_tables(entry.value, communicator) +
        '\n';
      if (!is_free && entry.name == "File name")
        signature.problem += "contents of " + name + " = " +
                             description_of_file(entry.value, communicator) +
                             '\n';
      else if (!is_free)
        signature.problem += line;
      else if (entry.path.front() != "Output")
        signature.attempt += line;
    }
    return signature;
  }



  std::string
  require_same_case(const std::string &before,
                    const std::string &now,
                    const std::string &failure)
  {
    const Values old_values = values_of(before);
    const Values new_values = values_of(now);
    std::string  mended;
    for (const auto &[name, value] : new_values)
    {
      const auto old = old_values.find(name);
      if (old == old_values.end())
        refuse(name, "nothing", value);
      if (canonical_text(old->second) == canonical_text(value))
        continue;
      if (!may_be_changed(name, old->second, value, failure))
        refuse(name, old->second, value);
      if (is_about(failure, name))
        mended = name + " = '" + old->second + "' until then, '" + value +
                 "' from there on";
    }
    for (const auto &[name, value] : old_values)
      if (new_values.count(name) == 0)
        refuse(name, value, "nothing");
    return mended;
  }



  bool
  is_same_attempt(const std::string &before, const std::string &now)
  {
    return canonical_text(before) == canonical_text(now);
  }



  bool
  can_be_mended(const std::string &failure)
  {
    const auto        end  = failure.find(": ");
    const ResumeRule *rule = resume_rule(failure.substr(0, end));
    return end != std::string::npos && rule != nullptr &&
           rule->change == ResumeRule::if_failed;
  }
} // namespace MixedCracks
