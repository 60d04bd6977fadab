// Units as the program that wrote the page knows them: a factor from SI and a name. Pure numbers and g stay.

export class Units {
  constructor(system) {
    this.system = system;
  }

  name(si) {
    const known = this.system.factors[si];
    return known ? known.unit : si === "1" ? "" : si;
  }

  value(number, si) {
    const known = this.system.factors[si];
    return number === null || !known ? number : number * known.factor;
  }

  column(numbers, si) {
    return numbers.map((number) => this.value(number, si));
  }

  label(what, si) {
    const unit = this.name(si);
    return unit ? `${what} (${unit})` : what;
  }
}
