// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_base_expression_h
#define mixed_cracks_base_expression_h

#include <base/time_table.h>

#include <memory>
#include <string>
#include <vector>

namespace MixedCracks
{
  /// A formula of a .prm in named variables, as in "-200/60*t" or "2*h". It
  /// knows the constant pi, the operators of muParser and its functions but
  /// for random numbers, which would differ between ranks, and those that
  /// deal.II has besides. Where t is a variable, table("FILE") is the value at
  /// t of a table that was kept under this name (base/time_table.h).
  ///
  /// Copies share the compiled formula. An evaluation takes about 0.1
  /// microseconds.
  class Expression
  {
  public:
    /// @p variables: their names. @p parameter: what error messages
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
      return entered;
    }

  private:
    struct Formula;

    double evaluate(const std::vector<double> &values) const;

    /// What is wrong with the text, or "".
    std::string compile();

    /// Likewise, with a variable in the place of each table.
    std::string compile(const std::string &text);

    std::string              entered;
    std::vector<std::string> variables;
    std::string              parameter;
    std::shared_ptr<Formula> formula;
  };
} // namespace MixedCracks

#endif
