#include "fit/determine.hpp"

#include <cmath>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <system_error>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "input/measurement/measurement_text.hpp"
#include "quantities/text.hpp"

namespace dashpad::fit {

namespace {

using nlohmann::json;

constexpr std::string_view format_of_state = "dashpad fit state 3";
/// The state of a thousand searches for dozens of unknowns takes a hundredth of this.
constexpr std::size_t largest_state = std::size_t{64} << 20;  // bytes
constexpr std::size_t longest_reason = 1000;

json json_of(const Minimum& minimum) {
  return {{"converged", minimum.converged},
          {"why_not", minimum.why_not},
          {"x", minimum.x},
          {"misfit", minimum.misfit},
          {"is_sound", minimum.is_sound}};
}

json json_of(const ProfileEnd& end) {
  return {{"x", end.x ? json(*end.x) : json()},
          {"is_rough", end.is_rough},
          {"better", end.better ? json_of(*end.better) : json()}};
}

/// A fault of a state file that was read back.
class Damage : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

bool flag_in(const json& in, const char* key) {
  const auto found = in.find(key);
  if (found == in.end() || !found->is_boolean()) throw Damage(fmt::format("{} must be true or false", key));
  return *found;
}

/// A coordinate of a search, which runs from 0 to 1 between the bounds of its unknown.
double place_in(const json& place) {
  if (!place.is_number() || !(place.get<double>() >= 0 && place.get<double>() <= 1))
    throw Damage("x must be a number from 0 (lower bound of its unknown) to 1 (upper bound)");
  return place.get<double>();
}

/// `fewest` and `most` unknowns.
void take(const json& from, std::size_t fewest, std::size_t most, Minimum& result) {
  if (!from.is_object()) throw Damage("a search must be an object");
  result.converged = flag_in(from, "converged");
  result.is_sound = flag_in(from, "is_sound");
  const json why = from.value("why_not", json()), x = from.value("x", json()),
             misfit = from.value("misfit", json());
  if (!why.is_string() || why.get_ref<const std::string&>().size() > longest_reason)
    throw Damage("why_not must be short text");
  if (!misfit.is_number() || !std::isfinite(misfit.get<double>()) || misfit.get<double>() < 0)
    throw Damage("misfit must be a finite number, 0 or more");
  if (!x.is_array() || x.size() < fewest || x.size() > most)
    throw Damage(fmt::format("x must have {} numbers, one for each unknown", most));
  result.why_not = why;
  result.misfit = misfit;
  for (const json& place : x) result.x.push_back(place_in(place));
}

void take(const json& from, std::size_t, std::size_t unknowns, ProfileEnd& result) {
  if (!from.is_object() || !from.contains("x") || !from.contains("better"))
    throw Damage("an interval end must be an object with x and better");
  result.is_rough = flag_in(from, "is_rough");
  if (!from["x"].is_null()) result.x = place_in(from["x"]);
  if (!from["better"].is_null()) take(from["better"], unknowns, unknowns, result.better.emplace());
}

void check_piece(const std::string& name, const json& piece, std::size_t unknowns) {
  ProfileEnd end;
  if (name.find(", end ") != std::string::npos) return take(piece, unknowns, unknowns, end);
  // If an impact is left out, the shift of its pulse is no unknown.
  take(piece, name.starts_with("start ") ? unknowns : 1, unknowns, end.better.emplace());
}

/// Numbers that were changed by hand may be as plausible as those that were found.
std::string sum_of(const json& pieces) { return fingerprint({pieces.dump()}); }

/// Throws std::runtime_error if the file is not a state of this fit.
std::map<std::string, std::string> read_state(const Fit& fit, const RunOptions& options) {
  std::error_code error;  // a file that cannot be examined fails when it is read
  if (options.state.empty() ||
      std::filesystem::status(options.state, error).type() == std::filesystem::file_type::not_found)
    return {};
  const auto refuse = [&](const std::string& why) {
    throw std::runtime_error(
        fmt::format("{}: {}; give another name, or remove the file", options.state.string(), why));
  };
  const auto is_none = [&](const std::string& why) { refuse("is not a valid fit state: " + why); };
  const json state = json::parse(input::read_measurement(options.state, largest_state), nullptr, false);
  const json format = state.is_object() ? state.value("format", json()) : json();
  if (format == "dashpad fit state 1" || format == "dashpad fit state 2")
    refuse("is a fit state from an earlier version of dashpad");
  if (format != format_of_state) is_none("it is not marked as one");
  if (!state.contains("fit") || !state.contains("pieces") || !state["pieces"].is_object())
    is_none("parts of it are missing");
  if (state["fit"] != options.fingerprint)
    refuse(
        "is the state of a different fit: the fit file, a file named in it, or the version of dashpad has "
        "changed");
  const std::size_t unknowns = coordinate_count(fit);
  std::map<std::string, std::string> pieces;
  for (const auto& [key, piece] : state["pieces"].items()) {
    try {
      check_piece(key, piece, unknowns);
    } catch (const Damage& damage) {
      is_none(damage.what());
    }
    pieces[key] = piece.dump();
  }
  if (state.value("sum", json()) != sum_of(state["pieces"])) is_none("its numbers have been changed");
  return pieces;
}

/// Writes to a second file first, so that a crash leaves either the old or the new state.
void write_state(const RunOptions& options, const std::map<std::string, std::string>& kept) {
  json pieces = json::object();
  for (const auto& [name, text] : kept) pieces[name] = json::parse(text);
  const json state{
      {"format", format_of_state}, {"fit", options.fingerprint}, {"sum", sum_of(pieces)}, {"pieces", pieces}};
  const std::filesystem::path draft = options.state.string() + ".new";
  std::ofstream file(draft, std::ios::binary);
  file << state.dump(1) << "\n";
  file.close();
  std::error_code error;
  if (file) std::filesystem::rename(draft, options.state, error);
  if (!file || error) {
    const std::string reason = error ? error.message() : "cannot be written";
    std::filesystem::remove(draft, error);
    throw std::runtime_error(fmt::format("{}: {}", options.state.string(), reason));
  }
}

}  // namespace

void check_state(const Fit& fit, const RunOptions& options) { read_state(fit, options); }

Session::Session(const Fit& fit, const RunOptions& options)
    : options_(options), kept_(read_state(fit, options)) {}

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
    take(json::parse(text), 0, std::numeric_limits<std::size_t>::max(), result);
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
