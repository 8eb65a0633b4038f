#pragma once

#include "playground/model/functions.hpp"
#include "playground/text/words.hpp"

#include <nlohmann/json.hpp>

#include <string>

namespace playground {

/// The words of lines and the functions of expressions, for the editor and the forms of the page.
inline nlohmann::json vocabulary() {
  nlohmann::json all{{"words", nlohmann::json::array()}, {"functions", nlohmann::json::array()}};
  for (const word& each : words)
    all["words"].push_back({{"word", std::string(each.called)},
                            {"pattern", std::string(each.pattern)},
                            {"group", std::string(each.group)},
                            {"meaning", std::string(each.meaning)}});
  for (const function_of_one& each : functions_of_one) all["functions"].push_back(std::string(each.called));
  for (const function_of_two& each : functions_of_two) all["functions"].push_back(std::string(each.called));
  for (const char* each : {"dot", "cross", "magnitude", "position_of", "velocity_of", "angular_velocity_of"})
    all["functions"].push_back(each);
  return all;
}

} // namespace playground
