// SPDX-License-Identifier: GPL-2.0-or-later
#include <base/errors.h>
#include <base/names.h>
#include <base/version.h>

#include <input/case_signature.h>
#include <input/parameter_tree.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

namespace MixedCracks
{
  namespace
  {
    // FNV-1a, 64 bits, and the size; of the file as the first rank sees it.
    // What is no file, and might never end, is refused by who needs it.
    std::string
    contents_of(const std::string &path, const MPI_Comm communicator)
    {
      std::string result;
      if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
      {
        std::error_code error;
        std::ifstream   file;
        if (std::filesystem::is_regular_file(path, error))
          file.open(path, std::ios::binary);
        unsigned long long sum = 14695981039346656037ULL, size = 0;
        for (char byte; file.get(byte); ++size)
          sum = (sum ^ static_cast<unsigned char>(byte)) * 1099511628211ULL;
        result =
          std::to_string(size) + " bytes, checksum " + std::to_string(sum);
      }
      return dealii::Utilities::MPI::broadcast(communicator, result);
    }



    bool
    covers(const std::string &rule, const std::string &full_name)
    {
      return full_name == rule ||
             full_name.compare(0, rule.size() + 1, rule + '/') == 0;
    }



    bool
    is_in(const std::string &rule, const std::string &subsection)
    {
      return covers(subsection, rule) && rule != subsection;
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
            if (is_in(other.name, rule.name) && !may_change(other))
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



    std::map<std::string, std::string>
    values_of(const std::string &signature)
    {
      std::map<std::string, std::string> values;
      std::istringstream                 lines(signature);
      for (std::string line; std::getline(lines, line);)
      {
        const auto sign = line.find(" = ");
        if (sign != std::string::npos)
          values[line.substr(0, sign)] = line.substr(sign + 3);
      }
      return values;
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
      {"Fluid", Rule::no},
      {"Initial cracks", Rule::no},
      {"Load stepping", Rule::yes},
      {"Load stepping/Force boundary", Rule::no}, // the columns of the force
      {"Linear solver", Rule::yes},
      {"Output", Rule::yes},
      {"Output/Displacement at points",
       Rule::if_empty}}; // columns of their own
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
      const std::string line    = name + " = " + entry.value + '\n';
      if (!is_free && entry.name == "File name")
        signature.problem +=
          "contents of " + name + " = " +
          (entry.value.empty() ? "" : contents_of(entry.value, communicator)) +
          '\n';
      else if (!is_free)
        signature.problem += line;
      else if (entry.path.front() != "Output")
        signature.attempt += line;
    }
    return signature;
  }



  void
  require_same_case(const std::string &before, const std::string &now)
  {
    const std::map<std::string, std::string> old_values = values_of(before);
    const std::map<std::string, std::string> new_values = values_of(now);
    for (const auto &[name, value] : new_values)
    {
      const auto old = old_values.find(name);
      if (old == old_values.end())
        refuse(name, "nothing", value);
      const ResumeRule *rule         = resume_rule(name);
      const bool        may_be_added = old->second.empty() && rule != nullptr &&
                                rule->change == ResumeRule::if_empty;
      if (old->second != value && !may_be_added)
        refuse(name, old->second, value);
    }
    for (const auto &[name, value] : old_values)
      if (new_values.count(name) == 0)
        refuse(name, value, "nothing");
  }
} // namespace MixedCracks
