// SPDX-License-Identifier: GPL-2.0-or-later
// What may change when a run is resumed, and what may not.
#include <base/errors.h>

#include <input/case_signature.h>
#include <input/parameter_tree.h>

#include <simulation/parameters.h>

#include <gtest/gtest.h>

#include <fstream>

using namespace MixedCracks;

namespace
{
  struct Case
  {
    Case()
    {
      parameters.add_parameters(prm);
    }

    void
    set(const std::string &subsection,
        const std::string &name,
        const std::string &value)
    {
      prm.enter_subsection(subsection);
      prm.set(name, value);
      prm.leave_subsection();
    }

    CaseSignature
    signature() const
    {
      return case_signature(prm);
    }

    Parameters<2>            parameters;
    dealii::ParameterHandler prm;
  };

  std::string
  refusal(const CaseSignature &before, const CaseSignature &now)
  {
    try
    {
      require_same_case(before.problem, now.problem);
    }
    catch (const InputError &error)
    {
      return error.what();
    }
    return "";
  }
} // namespace



TEST(CaseSignature, EveryEntryHasBeenDecidedUpon)
{
  const Case          example;
  const ParameterTree tree(example.prm);
  for (const ParameterEntry &entry : tree.entries())
    EXPECT_NE(resume_rule(entry.full_name()), nullptr)
      << "may " << entry.full_name()
      << " change when a run is resumed? See resume_rules()";
  for (const ResumeRule &rule : resume_rules())
  {
    bool is_used = false;
    for (const ParameterEntry &entry : tree.entries())
      is_used = is_used || resume_rule(entry.full_name()) == &rule;
    EXPECT_TRUE(is_used) << rule.name << " is the rule of no entry";
  }
}



TEST(CaseSignature, SolversAndLoadStepsMayChangeAndCountAsAnotherAttempt)
{
  Case                example;
  const CaseSignature before = example.signature();
  example.set("Model", "Largest number of coupling iterations", "7");
  CaseSignature now = example.signature();
  EXPECT_EQ(refusal(before, now), "");
  EXPECT_NE(before.attempt, now.attempt);
  example.set("Load stepping", "End time", "7");
  example.set("Linear solver", "Newton tolerance", "1e-6");
  now = example.signature();
  EXPECT_EQ(refusal(before, now), "");
}



TEST(CaseSignature, WhatIsWrittenIsNoOtherAttempt)
{
  Case                example;
  const CaseSignature before = example.signature();
  example.set("Output", "Directory", "elsewhere");
  example.set("Output", "Crack volume", "true");
  const CaseSignature now = example.signature();
  EXPECT_EQ(refusal(before, now), "");
  EXPECT_EQ(before.attempt, now.attempt);
}



TEST(CaseSignature, ColumnsMayBeAddedButNotChanged)
{
  Case                example;
  const CaseSignature none = example.signature();
  example.set("Output", "Displacement at points", "tip : 0, 1");
  const CaseSignature one = example.signature();
  EXPECT_EQ(refusal(none, one), "");
  EXPECT_NE(refusal(one, none), "");
  example.set("Output", "Displacement at points", "tip : 0, 2");
  EXPECT_NE(refusal(one, example.signature()), "");
}



TEST(CaseSignature, ARefusalNamesTheEntryAndWhatMayChange)
{
  Case                example;
  const CaseSignature before = example.signature();
  example.set("Model", "Residual stiffness", "0.01");
  const std::string message = refusal(before, example.signature());
  for (const char *const part : {"Model/Residual stiffness",
                                 "'0.001'",
                                 "'0.01'",
                                 "of Model: Coupling tolerance",
                                 "Largest number of coupling iterations",
                                 "Load stepping, but for Force boundary",
                                 "Output, but for Displacement at points"})
    EXPECT_NE(message.find(part), std::string::npos) << part << ": " << message;
}



TEST(CaseSignature, AFileCountsByWhatItHoldsNotByItsName)
{
  const auto write = [](const std::string &name, const std::string &text) {
    std::ofstream(name) << text;
  };
  const unsigned int rank =
    dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
  const std::string one = "signature_one.csv", other = "signature_other.csv";
  const auto        signature_of = [](const std::string &name) {
    Case example;
    example.prm.enter_subsection("Material");
    example.set("Map", "File name", name);
    example.prm.leave_subsection();
    return example.signature();
  };
  if (rank == 0)
  {
    write(one, "0,0,1\n");
    write(other, "0,0,1\n");
  }
  const CaseSignature before = signature_of(one);
  EXPECT_EQ(refusal(before, signature_of(other)), "");
  EXPECT_NE(refusal(before, Case().signature()), "");
  if (rank == 0)
    write(other, "0,0,2\n");
  EXPECT_NE(
    refusal(before, signature_of(other)).find("contents of Material/Map"),
    std::string::npos);
  if (rank == 0)
    for (const std::string &name : {one, other})
      std::remove(name.c_str());
}
