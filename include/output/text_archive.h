// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_output_text_archive_h
#define mixed_cracks_output_text_archive_h

#include <base/errors.h>

#include <deal.II/base/point.h>

#include <array>
#include <cstdlib>
#include <iomanip>
#include <istream>
#include <map>
#include <ostream>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace MixedCracks
{
  /// Members of a structure for TextWriter and TextReader, in their order. All
  /// have to be named: where one is added to the structure, this no longer
  /// compiles until it is written and read. Found by the type of the argument,
  /// hence not in a namespace of its own.
  template <typename T, typename Structure>
  using IfIs =
    std::enable_if_t<std::is_same_v<std::remove_const_t<T>, Structure>, int>;

#define MIXED_CRACKS_MEMBERS(Structure, ...)    \
  template <typename T, IfIs<T, Structure> = 0> \
  static auto members(T &structure)             \
  {                                             \
    auto &[__VA_ARGS__] = structure;            \
    return std::tie(__VA_ARGS__);               \
  }

  /// Values as text, numbers to the last digit, separated by blanks. A
  /// structure is what its function members() lists: a tuple of references.
  class TextWriter
  {
  public:
    explicit TextWriter(std::ostream &out)
      : out(out)
    {
      out << std::setprecision(17);
    }

    void
    operator()(const std::string &text)
    {
      out << std::quoted(text) << ' ';
    }

    template <int dim>
    void
    operator()(const dealii::Point<dim> &point)
    {
      for (unsigned int d = 0; d < dim; ++d)
        (*this)(point[d]);
    }

    template <typename T, std::size_t n>
    void
    operator()(const std::array<T, n> &values)
    {
      for (const T &value : values)
        (*this)(value);
    }

    template <typename A, typename B>
    void
    operator()(const std::pair<A, B> &pair)
    {
      (*this)(pair.first);
      (*this)(pair.second);
    }

    template <typename T>
    void
    operator()(const std::vector<T> &values)
    {
      all_of(values);
    }

    /// Values somewhere else, without their number: who reads knows it.
    template <typename T>
    void
    operator()(const std::vector<T *> &values)
    {
      for (const T *value : values)
        (*this)(*value);
    }

    template <typename A, typename B>
    void
    operator()(const std::map<A, B> &values)
    {
      all_of(values);
    }

    template <typename T>
    void
    operator()(const T &value)
    {
      if constexpr (std::is_arithmetic_v<T>)
        out << value << ' ';
      else if constexpr (std::is_enum_v<T>)
        out << static_cast<int>(value) << ' ';
      else
      {
        std::apply([this](const auto &...member) { ((*this)(member), ...); },
                   members(value));
        out << '\n';
      }
    }

  private:
    template <typename Container>
    void
    all_of(const Container &values)
    {
      out << values.size() << '\n';
      for (const auto &value : values)
        (*this)(value);
    }

    std::ostream &out;
  };



  /// Reads what TextWriter has written; throws FileError for anything else.
  class TextReader
  {
  public:
    explicit TextReader(std::istream &in)
      : in(in)
    {}

    void
    operator()(std::string &text)
    {
      in >> std::quoted(text);
      require(!in.fail());
    }

    void
    operator()(double &number)
    {
      // a stream reads no 'nan', which stands for what was not computed
      std::string word;
      in >> word;
      char *end = nullptr;
      number    = std::strtod(word.c_str(), &end);
      require(!word.empty() && *end == '\0');
    }

    template <int dim>
    void
    operator()(dealii::Point<dim> &point)
    {
      for (unsigned int d = 0; d < dim; ++d)
        (*this)(point[d]);
    }

    template <typename T, std::size_t n>
    void
    operator()(std::array<T, n> &values)
    {
      for (T &value : values)
        (*this)(value);
    }

    template <typename A, typename B>
    void
    operator()(std::pair<A, B> &pair)
    {
      (*this)(pair.first);
      (*this)(pair.second);
    }

    template <typename T>
    void
    operator()(std::vector<T> &values)
    {
      values.clear();
      for (std::size_t n = size(); n > 0; --n)
      {
        values.emplace_back();
        (*this)(values.back());
      }
    }

    /// Into places somewhere else, as many as there are.
    template <typename T>
    void
    operator()(std::vector<T *> &values)
    {
      for (T *value : values)
        (*this)(*value);
    }

    template <typename A, typename B>
    void
    operator()(std::map<A, B> &values)
    {
      values.clear();
      for (std::size_t n = size(); n > 0; --n)
      {
        std::pair<A, B> value;
        (*this)(value);
        values.insert(value);
      }
    }

    template <typename T>
    void
    operator()(T &value)
    {
      if constexpr (std::is_arithmetic_v<T>)
      {
        in >> value;
        require(!in.fail());
      }
      else if constexpr (std::is_enum_v<T>)
      {
        int number = 0;
        (*this)(number);
        value = static_cast<T>(number);
      }
      else
        std::apply([this](auto &&...member) { ((*this)(member), ...); },
                   members(value));
    }

  private:
    std::size_t
    size()
    {
      std::size_t n = 0;
      (*this)(n);
      return n;
    }

    static void
    require(const bool readable)
    {
      if (!readable)
        throw FileError("the text is not what was written");
    }

    std::istream &in;
  };
} // namespace MixedCracks

#endif
