// SPDX-License-Identifier: MIT
#include "model/fragment_operations.h"

#include "model/name_table.h"

namespace edgecase {
namespace {

constexpr Named<CompareFunction> kFunctions[] = {
    {CompareFunction::never, "never"},     {CompareFunction::less, "less"},
    {CompareFunction::equal, "equal"},     {CompareFunction::lequal, "lequal"},
    {CompareFunction::greater, "greater"}, {CompareFunction::notequal, "notequal"},
    {CompareFunction::gequal, "gequal"},   {CompareFunction::always, "always"},
};

constexpr Named<StencilOperation> kOperations[] = {
    {StencilOperation::keep, "keep"},           {StencilOperation::zero, "zero"},
    {StencilOperation::replace, "replace"},     {StencilOperation::incr, "incr"},
    {StencilOperation::incr_wrap, "incr_wrap"}, {StencilOperation::decr, "decr"},
    {StencilOperation::decr_wrap, "decr_wrap"}, {StencilOperation::invert, "invert"},
};

constexpr Named<BlendFactor> kFactors[] = {
    {BlendFactor::zero, "zero"},
    {BlendFactor::one, "one"},
    {BlendFactor::src_color, "src_color"},
    {BlendFactor::one_minus_src_color, "one_minus_src_color"},
    {BlendFactor::dst_color, "dst_color"},
    {BlendFactor::one_minus_dst_color, "one_minus_dst_color"},
    {BlendFactor::src_alpha, "src_alpha"},
    {BlendFactor::one_minus_src_alpha, "one_minus_src_alpha"},
    {BlendFactor::dst_alpha, "dst_alpha"},
    {BlendFactor::one_minus_dst_alpha, "one_minus_dst_alpha"},
    {BlendFactor::constant_color, "constant_color"},
    {BlendFactor::one_minus_constant_color, "one_minus_constant_color"},
    {BlendFactor::constant_alpha, "constant_alpha"},
    {BlendFactor::one_minus_constant_alpha, "one_minus_constant_alpha"},
    {BlendFactor::src_alpha_saturate, "src_alpha_saturate"},
};

constexpr Named<BlendEquation> kEquations[] = {
    {BlendEquation::add, "add"},
    {BlendEquation::subtract, "subtract"},
    {BlendEquation::reverse_subtract, "reverse_subtract"},
    {BlendEquation::min, "min"},
    {BlendEquation::max, "max"},
};

constexpr Named<FrontFace> kFaces[] = {
    {FrontFace::ccw, "ccw"},
    {FrontFace::cw, "cw"},
};

constexpr Named<CullMode> kCullModes[] = {
    {CullMode::none, "none"},
    {CullMode::front, "front"},
    {CullMode::back, "back"},
    {CullMode::front_and_back, "front_and_back"},
};

}  // namespace

const char* name_of(CompareFunction function) {
  return find_name(kFunctions, function);
}

const char* name_of(StencilOperation operation) {
  return find_name(kOperations, operation);
}

const char* name_of(BlendFactor factor) {
  return find_name(kFactors, factor);
}

const char* name_of(BlendEquation equation) {
  return find_name(kEquations, equation);
}

const char* name_of(FrontFace face) {
  return find_name(kFaces, face);
}

const char* name_of(CullMode mode) {
  return find_name(kCullModes, mode);
}

bool parse_name(const std::string& name, CompareFunction& value) {
  return find_value(kFunctions, name, value);
}

bool parse_name(const std::string& name, StencilOperation& value) {
  return find_value(kOperations, name, value);
}

bool parse_name(const std::string& name, BlendFactor& value) {
  return find_value(kFactors, name, value);
}

bool parse_name(const std::string& name, BlendEquation& value) {
  return find_value(kEquations, name, value);
}

bool parse_name(const std::string& name, FrontFace& value) {
  return find_value(kFaces, name, value);
}

bool parse_name(const std::string& name, CullMode& value) {
  return find_value(kCullModes, name, value);
}

bool holds(CompareFunction function, bool less, bool equal) {
  switch (function) {
    case CompareFunction::never:
      return false;
    case CompareFunction::less:
      return less;
    case CompareFunction::equal:
      return equal;
    case CompareFunction::lequal:
      return less || equal;
    case CompareFunction::greater:
      return !less && !equal;
    case CompareFunction::notequal:
      return !equal;
    case CompareFunction::gequal:
      return !less;
    case CompareFunction::always:
      return true;
  }
  return true;
}

}  // namespace edgecase
