// Emscripten's standard library of 2021 has the concepts of C++20's ranges, but not the algorithms, and no conversion
// from characters to numbers. This file has the functions that zstrip calls, written with the functions that it has. An
// option of the compiler includes it before each source.
#pragma once

#include <algorithm>
#include <charconv>
#include <clocale>
#include <cstdlib>
#include <functional>
#include <iterator>
#include <string>
#include <system_error>
#include <utility>

#if !defined(_LIBCPP_VERSION) || _LIBCPP_VERSION >= 15000
#error "this library is younger: what is here must go"
#endif

namespace std {

template <class To, class From>
constexpr To bit_cast(const From& from) noexcept {
  return __builtin_bit_cast(To, from);
}

/// Accepts decimal numbers as the standard does: without white space, plus sign or hexadecimal digits.
inline from_chars_result from_chars(const char* first, const char* last, double& value) {
  const string text(first, find_if_not(first, last, [](char c) {
                      return (c >= '0' && c <= '9') || c == '.' || c == '-' || c == 'e' || c == 'E' || c == '+';
                    }));
  if (text.empty() || text.front() == '+') return {first, errc::invalid_argument};
  char* end = nullptr;
  const double read = strtod(text.c_str(), &end);  // no locale is ever set
  if (end == text.c_str()) return {first, errc::invalid_argument};
  value = read;
  return {first + (end - text.c_str()), errc{}};
}

namespace ranges {

template <class In, class Out>
struct in_out_result {
  In in;
  Out out;
};
template <class In1, class In2>
struct in_in_result {
  In1 in1;
  In2 in2;
};

template <class Compare, class Projection>
constexpr auto projected_by(Compare& compare, Projection& projection) {
  return [&](const auto& a, const auto& b) {
    return std::invoke(compare, std::invoke(projection, a), std::invoke(projection, b));
  };
}

template <class Range, class Test, class Projection = identity>
constexpr auto find_if(Range&& range, Test test, Projection projection = {}) {
  return std::find_if(std::begin(range), std::end(range),
                      [&](auto&& item) { return std::invoke(test, std::invoke(projection, item)); });
}
template <class Range, class Value, class Projection = identity>
constexpr auto find(Range&& range, const Value& value, Projection projection = {}) {
  return ranges::find_if(
      range, [&](const auto& item) { return item == value; }, projection);
}
template <class Range, class Test, class Projection = identity>
constexpr bool any_of(Range&& range, Test test, Projection projection = {}) {
  return ranges::find_if(range, test, projection) != std::end(range);
}
template <class Range, class Test, class Projection = identity>
constexpr bool none_of(Range&& range, Test test, Projection projection = {}) {
  return !ranges::any_of(range, test, projection);
}
template <class Range, class Test, class Projection = identity>
constexpr bool all_of(Range&& range, Test test, Projection projection = {}) {
  return !ranges::any_of(
      range, [&](auto&& item) { return !std::invoke(test, item); }, projection);
}
template <class Range, class Test, class Projection = identity>
constexpr auto count_if(Range&& range, Test test, Projection projection = {}) {
  return std::count_if(std::begin(range), std::end(range),
                       [&](const auto& item) { return std::invoke(test, std::invoke(projection, item)); });
}
template <class Range, class Value, class Projection = identity>
constexpr auto count(Range&& range, const Value& value, Projection projection = {}) {
  return ranges::count_if(
      range, [&](const auto& item) { return item == value; }, projection);
}
template <class Range, class Call>
constexpr void for_each(Range&& range, Call call) {
  for (auto&& item : range) std::invoke(call, item);
}
template <class Range, class Out>
constexpr auto copy(Range&& range, Out out) {
  return in_out_result<decltype(std::begin(range)), Out>{std::end(range),
                                                         std::copy(std::begin(range), std::end(range), out)};
}
template <class Range, class Out, class Test>
constexpr auto copy_if(Range&& range, Out out, Test test) {
  return in_out_result<decltype(std::begin(range)), Out>{
      std::end(range),
      std::copy_if(std::begin(range), std::end(range), out, [&](const auto& item) { return std::invoke(test, item); })};
}
template <class Range, class Out, class Call>
constexpr auto transform(Range&& range, Out out, Call call) {
  return in_out_result<decltype(std::begin(range)), Out>{
      std::end(range),
      std::transform(std::begin(range), std::end(range), out, [&](auto&& item) { return std::invoke(call, item); })};
}
template <class Range, class Value>
constexpr void fill(Range&& range, const Value& value) {
  std::fill(std::begin(range), std::end(range), value);
}
template <class Range, class Value>
constexpr void replace(Range&& range, const Value& from, const Value& to) {
  std::replace(std::begin(range), std::end(range), from, to);
}
template <class Range>
constexpr void reverse(Range&& range) {
  std::reverse(std::begin(range), std::end(range));
}
template <class Range, class Compare = std::less<>, class Projection = identity>
constexpr void sort(Range&& range, Compare compare = {}, Projection projection = {}) {
  std::sort(std::begin(range), std::end(range), projected_by(compare, projection));
}
template <class Range, class Compare = std::less<>, class Projection = identity>
constexpr void stable_sort(Range&& range, Compare compare = {}, Projection projection = {}) {
  std::stable_sort(std::begin(range), std::end(range), projected_by(compare, projection));
}
template <class Range, class Iterator, class Compare = std::less<>, class Projection = identity>
constexpr void nth_element(Range&& range, Iterator nth, Compare compare = {}, Projection projection = {}) {
  std::nth_element(std::begin(range), nth, std::end(range), projected_by(compare, projection));
}
template <class Range, class Compare = std::less<>, class Projection = identity>
constexpr auto min_element(Range&& range, Compare compare = {}, Projection projection = {}) {
  return std::min_element(std::begin(range), std::end(range), projected_by(compare, projection));
}
template <class Range, class Compare = std::less<>, class Projection = identity>
constexpr auto max_element(Range&& range, Compare compare = {}, Projection projection = {}) {
  return std::max_element(std::begin(range), std::end(range), projected_by(compare, projection));
}
template <class Range>
constexpr auto min(Range&& range) {
  return *std::min_element(std::begin(range), std::end(range));
}
template <class Range, class Value, class Compare = std::less<>, class Projection = identity>
constexpr auto lower_bound(Range&& range, const Value& value, Compare compare = {}, Projection projection = {}) {
  return std::lower_bound(std::begin(range), std::end(range), value, [&](const auto& item, const Value& bound) {
    return std::invoke(compare, std::invoke(projection, item), bound);
  });
}
template <class Range, class Value, class Compare = std::less<>, class Projection = identity>
constexpr auto upper_bound(Range&& range, const Value& value, Compare compare = {}, Projection projection = {}) {
  return std::upper_bound(std::begin(range), std::end(range), value, [&](const Value& bound, const auto& item) {
    return std::invoke(compare, bound, std::invoke(projection, item));
  });
}
template <class Range1, class Range2, class Same = std::equal_to<>>
constexpr bool equal(Range1&& a, Range2&& b, Same same = {}) {
  return std::equal(std::begin(a), std::end(a), std::begin(b), std::end(b), same);
}
template <class Range1, class Range2>
constexpr auto mismatch(Range1&& a, Range2&& b) {
  const auto ends = std::mismatch(std::begin(a), std::end(a), std::begin(b), std::end(b));
  return in_in_result<decltype(std::begin(a)), decltype(std::begin(b))>{ends.first, ends.second};
}

}  // namespace ranges
}  // namespace std
