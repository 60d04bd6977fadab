// Axes: places in px, the numbers that stand there, and ticks at round ones.

const superscript = (power) => [...String(power)].map((digit) => (digit === "-" ? "⁻" : "⁰¹²³⁴⁵⁶⁷⁸⁹"[digit])).join("");

// "2×10⁷" with as many digits as given.
function scientific(value, digits) {
  const [mantissa, power] = value.toExponential(Math.min(Math.max(digits, 0), 15)).split("e");
  return `${mantissa === "1" ? "" : `${mantissa}×`}10${superscript(Number(power))}`;
}

// A number of an axis, with as many digits as tell it from one that is `step` away.
function numberText(value, step) {
  if (Math.abs(value) < 1e-6 * step) return "0";
  const decimals = Math.max(0, Math.ceil(-Math.log10(step) - 1e-9));
  const isPlain = Math.abs(value) < 1e7 && decimals <= 6;
  const digits = Math.floor(Math.log10(Math.abs(value))) + Math.ceil(-Math.log10(step) - 1e-9);
  // What rounding leaves of nothing has no sign.
  return (isPlain ? value.toFixed(decimals) : scientific(value, digits)).replace(/^-(0\.?0*)$/, "$1").replace("-", "−");
}

// 1, 2 or 5 times a power of ten, and not below `least`.
function niceStep(least) {
  const power = 10 ** Math.floor(Math.log10(least));
  return power * [1, 2, 5, 10].find((times) => times * power >= least * (1 - 1e-9));
}

function linearTicks(low, high, most) {
  const step = niceStep((high - low) / most);
  const ticks = [];
  for (let count = Math.ceil(low / step - 1e-9); count <= high / step + 1e-9; ++count)
    ticks.push({ value: count * step, label: numberText(count * step, step) });
  return ticks;
}

// Numbers at 1, at 1, 2 and 5, or only at some of the decades; between them marks without a number.
function logarithmicTicks(low, high, most) {
  const decades = Math.log10(high / low);
  if (decades < 0.7) return linearTicks(low, high, most);
  const every = Math.max(1, Math.ceil(decades / most));
  const ticks = [];
  for (let power = Math.floor(Math.log10(low)); power <= Math.log10(high); ++power)
    for (let digit = 1; digit <= (decades <= 6 ? 9 : 1); ++digit) {
      const value = digit * 10 ** power;
      if (value < low * (1 - 1e-9) || value > high * (1 + 1e-9)) continue;
      const isNumbered = digit === 1 ? power % every === 0 : 3 * decades <= most && (digit === 2 || digit === 5);
      const isPlain = low > 1.5e-4 && high < 7e4;
      const text = () => (isPlain ? value.toFixed(Math.max(0, -power)) : scientific(value, 0));
      ticks.push({ value, label: isNumbered ? text() : "" });
    }
  return ticks;
}

// One axis of a panel. `length` in px; places run from 0, at the low end, to it. The reader may look at a part of
// it, from place `from` to place `to`, and choose another unit than it was written in.
class Axis {
  constructor(data, name, length) {
    this.length = length;
    [this.low, this.high] = ["Low", "High"].map((end) => Number(data[name + end]));
    this.hasNumbers = data[`${name}Numbers`] !== "0";
    this.isLogarithmic = data[`${name}Log`] === "1";
    // How many numbers have room.
    this.most = Number(data[`${name}Most`]);
    // The SI unit, and what one of it is on this axis; axes of pure numbers have none.
    this.unit = data[`${name}Unit`];
    this.written = { label: data[`${name}Label`], perSi: Number(data[`${name}PerSi`] ?? 1) };
    this.label = this.written.label;
    // Without its unit.
    this.quantity = this.label.replace(/ \([^()]*\)$/, "");
    this.perSi = this.written.perSi;
    this.whole();
  }

  // What numbers are multiplied by since they were written.
  get factor() {
    return this.perSi / this.written.perSi;
  }

  // Another unit: its name, and how many of it are one of the SI; without a name as it was written.
  setUnit(name, perSi) {
    this.label = name === undefined ? this.written.label : name ? `${this.quantity} (${name})` : this.quantity;
    this.perSi = name === undefined ? this.written.perSi : perSi;
  }

  whole() {
    [this.from, this.to] = [0, this.length];
  }

  get isWhole() {
    return this.from === 0 && this.to === this.length;
  }

  // Looks at that part, which is not beyond the ends, nor so small that numbers and lines lose their meaning.
  look(from, to) {
    const least = this.length / 200;
    const size = Math.min(Math.max(to - from, least), this.length);
    if (size > this.length * (1 - 1e-9)) return this.whole();
    this.from = Math.min(Math.max((from + to - size) / 2, 0), this.length - size);
    this.to = this.from + size;
  }

  contains(place) {
    return place > this.from - 0.5 && place < this.to + 0.5;
  }

  // Moves what is looked at so that the place is in it.
  follow(place) {
    const half = (this.to - this.from) / 2;
    if (!this.contains(place)) this.look(place - half, place + half);
  }

  // Between a place on the whole axis and where it is now.
  shown(place) {
    return ((place - this.from) / (this.to - this.from)) * this.length;
  }

  place(shown) {
    return this.from + (shown / this.length) * (this.to - this.from);
  }

  value(place) {
    const share = place / this.length;
    const plain = this.isLogarithmic ? this.low * (this.high / this.low) ** share : this.low + share * (this.high - this.low);
    return plain * this.factor;
  }

  placeOf(value) {
    const plain = value / this.factor;
    const share = this.isLogarithmic
      ? Math.log(plain / this.low) / Math.log(this.high / this.low)
      : (plain - this.low) / (this.high - this.low);
    return share * this.length;
  }

  ticks() {
    if (!this.hasNumbers) return [];
    const [low, high] = [this.value(this.from), this.value(this.to)];
    const list = this.isLogarithmic ? logarithmicTicks(low, high, this.most) : linearTicks(low, high, this.most);
    return list.map(({ value, label }) => ({ place: this.shown(this.placeOf(value)), label }));
  }

  // The number there, as fine as the drawing tells it.
  text(place) {
    const value = this.value(place);
    const step = this.isLogarithmic ? Math.abs(value) / 1000 : Math.abs(this.value(this.to) - this.value(this.from)) / 1000;
    const text = numberText(value, 10 ** Math.floor(Math.log10(step)));
    return /^[^×]*\./.test(text) && !text.includes("×") ? text.replace(/\.?0+$/, "") : text;
  }

  unitName() {
    return /\(([^()]*)\)$/.exec(this.label)?.[1] ?? "";
  }
}
