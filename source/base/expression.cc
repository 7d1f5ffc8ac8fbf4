// SPDX-License-Identifier: GPL-2.0-or-later
// Expressions in the .prm, as "1e-3*t" or "if(x < 1, 0, 2.7)". muParser
// compiles and evaluates them, with the functions that deal.II adds to its own;
// here
//
//   1. lists where no function is, '=' and '"' are refused: muParser takes them
//      for something that nobody means,
//   2. a word that muParser does not know is named with the nearest one that
//      it knows,
//   3. what muParser still dislikes is put into one line.
//
// Whether a value depends on a variable is told by the words, not by
// evaluation: "0*t" uses t. A value that is not finite is no error of the text
// but of the evaluation that meets it, whose message has the variables it was
// met with.
//
// A table is a variable that no user can name.

#include <base/errors.h>
#include <base/expression.h>
#include <base/names.h>
#include <base/text.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/numbers.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <muParser.h>
#include <set>
#include <sstream>

namespace MixedCracks
{
  namespace
  {
    // What is not whole counts as the next integer, in conditions, too.
    double
    nearest_integer(const double x)
    {
      return std::floor(x + 0.5);
    }

    double
    either(const double a, const double b)
    {
      return static_cast<double>(nearest_integer(a) != 0. ||
                                 nearest_integer(b) != 0.);
    }

    double
    both(const double a, const double b)
    {
      return static_cast<double>(nearest_integer(a) != 0. &&
                                 nearest_integer(b) != 0.);
    }

    double
    choose(const double condition, const double yes, const double no)
    {
      return nearest_integer(condition) != 0. ? yes : no;
    }

    // The names of deal.II's FunctionParser, without random numbers; of
    // muParser's constants none.
    void
    define_functions(mu::Parser &parser)
    {
      using Function = double (*)(double);
      parser.ClearConst();
      parser.DefineConst("pi", dealii::numbers::PI);
      parser.DefineFun("if", choose);
      parser.DefineOprt("|", either, 1);
      parser.DefineOprt("&", both, 2);
      parser.DefineFun("int", nearest_integer);
      parser.DefineFun("ceil", static_cast<Function>(std::ceil));
      parser.DefineFun("floor", static_cast<Function>(std::floor));
      parser.DefineFun("log", static_cast<Function>(std::log));
      parser.DefineFun("erfc", static_cast<Function>(std::erfc));
      parser.DefineFun(
        "cot", +[](double x) { return 1. / std::tan(x); });
      parser.DefineFun(
        "csc", +[](double x) { return 1. / std::sin(x); });
      parser.DefineFun(
        "sec", +[](double x) { return 1. / std::cos(x); });
      parser.DefineFun(
        "pow", +[](double x, double n) { return std::pow(x, n); });
    }

    std::string
    name_of_table(const std::size_t i)
    {
      return "_table_" + std::to_string(i);
    }

    std::string
    unknown_word(const std::string              &word,
                 const std::vector<std::string> &variables,
                 const mu::Parser               &parser)
    {
      std::vector<std::string> known = variables;
      known.emplace_back("pi");
      for (const auto &function : parser.GetFunDef())
        known.push_back(function.first);
      const std::string nearest = nearest_name(word, known);
      return "unknown name '" + word + "'" +
             (nearest.empty() || word.size() < 3
                ? std::string("")
                : "; did you mean '" + nearest + "'?");
    }

    // muParser takes these, but not for what anybody means by them: "t = 3"
    // sets t.
    std::string
    misleading_character(const std::string &text)
    {
      if (text.find('"') != std::string::npos)
        return "quotation marks have no meaning here";
      for (std::size_t i = 0; i < text.size(); ++i)
        if (text[i] == '=' && text[i + 1] != '=' &&
            (i == 0 ||
             std::string("=<>!").find(text[i - 1]) == std::string::npos))
          return "'=' assigns; a comparison is written '=='";
      return "";
    }

    // What muParser says in one line, with characters counted from 1.
    std::string
    short_reason(const mu::ParserError &error)
    {
      std::string reason = single_spaced(error.GetMsg());
      while (!reason.empty() && reason.back() == '.')
        reason.pop_back();
      const std::string position = "position " + std::to_string(error.GetPos());
      const std::size_t begin    = reason.find(position);
      if (begin != std::string::npos)
        reason.replace(begin,
                       position.size(),
                       "character " + std::to_string(error.GetPos() + 1));
      return reason;
    }
  } // namespace



  /// The variables have places that stay, which the parser reads.
  struct Expression::Formula
  {
    mu::Parser                                    parser;
    std::vector<double>                           values;
    std::vector<std::shared_ptr<const TimeTable>> tables;
    std::set<std::string>                         words;
    std::size_t                                   time = 0; ///< for tables
  };



  Expression::Expression(const std::string              &text,
                         const std::vector<std::string> &variables,
                         const std::string              &parameter)
    : entered(dealii::Utilities::trim(text))
    , variables(variables)
    , parameter(parameter)
    , formula(std::make_shared<Formula>())
  {
    const std::string reason = entered.empty() ? "it is empty" : compile();
    if (!reason.empty())
      throw InputError(parameter + ": cannot understand the expression " +
                       in_quotes(entered) + ": " + reason +
                       (reason.back() == '?' ? "" : ".") +
                       " Allowed: numbers, " + join_names(variables) +
                       ", pi, + - * / ^, comparisons, functions such as sin, "
                       "sqrt, exp, min, max, if(condition, yes, no).");
  }



  std::string
  Expression::compile()
  {
    std::string       problem;
    const std::string text =
      replace_tables(entered, [&](const TableCall &call) {
        formula->tables.push_back(kept_time_table(call.path));
        if (!formula->tables.back())
          problem = "the table '" + call.path + "' has not been read";
        return name_of_table(formula->tables.size() - 1);
      });
    formula->time =
      std::find(variables.begin(), variables.end(), "t") - variables.begin();
    if (problem.empty() && !formula->tables.empty() &&
        formula->time == variables.size())
      problem = "a table is a value over time, and nothing here depends on t";
    if (problem.empty())
      problem = misleading_character(text);
    return problem.empty() ? compile(text) : problem;
  }



  std::string
  Expression::compile(const std::string &text)
  {
    mu::Parser              &parser = formula->parser;
    std::vector<std::string> names  = variables;
    for (std::size_t i = 0; i < formula->tables.size(); ++i)
      names.push_back(name_of_table(i));
    formula->values.assign(names.size(), 0.);
    define_functions(parser);
    for (std::size_t i = 0; i < names.size(); ++i)
      parser.DefineVar(names[i], &formula->values[i]);
    try
    {
      parser.SetExpr(text);
      // compiles; a value that is not finite at the origin, as 1/t, is none of
      // its business
      parser.Eval();
      for (const auto &used : parser.GetUsedVar())
        formula->words.insert(used.first);
    }
    catch (const mu::ParserError &error)
    {
      const std::string &word = error.GetToken();
      if (error.GetCode() != mu::ecUNASSIGNABLE_TOKEN || word.empty() ||
          (std::isalpha(static_cast<unsigned char>(word[0])) == 0 &&
           word[0] != '_'))
        return short_reason(error);
      if (word == "table")
        return "a table is a file in quotation marks, whose value is that at "
               "the time t, as in table(\"load.csv\")";
      return unknown_word(word, variables, parser);
    }
    return parser.GetNumResults() == 1
             ? ""
             : "',' separates the arguments of functions only; decimals take a "
               "point";
  }



  double
  Expression::evaluate(const std::vector<double> &values) const
  {
    AssertDimension(values.size(), variables.size());
    std::copy(values.begin(), values.end(), formula->values.begin());
    for (std::size_t i = 0; i < formula->tables.size(); ++i)
      formula->values[variables.size() + i] =
        (*formula->tables[i])(values[formula->time]);
    return formula->parser.Eval();
  }



  bool
  Expression::uses(const std::string &name) const
  {
    return (name == "t" && !formula->tables.empty()) ||
           formula->words.count(name) != 0;
  }



  double
  Expression::operator()(const std::vector<double> &values) const
  {
    const double result = evaluate(values);
    if (!std::isfinite(result))
    {
      // a number that is none has a sign, which would be printed
      const char *const  found = std::isnan(result) ? "no number"
                                 : result > 0.      ? "infinity"
                                                    : "minus infinity";
      std::ostringstream message;
      message << parameter << ": the expression " << in_quotes(entered)
              << " gives " << found << " at";
      for (std::size_t i = 0; i < variables.size(); ++i)
        message << (i == 0 ? " " : ", ") << variables[i] << " = " << values[i];
      message << "; it must be finite.";
      throw InputError(message.str());
    }
    return result;
  }
} // namespace MixedCracks
