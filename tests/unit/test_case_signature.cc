// SPDX-License-Identifier: GPL-2.0-or-later
// What may change when a run is resumed, and what may not.
#include <base/errors.h>

#include <input/canonical_text.h>
#include <input/case_signature.h>
#include <input/parameter_tree.h>

#include <simulation/parameters.h>

#include <gtest/gtest.h>

#include <array>
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



TEST(CaseSignature, CanonicalTextsAreOfTheSameMeaning)
{
  for (const auto &[one, other] :
       std::vector<std::pair<std::string, std::string>>{
         {"0.1", "0.10"},
         {"1e-3", ".001"},
         {"2*h", " 2 * h"},
         {"top : y : t ;", "top:y:t"},
         {"if(t < 1e-05, t, 0)", "if(t<0.00001,t,0)"}})
    EXPECT_EQ(canonical_text(one), canonical_text(other));
  for (const auto &[one, other] :
       std::vector<std::pair<std::string, std::string>>{{"0.1", "0.11"},
                                                        {"side_01", "side_1"},
                                                        {"01", "1"},
                                                        {"a b", "ab"},
                                                        {"1-t", "1+t"},
                                                        {"1, 2", "12"}})
    EXPECT_NE(canonical_text(one), canonical_text(other));
}



TEST(CaseSignature, AnotherSpellingIsNoOtherCase)
{
  Case example;
  example.set("Model", "Length scale", "2*h");
  example.set("Boundary conditions",
              "Displacement",
              "top : phase field : 1 ; top : y : 0.1*t ; bottom : all : 0");
  const CaseSignature before = example.signature();
  example.set("Model", "Length scale", "2.0 * h");
  example.set("Boundary conditions",
              "Displacement",
              "top : phase field : 1 ; top:y:0.10*t; bottom : all : 0 ;");
  example.set("Load stepping", "Force boundary", "top"); // its default
  example.set("Linear solver", "Newton tolerance", "1.0e-8");
  const CaseSignature now = example.signature();
  EXPECT_EQ(refusal(before, now), "");
  EXPECT_TRUE(is_same_attempt(before.attempt, now.attempt));
  example.set("Load stepping", "Force boundary", "bottom");
  EXPECT_NE(refusal(before, example.signature()), "");
}



TEST(CaseSignature, TheForceBoundaryInEffectIsTheDefault)
{
  for (const std::string displacement :
       {"top : phase field : 1 ; right : all : 0 ; top : y : t",
        " bottom:x:0 ; top : y : min(t, 1)",
        "top : phase field : 1",
        ""})
  {
    Case example;
    example.set("Boundary conditions", "Displacement", displacement);
    const CaseSignature before   = example.signature();
    const std::string   boundary = example.parameters.force_boundary();
    example.set("Load stepping", "Force boundary", boundary);
    EXPECT_EQ(refusal(before, example.signature()), "") << displacement;
  }
}



TEST(CaseSignature, GeometriesThatAreNotChosenDoNotMatter)
{
  const auto with_size = [](const std::string &geometry) {
    Case example;
    example.set("Geometry", "Name", "slit square");
    example.prm.enter_subsection("Geometry");
    example.set(geometry, "Cell size", "0.0625");
    example.prm.leave_subsection();
    return example.signature();
  };
  EXPECT_EQ(refusal(with_size("Rectangle"), with_size("Box")), "");
  EXPECT_NE(refusal(with_size("Slit square"), with_size("Box")), "");
}



TEST(CaseSignature, AnExpressionThatHasFailedMayBeAnother)
{
  const auto with = [](const std::string &displacement,
                       const std::string &traction) {
    Case example;
    example.set("Boundary conditions", "Displacement", displacement);
    example.set("Boundary conditions", "Traction", traction);
    return example.signature().problem;
  };
  const std::string failure =
    "Boundary conditions/Displacement: the expression '1/(1-t)' gives infinity";
  EXPECT_TRUE(can_be_mended(failure));
  EXPECT_FALSE(can_be_mended("Material/Shear modulus: the expression"));
  EXPECT_FALSE(can_be_mended("no entry at all"));
  const std::string before = with("top : y : 1/(1-t)", "left : x : t");
  const std::string mended = with("top : y : t", "left : x : t");
  EXPECT_THROW(require_same_case(before, mended), InputError);
  const std::string words = require_same_case(before, mended, failure);
  EXPECT_NE(words.find("'top : y : 1/(1-t)' until then, 'top : y : t'"),
            std::string::npos)
    << words;
  EXPECT_EQ(require_same_case(before, before, failure), "");
  // the same boundaries and components, and no other entry
  for (const std::string &other :
       {with("top : x : t", "left : x : t"),
        with("top : y : t ; bottom : y : t", "left : x : t"),
        with("top : y : t", "left : x : 2*t")})
    EXPECT_THROW(require_same_case(before, other, failure), InputError);
}
