/// Values at the nodes of a foam's contact integral, several at a time.
///
/// Included as text, like src/model/pad/lanes.hpp, after it and the formulas of foams.

using Index = hn::Vec<hn::RebindToSigned<LanesTag>>;

/// CellPlace for several nodes.
struct Places {
  Index cell;
  Lanes number;  ///< number of the cell
  Lanes t;
};
/// Places of the strains whose root over the width of the cells is x.
HWY_INLINE Places places_of(Lanes x) {
  const Lanes last(Cells::count - 1);
  // NaN stays NaN, in the last cell.
  const Lanes number = hn::Floor(select(x < last, x, last).v);
  return {hn::ConvertTo(hn::RebindToSigned<LanesTag>(), number.v), number, x - number};
}

/// Cubics of the cells, from rows of four numbers.
HWY_INLINE Cubic<Lanes> cubics_of(const double* rows, Index cell) {
  const LanesTag tag;
#if HWY_MAX_BYTES == 32
  // Loading and transposing whole rows costs less than four gathers.
  HWY_ALIGN std::int64_t at[4];
  hn::Store(hn::ShiftLeft<2>(cell), hn::RebindToSigned<LanesTag>(), at);
  const auto row0 = hn::LoadU(tag, rows + at[0]);
  const auto row1 = hn::LoadU(tag, rows + at[1]);
  const auto row2 = hn::LoadU(tag, rows + at[2]);
  const auto row3 = hn::LoadU(tag, rows + at[3]);
  const auto ac01 = hn::InterleaveLower(tag, row0, row1);
  const auto bd01 = hn::InterleaveUpper(tag, row0, row1);
  const auto ac23 = hn::InterleaveLower(tag, row2, row3);
  const auto bd23 = hn::InterleaveUpper(tag, row2, row3);
  return {hn::ConcatLowerLower(tag, ac23, ac01), hn::ConcatLowerLower(tag, bd23, bd01),
          hn::ConcatUpperUpper(tag, ac23, ac01), hn::ConcatUpperUpper(tag, bd23, bd01)};
#else
  const Index at = hn::ShiftLeft<2>(cell);
  return {hn::GatherIndex(tag, rows, at), hn::GatherIndex(tag, rows + 1, at),
          hn::GatherIndex(tag, rows + 2, at), hn::GatherIndex(tag, rows + 3, at)};
#endif
}
HWY_INLINE Lanes value_at(const double* rows, const Places& at) {
  return value_of(cubics_of(rows, at.cell), at.t);
}

HWY_INLINE Lanes work_within(const FoamCurve::Rows& base, const Places& at) {
  const double width = base.cells.width;
  return Lanes(hn::GatherIndex(LanesTag(), base.work, at.cell)) +
         work_of(cubics_of(base.stress, at.cell), width * at.number, width, at.t);
}
HWY_INLINE Lanes work_beyond(const FoamCurve::Rows& base, Lanes strain, Lanes complement) {
  return work_beyond(base.beyond, strain, complement, inverse_power(base.beyond, complement));
}

/// m - 1 and its derivative, as Over.
HWY_INLINE Over<Lanes> over_at(const FoamStress::Rows& rows, Lanes strain, const Places& at) {
  const auto& [by_power, exponent, exponent_slope, linear, before, next] = rows.overstress;
  if (by_power) return over_by_power(exponent, exponent_slope, rows.rate.log_rate, strain);
  const Lanes slowest(linear ? 1.0 : 0.0);
  return over_between(linear, before == nullptr ? slowest : value_at(before, at), value_at(next, at),
                      rows.rate.weight);
}

/// Puts the values of nodes from the j-th on, by theory.md, Eq. 32, as FoamStress::ratio().
HWY_INLINE void put(const FoamNodes& nodes, Lanes strain, Lanes complement, const Places& at, Lanes work,
                    std::size_t j, NodeValues& values) {
  using R = Register<Lanes>;
  const FoamStress::Rows& rows = nodes.stress;
  Lanes remaining(1.0);
  if (rows.remaining != nullptr) {
    const Lanes largest = strain + rows.ahead;
    const Lanes most = choose(
        largest < rows.base.beyond.strain,
        [&] { return work_within(rows.base, places_of(sqrt(largest) * rows.base.cells.per_width)); },
        [&] { return work_beyond(rows.base, largest, complement - rows.ahead); });
    remaining = value_at(rows.remaining, places_of(sqrt(work / most) * double(Cells::count)));
  }
  Lanes over(rows.rate.at_all_strains.stress);
  Lanes rise(rows.rate.at_all_strains.rise);
  if (!rows.rate.even) {
    const auto [more, steeper] = over_at(rows, strain, at);
    over = rows.rate.friction + rows.rate.share * more;
    rise = rows.rate.friction_rise + std::abs(rows.rate.share) * rows.rate.weight_rise * steeper;
  }
  const Lanes area = max(nodes.rate_at_zero + nodes.rate_slope * strain, Lanes(0.0));
  R::store(work, &values.work[j]);
  R::store(area * (rows.lasting * remaining + over - nodes.common.stress), &values.stress[j]);
  R::store(area * (rows.relaxation * rise - nodes.common.relaxing), &values.relaxing[j]);
}

/// Numbers of the nodes from the j-th of a row on; beyond its end the last one is repeated.
HWY_INLINE Lanes numbers_of(const NodeRow& row, std::size_t j) {
  const Lanes number = hn::Iota(LanesTag(), static_cast<double>(row.first + j));
  return min(number, Lanes(static_cast<double>(row.first + row.count - 1)));
}

inline void fill_within(const FoamNodes& nodes, const NodeRow& row, NodeValues& values) {
  const LanesTag tag;
  const FoamCurve::Rows& base = nodes.stress.base;
  // Rows begin with the middle of a panel.
  const Lanes square(row.step * row.step);
  const Lanes for_middles = hn::OddEven(hn::Zero(tag), square.v);
  for (std::size_t j = 0; j < row.count; j += hn::Lanes(tag)) {
    const Lanes even = row.from + row.step * numbers_of(row, j);
    const bool one_at_an_end = hn::Lanes(tag) == 1 && j % 2 == 1;
    const Lanes strain = even * even + (one_at_an_end ? Lanes(0.0) : for_middles);
    const Places at = places_of(sqrt(strain) * base.cells.per_width);
    put(nodes, strain, 1.0 - strain, at, work_within(base, at), 1 + j, values);
  }
}

inline void fill_beyond(const FoamNodes& nodes, const NodeRow& row, NodeValues& values) {
  const Places last = places_of(Lanes(Cells::count));
  for (std::size_t j = 0; j < row.count; j += Register<Lanes>::size()) {
    const Lanes complement = exp(row.from - row.step * numbers_of(row, j));
    const Lanes strain = 1.0 - complement;
    put(nodes, strain, complement, last, work_beyond(nodes.stress.base, strain, complement), 1 + j, values);
  }
}
