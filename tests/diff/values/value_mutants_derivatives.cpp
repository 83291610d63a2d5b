// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>
#include <utility>

#include "tests/diff/values/value_mutants.h"

namespace edgecase {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr auto kViolation = Verdict::violation;
constexpr auto kConvention = Verdict::convention;
constexpr auto kPermitted = Verdict::permitted;

const std::vector<std::string> kSteep = {"smooth triangle", "clip triangle"};
const std::vector<std::string> kSteepAndLevel = {"small triangle", "small linear triangle",
                                                 "smooth line"};

using Form = std::size_t;
constexpr Form kPlain = 0, kFine = 1, kCoarse = 2;

// All derivatives of one form by another method; the rest stays.
ValueMutation by(Form form, DerivativeMethod method) {
  return [=](const Scene& scene, const Rendering& exact) {
    RuleChoices choices;
    choices.values.derivatives[form] = method;
    return shaded_under(scene, exact, choices);
  };
}

std::array<double, 4>& of(FragmentDetail& detail, Derivative derivative) {
  return detail.derivatives[static_cast<std::size_t>(derivative)].value();
}

ValueMutation each(std::vector<Derivative> derivatives, double (*change)(double)) {
  return all_fragments([=](const Scene&, Fragment&, FragmentDetail& detail) {
    for (const Derivative d : derivatives)
      for (double& value : of(detail, d)) value = change(value);
  });
}

ValueMutation once(Derivative derivative, double (*change)(double)) {
  return middle_fragment([=](const Scene&, Fragment&, FragmentDetail& detail) {
    of(detail, derivative)[2] = change(of(detail, derivative)[2]);
  });
}

double negated(double value) {
  return -value;
}
double twice(double value) {
  return 2 * value;
}
double zero(double) {
  return 0;
}
double nan(double) {
  return kNaN;
}
double infinite(double) {
  return HUGE_VAL;
}
double off_by_a_thousandth(double value) {
  return value + 1e-3;
}

void swap_axes(const Scene&, Fragment&, FragmentDetail& detail) {
  for (std::size_t d = 0; d < kDerivatives; d += 2)
    std::swap(detail.derivatives[d], detail.derivatives[d + 1]);
}

// A quad's pixels that the primitive does not cover count as black, not as what its plane has.
Rendering uncovered_are_black(const Scene& scene, const Rendering& exact) {
  Rendering result = exact;
  const auto color_at = [&](int x, int y) {
    for (const Fragment& f : exact.fragments)
      if (f.x == x && f.y == y) return f.color;
    return std::array<double, 4>{};
  };
  for (const Fragment& f : exact.fragments) {
    FragmentDetail& detail = result.details[static_cast<std::size_t>(f.detail)];
    const int x = f.x - f.x % 2, y = f.y - f.y % 2;
    for (std::size_t c = 0; c < 4; ++c) {
      of(detail, Derivative::x_fine)[c] = color_at(x + 1, f.y)[c] - color_at(x, f.y)[c];
      of(detail, Derivative::y_fine)[c] = color_at(f.x, y + 1)[c] - color_at(f.x, y)[c];
    }
  }
  return stored(scene, std::move(result));
}

// Differences of the colours as float32 numbers have them, in float32.
Rendering in_float32(const Scene& scene, const Rendering& exact) {
  Rendering result = exact;
  for (const Fragment& f : exact.fragments) {
    const PrimitiveAttributes attributes = exact_attributes(scene, f);
    const auto color = [&](int x, int y, std::size_t c) {
      return static_cast<float>(middle(interpolate_exact(attributes.color[c], pixel_centre(x, y))));
    };
    FragmentDetail& detail = result.details[static_cast<std::size_t>(f.detail)];
    const int x = f.x - f.x % 2, y = f.y - f.y % 2;
    for (std::size_t c = 0; c < 4; ++c) {
      const auto set = [&](Derivative d, float value) {
        of(detail, d)[c] = static_cast<double>(value);
      };
      set(Derivative::x, color(x + 1, f.y, c) - color(x, f.y, c));
      set(Derivative::y, color(f.x, y + 1, c) - color(f.x, y, c));
      set(Derivative::x_fine, color(x + 1, f.y, c) - color(x, f.y, c));
      set(Derivative::y_fine, color(f.x, y + 1, c) - color(f.x, y, c));
      set(Derivative::x_coarse, color(x + 1, y, c) - color(x, y, c));
      set(Derivative::y_coarse, color(x, y + 1, c) - color(x, y, c));
    }
  }
  return stored(scene, std::move(result));
}

// Colours and derivatives of a renderer that divides by w where it must not, or the other way
// round.
ValueMutation shaded_with(PerspectiveChoice perspective) {
  return [=](const Scene& scene, const Rendering& exact) {
    RuleChoices choices;
    choices.values.perspective = perspective;
    return shaded_under(scene, exact, choices);
  };
}

// Quads that begin at the topmost row.
Rendering from_the_top(const Scene& scene, const Rendering& exact) {
  RuleChoices choices;
  choices.values.quad_rows = RowOrder::top_down;
  return shaded_under(scene, exact, choices);
}

std::set<std::string> all_of(const std::string& cause) {
  std::set<std::string> result;
  for (const char* rule :
       {"attribute.smooth", "derivative.plain", "derivative.fine", "derivative.coarse"})
    result.insert(rule + (": " + cause));
  return result;
}

// A method in place of another, and what it is found to be.
ValueMutant method_mutant(const char* form, Form of_form, DerivativeMethod method,
                          Verdict verdict) {
  // Where the attribute runs more gently, an analytic derivative may come near a difference.
  const bool near = method == DerivativeMethod::analytic;
  const std::string rule = std::string("derivative.") + form;
  return {std::string(form) + " derivatives by " + name_of(method),
          near ? std::vector<std::string>{"clip triangle"} : kSteep,
          by(of_form, method),
          verdict,
          {rule + ": " + rule + "=" + name_of(method)}};
}

std::vector<ValueMutant> method_mutants() {
  using enum DerivativeMethod;
  std::vector<ValueMutant> mutants = {
      method_mutant("fine", kFine, other_row, kViolation),
      method_mutant("fine", kFine, coarse_bottom_left, kViolation),
      method_mutant("fine", kFine, coarse_top_right, kViolation),
      method_mutant("fine", kFine, fine_odd, kConvention),
      method_mutant("fine", kFine, analytic, kConvention),
      method_mutant("fine", kFine, forward, kConvention),
      method_mutant("plain", kPlain, other_row, kConvention),
      method_mutant("plain", kPlain, fine_odd, kConvention),
      method_mutant("plain", kPlain, analytic, kConvention),
      method_mutant("plain", kPlain, forward, kConvention),
      method_mutant("plain", kPlain, coarse_bottom_left, kConvention),
      method_mutant("coarse", kCoarse, other_row, kConvention),
      method_mutant("coarse", kCoarse, fine, kConvention),
      method_mutant("coarse", kCoarse, fine_odd, kConvention),
      method_mutant("coarse", kCoarse, analytic, kConvention),
      method_mutant("coarse", kCoarse, forward, kConvention),
  };
  return mutants;
}

}  // namespace

std::vector<ValueMutant> derivative_mutants() {
  const std::vector<Derivative> x = {Derivative::x, Derivative::x_fine, Derivative::x_coarse};
  const std::vector<Derivative> y = {Derivative::y, Derivative::y_fine, Derivative::y_coarse};
  std::vector<Derivative> all = x;
  all.insert(all.end(), y.begin(), y.end());
  const std::set<std::string> every = {"derivative.plain", "derivative.fine", "derivative.coarse"};
  const auto one = [](const char* name, Derivative derivative, double (*change)(double),
                      const char* rule) {
    return ValueMutant{name, kSteepAndLevel, once(derivative, change), kViolation, {rule}};
  };
  std::vector<ValueMutant> mutants = method_mutants();
  for (const ValueMutant& more : {
           ValueMutant{"dFdy negated, as for y down", kSteepAndLevel, each(y, negated), kViolation,
                       every},
           ValueMutant{"quads counted from the top",
                       {"odd triangle"},
                       from_the_top,
                       kConvention,
                       {"derivative.plain: derivative.quad-rows=top-down",
                        "derivative.fine: derivative.quad-rows=top-down",
                        "derivative.coarse: derivative.quad-rows=top-down"}},
           ValueMutant{"dFdx negated", kSteepAndLevel, each(x, negated), kViolation, every},
           ValueMutant{"dFdx and dFdy swapped", kSteepAndLevel, all_fragments(swap_axes),
                       kViolation, every},
           ValueMutant{"differences of two pixels", kSteepAndLevel, each(all, twice), kViolation,
                       every},
           ValueMutant{"derivatives zero", kSteepAndLevel, each(all, zero), kViolation, every},
           ValueMutant{"derivatives half of the difference", kSteepAndLevel,
                       each(all, [](double v) { return v / 2; }), kViolation, every},
           one("dFdxFine NaN", Derivative::x_fine, nan, "derivative.fine"),
           one("dFdy NaN", Derivative::y, nan, "derivative.plain"),
           one("dFdyCoarse infinite", Derivative::y_coarse, infinite, "derivative.coarse"),
           one("dFdx infinite", Derivative::x, infinite, "derivative.plain"),
           ValueMutant{"dFdxFine a thousandth off",
                       {"linear triangle"},
                       once(Derivative::x_fine, off_by_a_thousandth),
                       kViolation,
                       {"derivative.fine"}},
           ValueMutant{"pixels outside count as black",
                       {"small triangle", "small linear triangle"},
                       uncovered_are_black,
                       kViolation,
                       {"derivative.fine"}},
           ValueMutant{"dFdxFine one ULP off",
                       kSteepAndLevel,
                       each({Derivative::x_fine}, float_above),
                       kPermitted,
                       {},
                       {"dFdxFine"}},
           ValueMutant{"all derivatives one ULP off",
                       kSteepAndLevel,
                       each(all, float_below),
                       kPermitted,
                       {},
                       {"dFdx", "dFdy", "dFdxFine", "dFdyFine", "dFdxCoarse", "dFdyCoarse"}},
           ValueMutant{"derivatives in float32",
                       kSteepAndLevel,
                       in_float32,
                       kPermitted,
                       {},
                       {"dFdx", "dFdy", "dFdxFine", "dFdyFine", "dFdxCoarse", "dFdyCoarse"}},
           ValueMutant{"a flat colour changes by 1e-6",
                       {"flat triangles last", "flat lines first"},
                       once(Derivative::x_fine, [](double v) { return v + 1e-6; }),
                       kViolation,
                       {"derivative.fine"}},
           ValueMutant{"derivatives of noperspective for smooth", kSteep,
                       shaded_with(PerspectiveChoice::never), kViolation,
                       all_of("attribute.perspective=never")},
           ValueMutant{"derivatives of smooth for noperspective",
                       {"noperspective triangle"},
                       shaded_with(PerspectiveChoice::always),
                       kViolation,
                       all_of("attribute.perspective=always")},
       })
    mutants.push_back(more);
  return mutants;
}

}  // namespace edgecase
