// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_base_expression_h
#define mixed_cracks_base_expression_h

#include <base/time_table.h>

#include <deal.II/base/mu_parser_internal.h>

#include <memory>
#include <string>
#include <vector>

namespace MixedCracks
{
  /// A formula of a .prm in named variables, as in "-200/60*t" or "2*h". It
  /// knows the constant pi, the operators of muParser and its functions but
  /// for random numbers, which would differ between ranks. Where t is a
  /// variable, table("FILE") is the value at t of a table that was kept under
  /// this name (base/time_table.h); variables and tables are four at most.
  ///
  /// Copies share the compiled formula. An evaluation takes about 0.1
  /// microseconds.
  class Expression
  {
  public:
    /// @p variables: one to four names. @p parameter: what error messages
    /// call the entry, as "Subsection/Entry". Throws InputError with the
    /// text and the reason when it cannot be compiled.
    Expression(const std::string              &text,
               const std::vector<std::string> &variables,
               const std::string              &parameter);

    /// The value for @p values, one per variable. Throws InputError, with
    /// the values, when the result is not finite; this may happen on one rank
    /// alone.
    double operator()(const std::vector<double> &values) const;

    /// Whether the formula contains this name; a table contains t.
    bool uses(const std::string &name) const;

    /// As the user wrote it.
    const std::string &
    text() const
    {
      return formula;
    }

  private:
    /// Three coordinates and a time are as many variables as deal.II's
    /// parser takes.
    using Parser =
      dealii::internal::FunctionParser::ParserImplementation<3, double>;

    double evaluate(const std::vector<double> &values) const;

    /// Fills the three members of tables, or says why not.
    std::string take_tables();

    void compile();

    std::string                   formula;
    std::vector<std::string>      variables;
    std::string                   parameter;
    std::shared_ptr<const Parser> parser;

    std::string              compiled; ///< the formula, tables as variables
    std::vector<std::size_t> used;     ///< which of the variables it is given
    std::vector<std::shared_ptr<const TimeTable>> tables;
  };
} // namespace MixedCracks

#endif
