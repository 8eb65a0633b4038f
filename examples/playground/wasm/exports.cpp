/// The functions that the page calls. Texts are UTF-8 and end in a zero byte; what a function returns is
/// valid until the next call.
#include "playground/answers/describe.hpp"
#include "playground/answers/equations.hpp"
#include "playground/answers/vocabulary.hpp"
#include "playground/session.hpp"
#include "playground/take_away/export_c.hpp"
#include "playground/take_away/export_fmu.hpp"
#include "playground/take_away/write_words.hpp"

#include <cstdlib>
#include <memory>
#include <string>

namespace {

std::unique_ptr<playground::session> open_session;
std::string answer;

const char* answered(const nlohmann::json& with) {
  answer = with.dump();
  return answer.c_str();
}

const char* answered(const playground::files& with) {
  nlohmann::json all{{"mistake", with.mistake}, {"files", nlohmann::json::array()}};
  for (const auto& each : with.all) all["files"].push_back({{"path", each.path}, {"text", each.text}});
  return answered(all);
}

} // namespace

#define EXPORT(name) extern "C" __attribute__((export_name(#name)))

EXPORT(allocate) void* allocate(std::size_t bytes) { return std::malloc(bytes); }
EXPORT(release) void release(void* at) { std::free(at); }

EXPORT(vocabulary) const char* vocabulary() { return answered(playground::vocabulary()); }

EXPORT(read) const char* read_model(const char* text) {
  auto next = std::make_unique<playground::session>(text);
  const nlohmann::json described = playground::description(*next);
  if (next->wrong().sentence.empty()) open_session = std::move(next); // otherwise the last model stays
  return answered(described);
}

EXPORT(equations) const char* equations(int are_linearized, int shown) {
  return answered(
      playground::equations(*open_session, are_linearized != 0, static_cast<playground::entries>(shown)));
}

// The numbers of the open model, which the page reads and writes in place.
EXPORT(state) double* state() { return open_session->moving().x.data(); }
EXPORT(parameters) double* parameters() { return open_session->moving().p.data(); }
EXPORT(inputs) double* inputs() { return open_session->moving().r.data(); }
EXPORT(time) double time_of_model() { return open_session->moving().t; }
EXPORT(set_time) void set_time(double t) { open_session->moving().t = t; }
EXPORT(kinetic_energy) double kinetic_energy() { return open_session->moving().energy()(0); }
EXPORT(potential_energy) double potential_energy() { return open_session->moving().energy()(1); }

EXPORT(satisfy_constraints) int satisfy_constraints() { return open_session->moving().satisfy_constraints(); }
EXPORT(advance) const char* advance(double duration, double longest) {
  answer = open_session->moving().advance(duration, longest);
  return answer.c_str();
}

EXPORT(svg) const char* svg(int has_labels) {
  answer = open_session->figure().svg(has_labels != 0);
  return answer.c_str();
}
EXPORT(points) const double* points() {
  static Eigen::Matrix2Xd places;
  places = open_session->figure().points();
  return places.data();
}
EXPORT(drag) void drag(int point, double across, double down) {
  open_session->figure().drag(point, across, down);
}
EXPORT(turn) void turn(double azimuth, double elevation) { open_session->figure().turn(azimuth, elevation); }

EXPORT(take_words) const char* take_words(const char* name) {
  return answered(playground::write_words(*open_session, name));
}
EXPORT(take_c) const char* take_c(const char* name) {
  return answered(playground::export_c(*open_session, name));
}
EXPORT(take_fmu) const char* take_fmu(const char* name) {
  return answered(playground::export_fmu(*open_session, name));
}
