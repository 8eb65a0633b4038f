#pragma once

#include "playground/session.hpp"

#include <kanexpr/symbolic/printing/latex.hpp>

#include <nlohmann/json.hpp>

#include <string>

namespace playground {

/// What the page shows of a model besides its equations: its symbols, its points and its mistake.
inline nlohmann::json description(session& of) {
  if (!of.wrong().sentence.empty())
    return {{"mistake", {{"line", of.wrong().line}, {"sentence", of.wrong().sentence}}}};
  const kanexpr::mechanics::mechanism& m = of.model().mechanism();
  const auto& known = of.moving().known();
  int place = 0;
  const auto symbols = [&](const auto& all) {
    nlohmann::json list = nlohmann::json::array();
    for (const auto& each : all) {
      list.push_back({{"name", std::string(known.names[place].view())},
                      {"latex", kanexpr::symbolic::latex(each)},
                      {"dependent", known.dependent[place]}});
      ++place;
    }
    return list;
  };
  nlohmann::json all;
  all["coordinates"] = symbols(m.coordinates);
  all["speeds"] = symbols(m.speeds);
  all["parameters"] = symbols(m.parameters);
  all["inputs"] = symbols(m.inputs);
  all["planar"] = of.figure().is_planar();
  all["points"] = nlohmann::json::array();
  for (const auto& each : m.points) all["points"].push_back(std::string(each.called.view()));
  return all;
}

} // namespace playground
