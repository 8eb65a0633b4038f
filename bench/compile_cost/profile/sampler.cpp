// A plugin of g++ that shows what the compiler does with its time. Every few milliseconds of processor time,
// it notes the constexpr functions that are being evaluated; otherwise what is being instantiated, or which
// pass optimizes which function. At the end, it prints what occurred most often to the file KANEXPR_PROFILE.

#include <gcc-plugin.h>

#include <tree.h>

#include <cp/cp-tree.h>
#include <diagnostic.h>
#include <function.h>
#include <plugin-version.h>
#include <tree-pass.h>

#include <sys/time.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

int plugin_is_GPL_compatible;

namespace {

constexpr int most_samples = 1 << 17, deepest = 48, microseconds = 1000;

/// What the compiler did at one moment.
struct sample {
  int depth = 0; ///< of constexpr functions, the outermost one first; 0 outside constant evaluation
  tree function[deepest]{};
  tree instantiated{}; ///< by the file itself, not by another instantiation
  const char* pass{};
  tree optimized{};
};

sample* samples;
int count = 0, lost = 0;

tree function_of(tree call) {
  if (call == NULL_TREE || (TREE_CODE(call) != CALL_EXPR && TREE_CODE(call) != AGGR_INIT_EXPR))
    return NULL_TREE;
  tree function = TREE_CODE(call) == CALL_EXPR ? CALL_EXPR_FN(call) : AGGR_INIT_EXPR_FN(call);
  if (function != NULL_TREE && TREE_CODE(function) == ADDR_EXPR) function = TREE_OPERAND(function, 0);
  return function != NULL_TREE && TREE_CODE(function) == FUNCTION_DECL ? function : NULL_TREE;
}

/// Notes the calls that are being evaluated. g++ tells them only if there was a call since they were last
/// asked for; if not, they are the same, provided that there are still as many.
bool note_constant_evaluation(sample& now) {
  static vec<tree> before = vNULL;
  static int depth_before = 0;
  static sample last;
  const vec<tree> calls = cx_error_context();
  if (calls.is_empty()) {
    if (depth_before == 0 || static_cast<int>(before.length()) != depth_before) return false;
    now = last;
    return true;
  }
  before = calls;
  depth_before = static_cast<int>(calls.length());
  now.depth = std::min(depth_before, deepest);
  for (int i = 0; i < now.depth; ++i) now.function[i] = function_of(calls[static_cast<unsigned>(i)]);
  now.function[now.depth - 1] = function_of(calls[static_cast<unsigned>(depth_before - 1)]);
  last = now;
  return true;
}

void take(int) {
  if (count == most_samples) {
    ++lost;
    return;
  }
  sample now;
  if (!note_constant_evaluation(now)) {
    if (tinst_level* level = current_instantiation()) {
      while (level->next != nullptr) level = level->next;
      now.instantiated = level->tldcl;
    } else if (current_pass != nullptr) {
      now.pass = current_pass->name;
      now.optimized = current_function_decl;
    }
  }
  samples[count++] = now;
}

/// Keeps what the samples refer to.
void mark(void*, void*) {
  for (int i = 0; i < count; ++i) {
    for (int k = 0; k < samples[i].depth; ++k)
      if (samples[i].function[k] != NULL_TREE) gt_ggc_mx_tree_node(samples[i].function[k]);
    if (samples[i].instantiated != NULL_TREE) gt_ggc_mx_tree_node(samples[i].instantiated);
    if (samples[i].optimized != NULL_TREE) gt_ggc_mx_tree_node(samples[i].optimized);
  }
}

std::string entity(tree t) {
  if (t != NULL_TREE && TREE_CODE(t) == TREE_LIST) t = TREE_PURPOSE(t);
  if (t == NULL_TREE) return "?";
  std::string name = TYPE_P(t)   ? type_as_string(t, 0)
                     : DECL_P(t) ? decl_as_string(t, TFF_DECL_SPECIFIERS)
                                 : "?";
  constexpr std::size_t longest = 150;
  if (name.size() > longest) name = name.substr(0, longest) + "...";
  return name;
}

std::string place(tree function) {
  if (function == NULL_TREE) return "?";
  const expanded_location at = expand_location(DECL_SOURCE_LOCATION(function));
  std::string file = at.file != nullptr ? at.file : "?";
  if (const std::size_t begin = file.rfind("/include/"); begin != std::string::npos)
    file = file.substr(begin + 9);
  const tree name = DECL_NAME(function), within = DECL_CONTEXT(function);
  std::string text = name != NULL_TREE ? IDENTIFIER_POINTER(name) : "?";
  if (within != NULL_TREE && TYPE_P(within) && TYPE_IDENTIFIER(within) != NULL_TREE)
    text = std::string(IDENTIFIER_POINTER(TYPE_IDENTIFIER(within))) + "::" + text;
  return text + "  " + file + ":" + std::to_string(at.line);
}

using tally = std::map<std::string, int>;

void print(std::FILE* out, const char* title, const tally& counted, std::size_t most) {
  std::vector<std::pair<int, std::string>> all;
  int sum = 0;
  for (const auto& [name, times] : counted) all.emplace_back(times, name), sum += times;
  std::sort(all.rbegin(), all.rend());
  std::fprintf(out, "\n%s\n", title);
  for (std::size_t i = 0; i < all.size() && i < most; ++i)
    std::fprintf(out, "%6.1f %%  %s\n", 100.0 * all[i].first / count, all[i].second.c_str());
}

void report(void*, void*) {
  std::signal(SIGPROF, SIG_IGN);
  const char* const path = std::getenv("KANEXPR_PROFILE");
  std::FILE* const out = path != nullptr ? std::fopen(path, "w") : nullptr;
  if (out == nullptr || count == 0) return;
  tally kinds, own, within, roots, instantiated, passes, optimized;
  std::map<tree, std::string> places;
  const auto place_of = [&](tree function) -> const std::string& {
    auto known = places.find(function);
    if (known == places.end()) known = places.emplace(function, place(function)).first;
    return known->second;
  };
  for (int i = 0; i < count; ++i) {
    const sample& each = samples[i];
    if (each.depth > 0) {
      ++kinds["constant evaluation"];
      ++own[place_of(each.function[each.depth - 1])];
      ++roots[entity(each.function[0])];
      std::set<std::string> once;
      for (int k = 0; k < each.depth; ++k) once.insert(place_of(each.function[k]));
      for (const std::string& name : once) ++within[name];
    } else if (each.instantiated != NULL_TREE) {
      ++kinds["instantiation"];
      ++instantiated[entity(each.instantiated)];
    } else if (each.pass != nullptr) {
      ++kinds["optimization and output"];
      ++passes[each.pass];
      ++optimized[entity(each.optimized)];
    } else {
      ++kinds["reading, and collecting garbage"];
    }
  }
  std::fprintf(out, "%d samples, %d lost\n", count, lost);
  print(out, "All", kinds, 4);
  print(out, "Constant evaluation, by function itself", own, 30);
  print(out, "Constant evaluation, by function with all that it calls", within, 40);
  print(out, "Constant evaluation, by what it begins with", roots, 20);
  print(out, "Instantiation, by what the file itself needs", instantiated, 20);
  print(out, "Optimization, by pass", passes, 15);
  print(out, "Optimization, by function", optimized, 15);
  std::fclose(out);
}

} // namespace

int plugin_init(plugin_name_args* plugin, plugin_gcc_version* version) {
  if (!plugin_default_version_check(version, &gcc_version)) return 1;
  samples = new sample[most_samples];
  register_callback(plugin->base_name, PLUGIN_GGC_MARKING, mark, nullptr);
  register_callback(plugin->base_name, PLUGIN_FINISH, report, nullptr);
  struct sigaction action{};
  action.sa_handler = take;
  action.sa_flags = SA_RESTART;
  sigaction(SIGPROF, &action, nullptr);
  const itimerval every{{0, microseconds}, {0, microseconds}};
  return setitimer(ITIMER_PROF, &every, nullptr);
}
