/// A step of columns under strain, computed or moved by series, their replay, and sums over them, for a
/// number type N.
///
/// Included as text, like src/model/pad/formulas.hpp and after it. Register<N> loads and stores.

/// A and w of columns.
template <class N>
struct ShapeAndMeasure {
  N shape;
  N measure;
};

/// Stress (theory.md, Eq. 9) and stress over A (Eq. 20) of each column. strain_part(j, strains, part, at)
/// sets what the strain alone determines from the j-th column on, or returns false if it cannot; returns the
/// number of columns up to there.
template <class N, class Law, class StrainPart>
std::size_t stress_columns(const Formulas<Law>& formulas, const SweepStep& step, const Columns& now,
                           const Columns& next, StrainPart&& strain_part) {
  using R = Register<N>;
  constexpr std::size_t parts = Formulas<Law>::parts;
  static_assert(parts <= Columns::max_parts, "no room in a column for this many values of a strain part");
  const N per_thickness(1 / step.thickness);
  const N least(min_strain);
  const bool loading = step.after > step.before;
  const N per_advance(loading ? 1 / (step.after - step.before) : 0);
  for (std::size_t j = step.first; j < step.count; j += R::size()) {
    const N depth = R::load(step.depth + j);
    const N strain = max((step.after - depth) * per_thickness, least);
    const N complement = ((step.thickness - step.after) + depth) * per_thickness;
    const N before = max((step.before - depth) * per_thickness, least);
    const N largest = max((step.largest - depth) * per_thickness, least);
    N part[parts];
    ShapeAndMeasure<N> at;
    if (!strain_part(j, Strains<N>{strain, complement}, part, at)) return j;
    N part_before[parts];
    for (std::size_t k = 0; k < parts; ++k) part_before[k] = R::load(now.part[k] + j);
    N share(1.0);
    if (loading) share = min(share, (step.after - depth) * per_advance);
    N stress;
    if constexpr (carries_branches<Law, N>) {
      stress = formulas.carry(part_before, part, share);
    } else {
      const N stress_before = R::load(now.stress + j);
      const N envelope = formulas.envelope(part, strain, largest);
      if constexpr (steps_itself<Law, N>) {
        stress = formulas.step(stress_before, part_before, part, share);
      } else {
        const N remainder = stress_before - formulas.envelope(part_before, before, largest);
        stress = remainder * formulas.decay(before, strain, share) + envelope;
      }
      // A column in tension does not press again while its envelope is in tension (theory.md, Eq. 7).
      const N zero(0.0);
      stress = select(both(stress_before <= zero, envelope < zero), min(stress, zero), stress);
    }
    R::store(stress, next.stress + j);
    for (std::size_t k = 0; k < parts; ++k) R::store(part[k], next.part[k] + j);
    R::store(at.shape, next.shape + j);
    R::store(at.measure, next.measure + j);
    // Stress over A of a column in tension that has just been met again has no bound of its own.
    R::store(max(stress / at.shape, N(-1e100)), next.ratio + j);
  }
  return step.count;
}

template <class N, class Law>
void step_columns(const Law& law, const PowerShape& power, const typename Law::RatePart& rate,
                  const typename Law::TimePart& time, const SweepStep& step, const Columns& now,
                  const Columns& next, const StrainSeries* to) {
  using R = Register<N>;
  constexpr std::size_t parts = Formulas<Law>::parts;
  const Formulas<Law> formulas{law, power, rate, time};
  const auto strain_part = [&](std::size_t j, Strains<N> e, N* part, ShapeAndMeasure<N>& at) {
    Series<N> series[parts];
    const Shape<Series<N>> shape = formulas.strain_part(
        Strains<Series<N>>{{e.value, N(1.0), N(0.0)}, {e.complement, N(-1.0), N(0.0)}}, series);
    for (std::size_t k = 0; k < parts; ++k) part[k] = series[k].value;
    const Shape<N> value{shape.shape.value, shape.log_strain.value, shape.log_complement.value};
    at = {value.shape, measure_of(formulas, e, value)};
    if (!to) return true;
    for (std::size_t k = 0; k < parts; ++k) {
      R::store(series[k].first, to->part_first[k] + j);
      R::store(series[k].second, to->part_second[k] + j);
    }
    R::store(shape.shape.first, to->shape_first + j);
    R::store(shape.shape.second, to->shape_second + j);
    return true;
  };
  static_cast<void>(stress_columns<N>(formulas, step, now, next, strain_part));
}

template <class N, class Law>
std::size_t move_columns(const Law& law, const PowerShape& power, const typename Law::RatePart& rate,
                         const typename Law::TimePart& time, const SweepStep& step, const Columns& now,
                         const Columns& next, const MovedStep& move, const Columns& tried,
                         const StrainSeries& from) {
  using R = Register<N>;
  const Formulas<Law> formulas{law, power, rate, time};
  const double x = move.further;
  const N square(x * x);
  const N limit(move.max_bend);
  const auto suffices = [&](N value, N bend) {
    return max(bend, 0.0 - bend) <= limit * max(value, 0.0 - value);
  };
  const auto strain_part = [&](std::size_t j, Strains<N>, N* part, ShapeAndMeasure<N>& at) {
    const N shape = R::load(tried.shape + j);
    const N first = R::load(from.shape_first + j);
    // Lanes beyond the columns do not count.
    const auto bend_of = [&](const double* second) {
      return R::first(step.count - j, square * R::load(second + j));
    };
    const N bend = bend_of(from.shape_second);
    auto all_suffice = suffices(shape, bend);
    for (std::size_t k = 0; k < Formulas<Law>::parts; ++k) {
      const N value = R::load(tried.part[k] + j);
      const N bend_of_part = bend_of(from.part_second[k]);
      all_suffice = both(all_suffice, suffices(value, bend_of_part));
      part[k] = value + x * R::load(from.part_first[k] + j) + bend_of_part;
    }
    // dw = A d(strain).
    at = {shape + x * first + bend,
          R::load(tried.measure + j) + x * (shape + 0.5 * (x * first) + (1.0 / 3) * bend)};
    return all(all_suffice);
  };
  return stress_columns<N>(formulas, step, now, next, strain_part);
}

template <class N>
void replay_columns(const PowerShape& power, const LoadingStep* first, const LoadingStep* last,
                    const SweepStep& step, const Columns& columns) {
  using R = Register<N>;
  const N per_thickness(1 / step.thickness);
  for (std::size_t j = 0; j < step.count; j += R::size()) {
    const N depth = R::load(step.depth + j);
    const auto strains_at = [&](double penetration) {
      return Strains<N>{max((penetration - depth) * per_thickness, N(min_strain)),
                        ((step.thickness - penetration) + depth) * per_thickness};
    };
    N stress(0.0);
    N shape(0.0);
    for (const LoadingStep* now = first; now != last; ++now) {
      // The first of these columns is the innermost, which is touched first.
      if (now->penetration <= step.depth[j]) continue;
      const N modulus(now->modulus);
      const Strains<N> e = strains_at(now->penetration);
      const N shape_after = select(e.value <= min_strain, N(0.0), shape_at(power, e).shape);
      stress = (stress - modulus * shape) * now->decay + modulus * shape_after;
      shape = shape_after;
    }
    const Strains<N> e = strains_at(step.after);
    const Shape<N> at = shape_at(power, e);
    R::store(stress, columns.stress + j);
    R::store(at.shape, columns.part[0] + j);
    R::store(at.shape, columns.shape + j);
    R::store(measure_at(power, e, at), columns.measure + j);
    R::store(stress / at.shape, columns.ratio + j);
  }
}

/// Sum of term(j) for j < count, in the same order for any number of lanes: as four sums of each fourth term.
template <class N, class Term>
double sum_of(std::size_t count, Term&& term) {
  using R = Register<N>;
  constexpr std::size_t sums = 4;
  std::array<double, sums> sum{};
  for (std::size_t k = 0; k < sums; k += R::size()) {
    N each(0.0);
    for (std::size_t j = k; j < count; j += sums) each = each + R::first(count - j, term(j));
    R::store(each, &sum[k]);
  }
  return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

template <class N>
double sum_cells(const Columns& columns, const CellWeights& weights, std::size_t cells) {
  using R = Register<N>;
  return sum_of<N>(cells, [&](std::size_t j) {
    const N mean = positive_mean(R::load(columns.ratio + j) * R::load(weights.inner + j),
                                 R::load(columns.ratio + j + 1) * R::load(weights.outer + j));
    const N width = R::load(columns.measure + j) - R::load(columns.measure + j + 1);
    return mean * width;
  });
}

template <class N, class Law>
double sum_held(const Law& law, const PowerShape& power, double time, const SweepStep& step,
                const CellWeights& weights, const Columns& columns, double& edge) {
  using R = Register<N>;
  const Formulas<Law> still{law, power, law.rate_part(0), {}};
  constexpr std::size_t parts = Formulas<Law>::parts;
  const N rate(law.relaxation_rate(time));
  const N per_thickness(1 / step.thickness);
  const N zero(0.0);
  for (std::size_t j = 0; j < step.count; j += R::size()) {
    const N stress = R::load(columns.stress + j);
    const N depth = R::load(step.depth + j);
    const N strain = (step.after - depth) * per_thickness;
    N part[parts];
    for (std::size_t k = 0; k < parts; ++k) part[k] = R::load(columns.part[k] + j);
    const N shape = R::load(columns.shape + j);
    N change;  // of stress over A
    if constexpr (carries_branches<Law, N>)
      change = still.relaxing(part) / shape;
    else
      change =
          rate * relaxation_of(still, strain) * ((still.envelope(part, strain, strain) - stress) / shape);
    R::store(select(zero < stress, change, zero), columns.ratio + j);
  }
  const std::size_t cells = step.count - 1;
  edge = columns.ratio[cells];
  return sum_of<N>(cells, [&](std::size_t j) {
    const N mean = 0.5 * (R::load(columns.ratio + j) * R::load(weights.inner + j) +
                          R::load(columns.ratio + j + 1) * R::load(weights.outer + j));
    const N width = R::load(columns.measure + j) - R::load(columns.measure + j + 1);
    return mean * width;
  });
}

template <class N, class Law>
constexpr SweepOf<Law> sweep_of() {
  return {step_columns<N, Law>, move_columns<N, Law>, sum_held<N, Law>};
}

/// Fills `sweeps` with these functions for every law with memory.
template <class N, class... Laws>
void fill(std::tuple<SweepOf<Laws>...>& of_laws, Sweeps& sweeps) {
  of_laws = {sweep_of<N, Laws>()...};
  sweeps.replay = replay_columns<N>;
  sweeps.sum_of_cells = sum_cells<N>;
}
