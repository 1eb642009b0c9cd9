#pragma once

/// @file An integrator by name, with its parameters.

#include <string>
#include <utility>
#include <vector>

#include "murosimf/linking/parameters.h"

namespace murosimf::motion {

struct Method {
  std::string name;
  std::vector<std::pair<std::string, double>> parameters;

  Method(const char* called) : name(called) {}         // NOLINT: most have no parameters
  Method(const std::string& called) : name(called) {}  // NOLINT
  Method(std::string called, std::vector<std::pair<std::string, double>> with)
      : name(std::move(called)), parameters(std::move(with)) {}
};

inline WrittenParameters written(const std::vector<std::pair<std::string, double>>& parameters) {
  WrittenParameters all;
  for (const auto& [name, value] : parameters) all.emplace(name, WrittenParameter{{{value}, ""}, {}});
  return all;
}

}  // namespace murosimf::motion
