// SPDX-License-Identifier: GPL-2.0-or-later
// Expressions in the .prm, as "1e-3*t" or "if(x < 1, 0, 2.7)". muParser, by way
// of deal.II, compiles and evaluates them; before it sees the text,
//
//   1. ',' outside of parentheses, '=' and '"' are refused: muParser takes them
//      for something that nobody means,
//   2. every word is looked up among variables, functions and pi, so that the
//      message can name the word and the nearest one that is known,
//   3. what muParser still dislikes is put into one line.
//
// Whether a value depends on a variable is told by the words, not by
// evaluation: "0*t" uses t. A value that is not finite is no error of the text
// but of the evaluation that meets it, whose message has the variables it was
// met with.
//
// Every expression has deal.II's parser of space, whose variables are a point
// and the time, whatever the names mean; those that are not needed are
// "unused_...". A table is a variable that no user can name, in the place of
// one that the formula does not use.

#include <base/errors.h>
#include <base/expression.h>
#include <base/names.h>
#include <base/text.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/numbers.h>
#include <deal.II/base/point.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iostream>
#include <sstream>

namespace MixedCracks
{
  namespace
  {
    constexpr std::size_t n_parser_variables = 4;

    const std::vector<std::string> &
    function_names()
    {
      static const std::vector<std::string> names{
        "abs",   "acos", "acosh", "asin", "asinh", "atan", "atan2",
        "atanh", "avg",  "ceil",  "cos",  "cosh",  "cot",  "csc",
        "erfc",  "exp",  "floor", "if",   "int",   "ln",   "log",
        "log10", "log2", "max",   "min",  "pow",   "rint", "sec",
        "sign",  "sin",  "sinh",  "sqrt", "sum",   "tan",  "tanh"};
      return names;
    }

    bool
    is_word_character(const char c)
    {
      return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
    }

    // Where the number that starts at begin ends, exponent included.
    std::size_t
    end_of_number(const std::string &text, const std::size_t begin)
    {
      const char *const digits = "0123456789";
      std::size_t       end    = text.find_first_not_of("0123456789.", begin);
      if (end == std::string::npos)
        return text.size();
      if (text[end] != 'e' && text[end] != 'E')
        return end;
      std::size_t exponent = end + 1;
      if (exponent < text.size() &&
          (text[exponent] == '+' || text[exponent] == '-'))
        ++exponent;
      const std::size_t behind = text.find_first_not_of(digits, exponent);
      if (behind == exponent || exponent >= text.size())
        return end;
      return std::min(behind, text.size());
    }

    // Every name in the formula that is not the exponent of a number.
    std::vector<std::string>
    words_of(const std::string &text)
    {
      std::vector<std::string> words;
      for (std::size_t i = 0; i < text.size();)
        if (std::isdigit(static_cast<unsigned char>(text[i])) != 0 ||
            text[i] == '.')
          i = end_of_number(text, i);
        else if (is_word_character(text[i]))
        {
          const std::size_t begin = i;
          while (i < text.size() && is_word_character(text[i]))
            ++i;
          words.push_back(text.substr(begin, i - begin));
        }
        else
          ++i;
      return words;
    }

    std::string
    name_of_table(const std::size_t i)
    {
      return "_table_" + std::to_string(i);
    }

    std::string
    unknown_word(const std::string              &text,
                 const std::vector<std::string> &variables)
    {
      std::vector<std::string> known = variables;
      known.emplace_back("pi");
      known.insert(
        known.end(), function_names().begin(), function_names().end());
      for (const std::string &word : words_of(text))
        if (std::find(known.begin(), known.end(), word) == known.end())
        {
          const std::string nearest = nearest_name(word, known);
          return "unknown name '" + word + "'" +
                 (nearest.empty() || word.size() < 3
                    ? std::string("")
                    : "; did you mean '" + nearest + "'?");
        }
      return "";
    }

    // muParser takes these, but not for what anybody means by them: "0,5" is
    // 5 and "t = 3" sets t.
    std::string
    misleading_character(const std::string &text)
    {
      int depth = 0;
      for (std::size_t i = 0; i < text.size(); ++i)
      {
        depth += (text[i] == '(') - (text[i] == ')');
        if (text[i] == ',' && depth == 0)
          return "',' separates the arguments of functions only; decimals "
                 "take a point";
        const bool comparison =
          (i > 0 &&
           std::string("=<>!").find(text[i - 1]) != std::string::npos) ||
          (i + 1 < text.size() && text[i + 1] == '=');
        if (text[i] == '=' && !comparison)
          return "'=' assigns; a comparison is written '=='";
        if (text[i] == '"')
          return "quotation marks have no meaning here";
      }
      return "";
    }

    // What muParser says in one line, with characters counted from 1.
    std::string
    short_reason(const dealii::ExceptionBase &exception)
    {
      std::ostringstream stream;
      exception.print_info(stream);
      const std::string mark   = "The parser said: ";
      std::string       reason = stream.str();
      const std::size_t begin  = reason.find(mark);
      if (begin == std::string::npos)
        return "it is not a formula";
      reason = single_spaced(reason.substr(begin + mark.size()));
      while (!reason.empty() && reason.back() == '.')
        reason.pop_back();
      const std::size_t position = reason.find("position ");
      if (position != std::string::npos)
      {
        const std::size_t digits = position + 9;
        const std::size_t end = reason.find_first_not_of("0123456789", digits);
        const int number      = std::atoi(reason.substr(digits, end).c_str());
        reason.replace(position,
                       end == std::string::npos ? end : end - position,
                       "character " + std::to_string(number + 1));
      }
      return reason;
    }

    // deal.II's parser writes to the error stream before it throws.
    class SilentErrorStream
    {
    public:
      SilentErrorStream()
        : previous(std::cerr.rdbuf(ignored.rdbuf()))
      {}

      SilentErrorStream(const SilentErrorStream &)            = delete;
      SilentErrorStream &operator=(const SilentErrorStream &) = delete;

      ~SilentErrorStream()
      {
        std::cerr.rdbuf(previous);
      }

    private:
      std::ostringstream ignored;
      std::streambuf    *previous;
    };
  } // namespace



  Expression::Expression(const std::string              &text,
                         const std::vector<std::string> &variables,
                         const std::string              &parameter)
    : formula(dealii::Utilities::trim(text))
    , variables(variables)
    , parameter(parameter)
  {
    Assert(!variables.empty() && variables.size() <= n_parser_variables,
           dealii::ExcMessage("An expression has one to four variables."));
    std::string reason;
    if (formula.empty())
      reason = "it is empty";
    if (reason.empty())
      reason = take_tables();
    if (reason.empty())
      reason = misleading_character(compiled);
    std::vector<std::string> known = variables;
    for (std::size_t i = 0; i < tables.size(); ++i)
      known.push_back(name_of_table(i));
    if (reason.empty())
      reason = unknown_word(compiled, known);
    if (reason.empty())
      try
      {
        compile();
      }
      catch (const dealii::ExceptionBase &exception)
      {
        reason = short_reason(exception);
      }
      catch (const std::exception &exception)
      {
        reason = exception.what();
      }
    if (!reason.empty())
      throw InputError(parameter + ": cannot understand the expression " +
                       in_quotes(formula) + ": " + reason +
                       (reason.back() == '?' ? "" : ".") +
                       " Allowed: numbers, " + join_names(variables) +
                       ", pi, + - * / ^, comparisons, functions such as sin, "
                       "sqrt, exp, min, max, if(condition, yes, no).");
  }



  // Without a table every variable has its place, used or not.
  std::string
  Expression::take_tables()
  {
    std::string missing;
    compiled = replace_tables(formula, [&](const TableCall &call) {
      tables.push_back(kept_time_table(call.path));
      if (!tables.back())
        missing = "the table '" + call.path + "' has not been read";
      return name_of_table(tables.size() - 1);
    });
    const std::vector<std::string> words   = words_of(compiled);
    const auto                     is_used = [&words](const std::string &name) {
      return std::find(words.begin(), words.end(), name) != words.end();
    };
    if (is_used("table"))
      return "a table is a file in quotation marks, whose value is that at the "
             "time t, as in table(\"load.csv\")";
    for (std::size_t i = 0; i < variables.size(); ++i)
      if (tables.empty() || is_used(variables[i]))
        used.push_back(i);
    if (tables.empty())
      return "";
    if (std::find(variables.begin(), variables.end(), "t") == variables.end())
      return "a table is a value over time, and nothing here depends on t";
    return used.size() + tables.size() > n_parser_variables
             ? "with a table it takes more than four variables and tables"
             : missing;
  }



  void
  Expression::compile()
  {
    std::vector<std::string> inputs;
    for (const std::size_t i : used)
      inputs.push_back(variables[i]);
    for (std::size_t i = 0; i < tables.size(); ++i)
      inputs.push_back(name_of_table(i));
    for (std::size_t i = inputs.size(); i < n_parser_variables; ++i)
      inputs.push_back("unused_" + std::to_string(i));
    const std::string names = join_names(inputs, ",");

    const SilentErrorStream silence;
    const auto              fresh = std::make_shared<Parser>();
    fresh->initialize(names,
                      {compiled},
                      {{"pi", dealii::numbers::PI}},
                      /*time_dependent=*/true);
    parser = fresh;
    // muParser compiles at the first evaluation; a value that is not finite
    // at the origin, as 1/t, is none of its business
    evaluate(std::vector<double>(variables.size(), 0.));
  }



  double
  Expression::evaluate(const std::vector<double> &values) const
  {
    AssertDimension(values.size(), variables.size());
    double      padded[n_parser_variables] = {0., 0., 0., 0.};
    std::size_t n                          = 0;
    for (const std::size_t i : used)
      padded[n++] = values[i];
    if (!tables.empty())
    {
      const auto t = std::find(variables.begin(), variables.end(), "t");
      for (const auto &table : tables)
        padded[n++] = (*table)(values[t - variables.begin()]);
    }
    return parser->do_value(
      dealii::Point<3>(padded[0], padded[1], padded[2]), padded[3], 0);
  }



  bool
  Expression::uses(const std::string &name) const
  {
    const std::vector<std::string> words = words_of(compiled);
    return (name == "t" && !tables.empty()) ||
           std::find(words.begin(), words.end(), name) != words.end();
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
      message << parameter << ": the expression " << in_quotes(formula)
              << " gives " << found << " at";
      for (std::size_t i = 0; i < variables.size(); ++i)
        message << (i == 0 ? " " : ", ") << variables[i] << " = " << values[i];
      message << "; it must be finite.";
      throw InputError(message.str());
    }
    return result;
  }
} // namespace MixedCracks
