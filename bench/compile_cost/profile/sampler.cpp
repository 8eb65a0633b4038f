// A plugin of g++ that shows what the compiler does with its time. Every few milliseconds of processor time,
// it notes the constexpr functions that are being evaluated; otherwise what is being instantiated, or which
// pass optimizes which function. At the end, it prints what occurred most often to the file KANEXPR_PROFILE.
// The kernel may take fewer samples than requested; each stands for an equal part of the time that was
// measured.

#include <gcc-plugin.h>

#include <tree.h>

#include <cp/cp-tree.h>
#include <diagnostic.h>
#include <function.h>
#include <plugin-version.h>
#include <tree-pass.h>

#include <sys/resource.h>
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

constexpr int most_samples = 1 << 17, fewest = 3, deepest = 48, microseconds = 1000;

/// What the compiler did at one moment.
struct sample {
  int depth = 0; ///< of constexpr functions, the outermost one first; 0 outside constant evaluation
  tree function[deepest]{};
  tree instantiated{}; ///< by the file itself, not by another instantiation
  const char* pass{};
  tree optimized{};
};

std::vector<sample> samples; ///< has its memory from the beginning: the signal handler must not allocate
int lost = 0;
double seconds_before = 0; ///< of processor time, when the first sample could be taken

/// What g++ is doing around an evaluation, which does not change before it ends.
struct surroundings {
  location_t location = input_location;
  const tinst_level* instantiation = current_instantiation();
  tree function = current_function_decl;
  const opt_pass* pass = current_pass;
  bool operator==(const surroundings&) const = default;
};

tree function_of(tree call) {
  if (call == NULL_TREE || (TREE_CODE(call) != CALL_EXPR && TREE_CODE(call) != AGGR_INIT_EXPR))
    return NULL_TREE;
  tree function = TREE_CODE(call) == CALL_EXPR ? CALL_EXPR_FN(call) : AGGR_INIT_EXPR_FN(call);
  if (function != NULL_TREE && TREE_CODE(function) == ADDR_EXPR) function = TREE_OPERAND(function, 0);
  return function != NULL_TREE && TREE_CODE(function) == FUNCTION_DECL ? function : NULL_TREE;
}

/// Notes the calls that are being evaluated. g++ tells them only if one began or ended since they were last
/// asked for. If none did, they are those of the sample before, provided that the surroundings are the same.
bool note_constant_evaluation(sample& now) {
  static surroundings before;
  const surroundings around;
  const vec<tree> calls = cx_error_context();
  if (calls.is_empty()) {
    if (samples.empty() || samples.back().depth == 0 || around != before) return false;
    now = samples.back();
    return true;
  }
  before = around;
  const int depth = static_cast<int>(calls.length());
  now.depth = std::min(depth, deepest);
  for (int i = 0; i < now.depth; ++i) now.function[i] = function_of(calls[static_cast<unsigned>(i)]);
  now.function[now.depth - 1] = function_of(calls[static_cast<unsigned>(depth - 1)]);
  return true;
}

void take(int) {
  if (samples.size() == most_samples) {
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
  samples.push_back(now);
}

/// Keeps what the samples refer to.
void mark(void*, void*) {
  for (const sample& each : samples) {
    for (int k = 0; k < each.depth; ++k)
      if (each.function[k] != NULL_TREE) gt_ggc_mx_tree_node(each.function[k]);
    if (each.instantiated != NULL_TREE) gt_ggc_mx_tree_node(each.instantiated);
    if (each.optimized != NULL_TREE) gt_ggc_mx_tree_node(each.optimized);
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

/// Without arguments, so that the instances of a template have the same name; g++ names lambdas and
/// constructors by words of its own, such as `._anon_942::operator()` and `__ct_comp `.
std::string name_of(tree function) {
  if (LAMBDA_FUNCTION_P(function)) return "lambda";
  const tree name = DECL_NAME(function), within = DECL_CONTEXT(function);
  std::string text = DECL_CONSTRUCTOR_P(function)  ? "constructor"
                     : DECL_DESTRUCTOR_P(function) ? "destructor"
                     : name != NULL_TREE           ? IDENTIFIER_POINTER(name)
                                                   : "?";
  if (within != NULL_TREE && TYPE_P(within) && TYPE_IDENTIFIER(within) != NULL_TREE)
    text = std::string(IDENTIFIER_POINTER(TYPE_IDENTIFIER(within))) + "::" + text;
  return text;
}

std::string place(tree function) {
  if (function == NULL_TREE) return "?";
  const expanded_location at = expand_location(DECL_SOURCE_LOCATION(function));
  std::string file = at.file != nullptr ? at.file : "?";
  if (const std::size_t begin = file.rfind("/include/"); begin != std::string::npos)
    file = file.substr(begin + 9);
  return name_of(function) + "  " + file + ":" + std::to_string(at.line);
}

using tally = std::map<std::string, int>;

rusage used() {
  rusage all{};
  getrusage(RUSAGE_SELF, &all);
  return all;
}

double seconds_of(const rusage& all) {
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(all.ru_utime) + seconds(all.ru_stime);
}

/// The time in which the samples were taken.
struct duration {
  double samples, seconds;
};

/// Prints what occurred at least `least` times: rare things differ from run to run.
void print(std::FILE* out, duration all, const char* title, const tally& counted, std::size_t most,
           int least = fewest) {
  std::vector<std::pair<int, std::string>> rows;
  for (const auto& [name, times] : counted)
    if (times >= least) rows.emplace_back(times, name);
  if (rows.empty()) return;
  std::sort(rows.rbegin(), rows.rend());
  std::fprintf(out, "\n%s\n", title);
  for (std::size_t i = 0; i < rows.size() && i < most; ++i) {
    const double part = rows[i].first / all.samples;
    std::fprintf(out, "%6.1f %% %7.2f s  %s\n", 100 * part, part * all.seconds, rows[i].second.c_str());
  }
}

void report(void*, void*) {
  std::signal(SIGPROF, SIG_IGN);
  const rusage all_used = used();
  const char* const path = std::getenv("KANEXPR_PROFILE");
  std::FILE* const out = path != nullptr ? std::fopen(path, "w") : nullptr;
  if (out == nullptr) return;
  tally kinds, own, within, roots, instantiated, passes, optimized;
  // a name of thousands of template arguments takes long
  std::map<tree, std::string> places, entities;
  const auto known = [](std::map<tree, std::string>& all, tree t, auto name) -> const std::string& {
    auto found = all.find(t);
    if (found == all.end()) found = all.emplace(t, name(t)).first;
    return found->second;
  };
  const auto place_of = [&](tree function) -> const std::string& { return known(places, function, place); };
  const auto entity_of = [&](tree t) -> const std::string& { return known(entities, t, entity); };
  for (const sample& each : samples) {
    if (each.depth > 0) {
      ++kinds["constant evaluation"];
      ++own[place_of(each.function[each.depth - 1])];
      ++roots[entity_of(each.function[0])];
      std::set<std::string> once;
      for (int k = 0; k < each.depth; ++k) once.insert(place_of(each.function[k]));
      for (const std::string& name : once) ++within[name];
    } else if (each.instantiated != NULL_TREE) {
      ++kinds["instantiation"];
      ++instantiated[entity_of(each.instantiated)];
    } else if (each.pass != nullptr) {
      ++kinds["optimization and output"];
      ++passes[each.pass];
      ++optimized[entity_of(each.optimized)];
    } else {
      ++kinds["reading, and collecting garbage"];
    }
  }
  const double seconds = seconds_of(all_used) - seconds_before, kept = static_cast<double>(samples.size());
  std::fprintf(out, "%zu samples in %.2f s of processor time; at most %ld MB of memory\n", samples.size(),
               seconds, all_used.ru_maxrss / 1024);
  if (lost > 0) std::fprintf(out, "the rows are those of the first samples; %d more did not fit\n", lost);
  const duration all{kept, seconds * kept / (kept + lost)};
  print(out, all, "All", kinds, 4, 1);
  print(out, all, "Constant evaluation, by function itself", own, 30);
  print(out, all, "Constant evaluation, by function with all that it calls", within, 40);
  print(out, all, "Constant evaluation, by what it begins with", roots, 20);
  print(out, all, "Instantiation, by what the file itself needs", instantiated, 20);
  print(out, all, "Optimization, by pass", passes, 15);
  print(out, all, "Optimization, by function", optimized, 15);
  std::fclose(out);
}

} // namespace

int plugin_init(plugin_name_args* plugin, plugin_gcc_version* version) {
  if (!plugin_default_version_check(version, &gcc_version)) return 1;
  samples.reserve(most_samples);
  seconds_before = seconds_of(used());
  register_callback(plugin->base_name, PLUGIN_GGC_MARKING, mark, nullptr);
  register_callback(plugin->base_name, PLUGIN_FINISH, report, nullptr);
  struct sigaction action{};
  action.sa_handler = take;
  action.sa_flags = SA_RESTART;
  sigaction(SIGPROF, &action, nullptr);
  const itimerval every{{0, microseconds}, {0, microseconds}};
  return setitimer(ITIMER_PROF, &every, nullptr);
}
