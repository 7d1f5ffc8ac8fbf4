// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_output_quantities_h
#define mixed_cracks_output_quantities_h

#include <output/measurement.h>
#include <output/statistics_row.h>

#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

namespace MixedCracks
{
  /// A quantity of a load step, and all that is said of it anywhere: its column
  /// in statistics.csv and in doc/output.md, its place in the record of a
  /// checkpoint and in summary.json, and, by way of the name of the column, its
  /// words on the page of results.
  struct Quantity
  {
    /// How its column is written.
    enum class Format
    {
      number, ///< ten digits
      count,  ///< all digits
      cost    ///< four digits
    };

    /// What summary.json says of it.
    enum class InSummary
    {
      nothing,
      size,  ///< that of the last step, among the sizes
      total, ///< the sum over the steps
      result ///< that of the last step, where it is known
    };

    /// Written as a lambda of a Measurement<dim>, called `step`, of either
    /// dimension: [](const auto &step) { return ...; }
    class Evaluation
    {
    public:
      Evaluation() = default;

      template <typename Body>
      Evaluation(const Body &body)
        : in_2d(body)
        , in_3d(body)
      {}

      double
      operator()(const Measurement<2> &step) const
      {
        return in_2d(step);
      }

      double
      operator()(const Measurement<3> &step) const
      {
        return in_3d(step);
      }

    private:
      std::function<double(const Measurement<2> &)> in_2d;
      std::function<double(const Measurement<3> &)> in_3d;
    };

    /// From the rows of the step and of the first step; not kept.
    using Derivation =
      std::function<double(const StatisticsRow &, const StatisticsRow &)>;

    /// @p name: words with '_' between them. @p unit: "mm", "mm2", "mm3", "N",
    /// "mJ", "s" or none. @p sentence: what it is.
    Quantity(const std::string &name,
             const std::string &unit,
             const std::string &sentence,
             const Evaluation  &evaluate)
      : name(name)
      , unit(unit)
      , sentence(sentence)
      , evaluate(evaluate)
    {}

    /// What is derived from rows is not kept in them.
    Quantity(const std::string &name,
             const std::string &unit,
             const std::string &sentence,
             const Derivation  &derive)
      : name(name)
      , unit(unit)
      , sentence(sentence)
      , derive(derive)
    {}

    Quantity
    written_as(const Format how)
    {
      format = how;
      return *this;
    }

    Quantity
    in_summary_as(const InSummary place)
    {
      summary = place;
      return *this;
    }

    Quantity
    only_in_3d()
    {
      has_2d = false;
      return *this;
    }

    /// Evaluated only where that entry of the .prm asks for it.
    Quantity
    only_with(const std::string &parameter)
    {
      entry = parameter;
      return *this;
    }

    /// Where its integral has another name and unit in 3-d.
    Quantity
    called_in_3d(const std::string &other_name, const std::string &other_unit)
    {
      name_in_3d = other_name;
      unit_in_3d = other_unit;
      return *this;
    }

    /// Its name in files, with the unit.
    std::string column(int dim) const;

    /// Whether it has a column, where @p asked are the entries of the .prm that
    /// ask for more.
    bool has_column(int dim, const std::vector<std::string> &asked) const;

    /// Whether it has its value in every row, and so in checkpoints.
    bool
    is_kept() const
    {
      return !derive;
    }

    std::string name, unit, sentence;
    Evaluation  evaluate;
    Derivation  derive;
    Format      format  = Format::number;
    InSummary   summary = InSummary::nothing;
    std::string entry; ///< that asks for it; empty: always there
    std::string name_in_3d, unit_in_3d;
    bool        has_2d = true;
  };

  /// All of them, in the order of the columns of statistics.csv. To add one,
  /// add a line.
  const std::vector<Quantity> &all_quantities();

  /// The row of a step. What only some entry asks for is evaluated where
  /// @p asked names it, and unknown elsewhere. Collective.
  template <int dim>
  StatisticsRow evaluate_quantities(const Measurement<dim>         &step,
                                    const std::vector<std::string> &asked);

  /// The value in the row of a step, or what follows from it.
  double value_of(const Quantity      &quantity,
                  const StatisticsRow &row,
                  const StatisticsRow &first);

  /// The table of doc/output.md.
  void print_quantities(std::ostream &out);
} // namespace MixedCracks

#endif
