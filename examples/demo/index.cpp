#include "demo/parts.hpp"

#include <cstdio>
#include <fstream>

/// The page that lists everything in the folder of the demo.
namespace demo {

namespace {

constexpr const char* head = R"(<!doctype html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>kanexpr: systems of the demo</title>
<style>
  :root { color-scheme: light dark; --ink: #1e2328; --quiet: #5b6570; --paper: #f6f7f8; --card: #fff; --line: #dfe3e7;
    --accent: #1f5fa8; }
  @media (prefers-color-scheme: dark) { :root { --ink: #e4e7eb; --quiet: #9aa4ae; --paper: #101316; --card: #181c20;
    --line: #2b3138; --accent: #7fb2e5; } }
  * { box-sizing: border-box; }
  body { margin: 0 auto; max-width: 76rem; padding: 2rem 1.25rem 3rem; background: var(--paper); color: var(--ink);
    font: 1rem/1.5 system-ui, sans-serif; }
  h1 { margin: 0; font-size: 1.6rem; }
  header p { margin: 0.3rem 0 1.6rem; color: var(--quiet); max-width: 44rem; }
  main { display: grid; gap: 1.1rem; grid-template-columns: repeat(auto-fill, minmax(min(100%, 21rem), 1fr)); }
  article { display: flex; flex-direction: column; background: var(--card); border: 1px solid var(--line);
    border-radius: 0.7rem; overflow: hidden; }
  article > a { display: block; border-bottom: 1px solid var(--line); }
  article > a.plot { background: #fff; }
  img { display: block; width: 100%; height: 15rem; object-fit: contain; padding: 0.8rem; }
  h2 { margin: 0.9rem 1rem 0; font-size: 1.1rem; }
  article p { margin: 0.3rem 1rem 0.8rem; color: var(--quiet); flex: 1; }
  nav { display: flex; flex-wrap: wrap; gap: 0.5rem; padding: 0 1rem 1rem; }
  nav a { padding: 0.25rem 0.75rem; border: 1px solid var(--line); border-radius: 1rem; color: var(--accent);
    text-decoration: none; font-size: 0.9rem; }
  nav a:hover, nav a:focus-visible { border-color: var(--accent); }
</style>
<header>
<h1>Systems of the demo</h1>
<p>Each system is one model. Its equations, its figure and its moving picture all follow from it.</p>
</header>
<main>
)";

bool is_plot(const exhibit& e) { return e.links.empty(); }

void write(std::ostream& out, const exhibit& e) {
  const std::string first = is_plot(e) ? e.figure : e.links.front().file;
  out << "<article>\n<a href=\"" << first << '"' << (is_plot(e) ? " class=\"plot\"" : "") << "><img src=\""
      << e.figure << "\" alt=\"" << e.title << "\"></a>\n<h2>" << e.title << "</h2>\n<p>" << e.text
      << "</p>\n";
  if (!is_plot(e)) {
    out << "<nav>\n";
    for (const exhibit::link& each : e.links)
      out << "<a href=\"" << each.file << "\">" << each.words << "</a>\n";
    out << "</nav>\n";
  }
  out << "</article>\n";
}

} // namespace

bool write_index(const std::string& folder, const std::vector<exhibit>& all) {
  const std::string path = folder + "/index.html";
  std::ofstream out(path, std::ios::binary);
  out << head;
  for (const exhibit& each : all) write(out, each);
  out << "</main>\n</html>\n";
  out.close();
  if (!out) std::fprintf(stderr, "%s cannot be written\n", path.c_str());
  return static_cast<bool>(out);
}

} // namespace demo
