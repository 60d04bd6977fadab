#include "fit/session.hpp"

#include <fstream>
#include <sstream>
#include <system_error>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace dashpad::fit {

namespace {

using nlohmann::json;

constexpr const char* format_of_state = "dashpad fit state 2";
constexpr const char* format_before = "dashpad fit state 1";

json json_of(const Minimum& of) {
  return {{"converged", of.converged},
          {"why_not", of.why_not},
          {"x", of.x},
          {"misfit", of.misfit},
          {"is_sound", of.is_sound}};
}

Minimum minimum_of(const json& from) {
  return {from.at("converged").get<bool>(), from.at("why_not").get<std::string>(),
          from.at("x").get<std::vector<double>>(), from.at("misfit").get<double>(),
          from.at("is_sound").get<bool>()};
}

json json_of(const ProfileEnd& of) {
  return {{"x", of.x ? json(*of.x) : json()},
          {"is_rough", of.is_rough},
          {"better", of.better ? json_of(*of.better) : json()}};
}

void take(const json& from, Minimum& result) { result = minimum_of(from); }
void take(const json& from, ProfileEnd& result) {
  if (!from.at("x").is_null()) result.x = from.at("x").get<double>();
  result.is_rough = from.at("is_rough").get<bool>();
  if (!from.at("better").is_null()) result.better = minimum_of(from.at("better"));
}

/// Throws std::runtime_error for what is no state of this fit.
std::map<std::string, std::string> read_state(const RunOptions& options) {
  const std::string name = options.state.string();
  if (options.state.empty() || !std::filesystem::exists(options.state)) return {};
  std::ifstream file(options.state, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  const json state = json::parse(text.str(), nullptr, false);
  if (state.is_object() && state.value("format", json()) == format_before)
    throw std::runtime_error(name +
                             ": is the state of a fit by an earlier version of dashpad, whose searches "
                             "ended elsewhere; give another name, or remove it");
  if (!file || !state.is_object() || state.value("format", json()) != format_of_state ||
      !state.contains("fit") || !state.contains("pieces") || !state["pieces"].is_object())
    throw std::runtime_error(name + ": is no state of a fit; give another name, or remove it");
  if (state["fit"] != options.fingerprint)
    throw std::runtime_error(name +
                             ": is the state of another fit: the fit file, a file that it names, or the "
                             "version of dashpad has changed; give another name, or remove it");
  std::map<std::string, std::string> pieces;
  for (const auto& [key, piece] : state["pieces"].items()) pieces[key] = piece.dump();
  return pieces;
}

/// Beside the file first, so that a crash leaves the old or the new one.
void write_state(const RunOptions& options, const std::map<std::string, std::string>& kept) {
  json pieces = json::object();
  for (const auto& [name, text] : kept) pieces[name] = json::parse(text);
  const json state{{"format", format_of_state}, {"fit", options.fingerprint}, {"pieces", pieces}};
  const std::filesystem::path draft = options.state.string() + ".new";
  std::ofstream file(draft, std::ios::binary);
  file << state.dump(1) << "\n";
  file.close();
  std::error_code error;
  if (file) std::filesystem::rename(draft, options.state, error);
  if (!file || error) {
    const std::string reason = error ? error.message() : "it cannot be written";
    std::filesystem::remove(draft, error);
    throw std::runtime_error(fmt::format("{}: {}", options.state.string(), reason));
  }
}

}  // namespace

void check_state(const RunOptions& options) { read_state(options); }

Session::Session(const RunOptions& options) : options_(options), kept_(read_state(options)) {}

void Session::throw_if_stopped() const {
  if (!is_stopped()) return;
  const std::lock_guard lock{mutex_};
  throw Stopped(options_.state.empty() ? 0 : kept_.size());
}

void Session::begin(const char* what, std::size_t pieces) {
  const std::lock_guard lock{mutex_};
  what_ = what;
  done_ = 0;
  pieces_ = pieces;
  if (options_.progress) options_.progress(what_, done_, pieces_);
}

Minimum Session::piece(const std::string& name, const std::function<Minimum()>& compute) {
  return recalled<Minimum>(name, compute);
}

ProfileEnd Session::piece(const std::string& name, const std::function<ProfileEnd()>& compute) {
  return recalled<ProfileEnd>(name, compute);
}

template <class Result>
Result Session::recalled(const std::string& name, const std::function<Result()>& compute) {
  std::string text;
  {
    const std::lock_guard lock{mutex_};
    if (const auto found = kept_.find(name); found != kept_.end()) text = found->second;
  }
  Result result;
  if (text.empty()) {
    throw_if_stopped();
    result = compute();
    // A piece during which the wish came was cut short.
    throw_if_stopped();
    text = json_of(result).dump();
  } else {
    take(json::parse(text), result);
  }
  finished(name, text);
  return result;
}

void Session::finished(const std::string& name, const std::string& text) {
  const std::lock_guard lock{mutex_};
  if (kept_.emplace(name, text).second && !options_.state.empty()) write_state(options_, kept_);
  ++done_;
  if (options_.progress) options_.progress(what_, done_, pieces_);
}

}  // namespace dashpad::fit
