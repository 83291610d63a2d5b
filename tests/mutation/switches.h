// SPDX-License-Identifier: MIT
//
// What a mutated source calls: each function does what the original operator does, unless the
// mutant of its number is the active one. tools/mutate writes the calls and has this file included
// first everywhere. It is no part of the program.
//
// The number comes from the environment (EDGECASE_MUTANT), so that all mutants are compiled once.
// A switch in code that may run during compilation (Constant) is the original there; one in code
// that never does (Runtime) is no constant expression, lest the compiler fold it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <type_traits>

namespace edgecase_mutation {

inline int number_of_environment() {
  const char* text = std::getenv("EDGECASE_MUTANT");
  return text != nullptr ? std::atoi(text) : 0;
}

// 0: none.
inline int active = number_of_environment();
// Where set, one byte per mutant that is asked for.
inline unsigned char* reached = nullptr;
unsigned char* reached_of_environment();

inline bool is_active(int number) {
  if (number == active) return true;
  if (active < 0) {
    if (reached == nullptr) reached = reached_of_environment();
    reached[number] = 1;
  }
  return false;
}

template <bool kMayBeConstant>
struct Switch {
  static constexpr bool is(int number) {
    if constexpr (kMayBeConstant)
      if (std::is_constant_evaluated()) return false;
    return is_active(number);
  }

  // Arithmetic, shifts and bits: one mutant each, of the original's type. Where the types lack the
  // other operator, as lanes and an interval do, the second operand is dropped.
#define EDGECASE_BINARY(name, original, mutated)                             \
  template <class A, class B>                                                \
  static constexpr auto name(int number, A a, B b) {                         \
    using Result = std::decay_t<decltype(a original b)>;                     \
    if constexpr (requires { static_cast<Result>(a mutated b); })            \
      return is(number) ? static_cast<Result>(a mutated b) : (a original b); \
    else                                                                     \
      return is(number) ? static_cast<Result>(a) : (a original b);           \
  }
  EDGECASE_BINARY(plus, +, -)
  EDGECASE_BINARY(minus, -, +)
  EDGECASE_BINARY(times, *, +)
  EDGECASE_BINARY(divide, /, *)
  EDGECASE_BINARY(modulo, %, *)
  EDGECASE_BINARY(shift_left, <<, >>)
  EDGECASE_BINARY(shift_right, >>, <<)
  EDGECASE_BINARY(bit_and, &, |)
  EDGECASE_BINARY(bit_or, |, &)
  EDGECASE_BINARY(bit_xor, ^, &)
#undef EDGECASE_BINARY

#define EDGECASE_ASSIGN(name, original, mutated)    \
  template <class A, class B>                       \
  static constexpr A& name(int number, A& a, B b) { \
    if (is(number))                                 \
      a mutated b;                                  \
    else                                            \
      a original b;                                 \
    return a;                                       \
  }
  EDGECASE_ASSIGN(plus_assign, +=, -=)
  EDGECASE_ASSIGN(minus_assign, -=, +=)
  EDGECASE_ASSIGN(times_assign, *=, /=)
  EDGECASE_ASSIGN(divide_assign, /=, *=)
  EDGECASE_ASSIGN(modulo_assign, %=, *=)
#undef EDGECASE_ASSIGN

  // Relations: the first mutant moves the boundary, the next one negates; == and != have the
  // latter alone.
#define EDGECASE_RELATION(name, original, shifted)   \
  template <class A, class B>                        \
  static constexpr bool name(int number, A a, B b) { \
    if (is(number)) return a shifted b;              \
    if (is(number + 1)) return !(a original b);      \
    return a original b;                             \
  }
  EDGECASE_RELATION(less, <, <=)
  EDGECASE_RELATION(less_equal, <=, <)
  EDGECASE_RELATION(greater, >, >=)
  EDGECASE_RELATION(greater_equal, >=, >)
#undef EDGECASE_RELATION
  template <class A, class B>
  static constexpr bool equal(int number, A a, B b) {
    return (a == b) != is(number);
  }
  template <class A, class B>
  static constexpr bool unequal(int number, A a, B b) {
    return (a != b) != is(number);
  }

  // Unary operators, dropped.
  template <class A>
  static constexpr auto negate(int number, A a) {
    using Result = std::decay_t<decltype(-a)>;
    return is(number) ? static_cast<Result>(a) : -a;
  }
  template <class A>
  static constexpr auto complement(int number, A a) {
    using Result = std::decay_t<decltype(~a)>;
    return is(number) ? static_cast<Result>(a) : static_cast<Result>(~a);
  }
  template <class A>
  static constexpr bool invert(int number, const A& a) {
    return is(number) ? static_cast<bool>(a) : !a;
  }

  template <class A>
  static constexpr A& increment(int number, A& a) {
    return is(number) ? --a : ++a;
  }
  template <class A>
  static constexpr A& decrement(int number, A& a) {
    return is(number) ? ++a : --a;
  }

  // A literal: the first mutant adds one, the second takes one away; a truth value has one mutant.
  template <class A>
  static constexpr A literal(int number, A a) {
    if constexpr (std::is_same_v<A, bool>) {
      return a != is(number);
    } else {
      if (is(number)) return static_cast<A>(a + 1);
      if (is(number + 1)) return static_cast<A>(a - 1);
      return a;
    }
  }

  // Functions of two arguments, or of one, and the other one of the pair.
  template <int kNumber>
  struct Minimum {
    template <class A>
    static constexpr const A& call(const A& a, const A& b) {
      return is(kNumber) ? std::max(a, b) : std::min(a, b);
    }
  };
  template <int kNumber>
  struct Maximum {
    template <class A>
    static constexpr const A& call(const A& a, const A& b) {
      return is(kNumber) ? std::min(a, b) : std::max(a, b);
    }
  };
  template <int kNumber>
  struct Floor {
    static double call(double a) { return is(kNumber) ? std::ceil(a) : std::floor(a); }
  };
  template <int kNumber>
  struct Ceil {
    static double call(double a) { return is(kNumber) ? std::floor(a) : std::ceil(a); }
  };
  template <class A>
  static constexpr auto floor_of(int number, A a) {
    return is(number) ? a.ceil() : a.floor();
  }
  template <class A>
  static constexpr auto ceil_of(int number, A a) {
    return is(number) ? a.floor() : a.ceil();
  }
};

using Constant = Switch<true>;
using Runtime = Switch<false>;

}  // namespace edgecase_mutation
