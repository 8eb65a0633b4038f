#pragma once

#include <algorithm>
#include <string>
#include <string_view>

namespace kanexpr::exporting::unsupported_in_c {

/// A function that FMI 3.0 requires, and the types of its arguments after the instance.
struct unsupported {
  std::string_view name{};
  std::string_view given{}; ///< separated by `|`
};

/// `T` is replaced by each value type that no variable has.
inline constexpr unsupported of_each_type[]{
    {"fmi3Get", "const fmi3ValueReference *|size_t|T *|size_t"},
    {"fmi3Set", "const fmi3ValueReference *|size_t|const T *|size_t"},
};

inline constexpr unsupported types_of_values[]{
    {"Float32", "float"},   {"Int8", "int8_t"},   {"UInt8", "uint8_t"},   {"Int16", "int16_t"},
    {"UInt16", "uint16_t"}, {"Int32", "int32_t"}, {"UInt32", "uint32_t"}, {"Int64", "int64_t"},
    {"UInt64", "uint64_t"}, {"Boolean", "bool"},
};

inline constexpr unsupported others[]{
    {"fmi3GetString", "const fmi3ValueReference *|size_t|const char **|size_t"},
    {"fmi3SetString", "const fmi3ValueReference *|size_t|const char *const *|size_t"},
    {"fmi3GetBinary", "const fmi3ValueReference *|size_t|size_t *|const uint8_t **|size_t"},
    {"fmi3SetBinary", "const fmi3ValueReference *|size_t|const size_t *|const uint8_t *const *|size_t"},
    {"fmi3GetClock", "const fmi3ValueReference *|size_t|bool *"},
    {"fmi3SetClock", "const fmi3ValueReference *|size_t|const bool *"},
    {"fmi3GetNumberOfVariableDependencies", "fmi3ValueReference|size_t *"},
    {"fmi3GetVariableDependencies", "fmi3ValueReference|size_t *|fmi3ValueReference *|size_t *|int *|size_t"},
    {"fmi3GetFMUState", "void **"},
    {"fmi3SetFMUState", "void *"},
    {"fmi3FreeFMUState", "void **"},
    {"fmi3SerializedFMUStateSize", "void *|size_t *"},
    {"fmi3SerializeFMUState", "void *|uint8_t *|size_t"},
    {"fmi3DeserializeFMUState", "const uint8_t *|size_t|void **"},
    {"fmi3EnterConfigurationMode", ""},
    {"fmi3ExitConfigurationMode", ""},
    {"fmi3GetIntervalDecimal", "const fmi3ValueReference *|size_t|double *|int *"},
    {"fmi3GetIntervalFraction", "const fmi3ValueReference *|size_t|uint64_t *|uint64_t *|int *"},
    {"fmi3GetShiftDecimal", "const fmi3ValueReference *|size_t|double *"},
    {"fmi3GetShiftFraction", "const fmi3ValueReference *|size_t|uint64_t *|uint64_t *"},
    {"fmi3SetIntervalDecimal", "const fmi3ValueReference *|size_t|const double *"},
    {"fmi3SetIntervalFraction", "const fmi3ValueReference *|size_t|const uint64_t *|const uint64_t *"},
    {"fmi3SetShiftDecimal", "const fmi3ValueReference *|size_t|const double *"},
    {"fmi3SetShiftFraction", "const fmi3ValueReference *|size_t|const uint64_t *|const uint64_t *"},
    {"fmi3EnterStepMode", ""},
    {"fmi3GetOutputDerivatives", "const fmi3ValueReference *|size_t|const int32_t *|double *|size_t"},
    {"fmi3ActivateModelPartition", "fmi3ValueReference|double"},
};

/// A function that only reports that it is not supported. `T` in its arguments is replaced by `of_values`.
inline std::string refusal(const std::string& name, std::string_view given, std::string_view of_values = {}) {
  std::string signature = "EXPORTED fmi3Status " + name + "(void *of", unused;
  for (char letter = 'a'; !given.empty(); ++letter) {
    std::string type(given.substr(0, given.find('|')));
    given.remove_prefix((std::min)(type.size() + 1, given.size()));
    if (const std::size_t at = type.find('T'); at != type.npos && !of_values.empty())
      type.replace(at, 1, of_values);
    signature += ", " + type + (type.back() == '*' ? "" : " ") + letter;
    unused += std::string("  (void)") + letter + ";\n";
  }
  return signature + ") {\n" + unused + "  return say((const instance *)of, fmi3Error, \"" + name +
         " is not supported\");\n}\n";
}

inline std::string all_refusals() {
  std::string text = "\n/* Functions of FMI that are not supported. */\n";
  for (const unsupported& type : types_of_values)
    for (const unsupported& each : of_each_type)
      text += refusal(std::string(each.name) + std::string(type.name), each.given, type.given);
  for (const unsupported& each : others) text += refusal(std::string(each.name), each.given);
  return text;
}

} // namespace kanexpr::exporting::unsupported_in_c
