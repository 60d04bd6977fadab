// The drawing moves: its right picture, which shows the greatest penetration, is led to other moments from there.

const numbersIn = (dataset) => Object.fromEntries(Object.entries(dataset).map(([key, value]) => [key, Number(value)]));

class MovingPicture {
  // picture: the group with the data, as the library has drawn it.
  constructor(picture) {
    this.picture = picture;
    Object.assign(this, numbersIn(picture.dataset));
    this.nose = picture.querySelector(".dd-nose");
    const places = pairs(numbersOf(this.nose.getAttribute("d")));
    // From the tip up along the right side; behind its widest place a nose is as wide.
    let widest = 0;
    this.profile = places.slice(places.length / 2).map(([x, y]) => [this.tip - y, (widest = Math.max(widest, x - this.axis))]);
    this.heading = picture.parentNode.querySelector(".dd-heading");
    this.words = this.heading.textContent;
    // What is left of the springs, but for their coils on each other.
    const springs = picture.querySelector(".dd-springs");
    this.springs = springs && { element: springs, ...numbersIn(springs.dataset) };
    this.room = springs ? Math.max(this.springs.base - Math.max(this.springs.free, this.springs.touching) - 10, 0) : 0;
  }

  // Half the width of the nose so far behind its tip; all px.
  radius(depth) {
    const next = this.profile.findIndex(([each]) => each > depth);
    if (next < 0) return this.profile.at(-1)[1];
    if (next === 0) return 0;
    const [[low, narrow], [high, wide]] = [this.profile[next - 1], this.profile[next]];
    return narrow + ((depth - low) / (high - low)) * (wide - narrow);
  }

  // How far behind its tip the nose is first that wide.
  depth(half) {
    const next = this.profile.findIndex(([, each]) => each >= half);
    if (next < 0) return Infinity;
    if (next === 0) return this.profile[0][0];
    const [[low, narrow], [high, wide]] = [this.profile[next - 1], this.profile[next]];
    return low + ((half - narrow) / (wide - narrow)) * (high - low);
  }

  // Metres. With null it is as it was drawn.
  show(moment, words) {
    this.picture.parentNode.classList.toggle("dd-moved", moment !== null);
    this.heading.textContent = moment ? words : this.words;
    const { penetration, deflection, body } = moment ?? this;
    const way = (now, most, px) => (most > 0 ? (Math.max(now, 0) / most) * px : 0);
    const deep = Math.min(Math.max(penetration, 0), this.penetration);
    // A body that is free goes on and on: its way ends where the picture does.
    const bodyWay = Math.min(way(body, this.body, this.bodyPx), this.bodyPx);
    // A support may give way further than at the greatest penetration: as far as there is room.
    const sink = Math.min(way(deflection, this.deflection, this.deflectionPx), this.deflectionPx + this.room) + bodyWay;
    const up = this.deflectionPx + this.bodyPx - sink;
    const lift = (element, by) => element?.setAttribute("transform", `translate(0 ${-by})`);
    lift(this.picture.querySelector(".dd-pad"), up);
    lift(this.picture.querySelector(".dd-sheet"), up);
    lift(this.picture.querySelector(".dd-sheet-bent"), (this.penetration - deep) * this.scale);
    lift(this.nose, up + (this.penetration - deep) * this.scale);
    this.showSupport(up, bodyWay);
    const share = this.penetration > 0 ? deep / this.penetration : 0;
    this.picture.querySelectorAll("[data-strain]").forEach((layer) => this.shade(layer, share, deep * this.scale));
    this.picture.querySelectorAll("[data-behind]").forEach((edge) => this.bend(edge, share, deep * this.scale));
  }

  // Springs end where the pad's back is, or where they are at rest below a gap.
  showSupport(up, bodyWay) {
    const bodyUp = this.bodyPx - bodyWay;
    for (const each of this.picture.querySelectorAll(".dd-panel")) each.setAttribute("transform", `translate(0 ${-up})`);
    for (const each of this.picture.querySelectorAll(".dd-behind")) each.setAttribute("transform", `translate(0 ${-bodyUp})`);
    if (!this.springs) return;
    const { element, top, base, free, touching } = this.springs;
    const now = Math.max(free - bodyUp, touching - up);
    const stretch = base > top ? (base - bodyUp - now) / (base - top) : 1;
    element.setAttribute("transform", `matrix(1 0 0 ${stretch} 0 ${now - stretch * top})`);
  }

  // One rectangle in another, from small strains to large ones.
  shade(layer, share, deep) {
    const strain = Number(layer.dataset.strain) * share;
    layer.querySelectorAll("rect[class^=dd-s]").forEach((rect, i) => {
      if (i === 0) return;
      const least = i / Number(layer.dataset.shades);
      const half = strain > least ? Math.min(this.radius(deep * (1 - least / strain)), this.halfWidth) : 0;
      rect.setAttribute("x", this.axis - half);
      rect.setAttribute("width", 2 * half);
    });
  }

  // The back of a layer: what is behind it, less its shortening in each column.
  bend(edge, share, deep) {
    const { behind, shortened } = edge.dataset;
    const y = (shortening) => this.back - behind + shortened * share * shortening;
    const edgeOfContact = Math.min(this.radius(deep), this.halfWidth);
    const right = this.profile.filter(([depth, half]) => depth < deep && half < edgeOfContact).map(([depth, half]) => [half, y(1 - depth / deep)]);
    if (deep > 0) right.push([edgeOfContact, y(1 - Math.min(this.depth(edgeOfContact), deep) / deep)]);
    if (deep <= 0 || edgeOfContact < this.halfWidth) right.push([edgeOfContact, y(0)], [this.halfWidth, y(0)]);
    if (edge.localName === "path" && edge.parentNode.localName === "clipPath") right.push([this.halfWidth, this.back]);
    const left = [...right].reverse().map(([x, height]) => [this.axis - x, height]);
    const places = [...left, ...right.map(([x, height]) => [this.axis + x, height])];
    edge.setAttribute("d", `M${places.map((place) => place.join(" ")).join("L")}`);
  }
}

// A slider for the time below the answer's pictures, and the values at that time in words.
class TimeSlider {
  constructor(moments, signal) {
    this.moments = moments;
    // Where the reader has left it; null: nowhere.
    this.time = null;
    const pictures = document.querySelector(".lead .pictures");
    const { end } = moments;
    if (!pictures || !(end > 0)) return;
    this.slider = Object.assign(document.createElement("input"), { type: "range", min: 0, max: end, step: "any" });
    this.slider.setAttribute("aria-label", "Time");
    this.output = document.createElement("output");
    this.box = Object.assign(document.createElement("div"), { className: "time" });
    if (!matchMedia("(prefers-reduced-motion: reduce)").matches) this.box.append(this.makeButton());
    this.box.append(this.slider, this.output);
    pictures.after(this.box);
    this.slider.addEventListener("input", () => this.stand(Number(this.slider.value)));
    moments.listeners.push((time) => this.show(time));
    document.addEventListener("before-units", () => this.picture()?.show(null), { signal });
    document.addEventListener("units", () => moments.show(null), { signal });
    this.show(null);
  }

  makeButton() {
    this.button = textElement("button", "Play");
    this.button.type = "button";
    this.button.addEventListener("click", () => (this.running ? this.stop() : this.play()));
    return this.button;
  }

  // From where it stands, or from the beginning: the whole impact in four seconds.
  play() {
    const { end } = this.moments;
    const from = this.time !== null && this.time < 0.999 * end ? this.time : 0;
    this.button.textContent = "Pause";
    let begin = null;
    const step = (now) => {
      begin ??= now;
      const time = Math.min(from + ((now - begin) / 4000) * end, end);
      this.moments.stand(time);
      this.time = time;
      this.running = time < end ? requestAnimationFrame(step) : null;
      if (!this.running) this.stop();
    };
    this.running = requestAnimationFrame(step);
  }

  stop() {
    if (this.running) cancelAnimationFrame(this.running);
    this.running = null;
    if (this.button) this.button.textContent = "Play";
  }

  stand(time) {
    this.stop();
    this.time = time;
    this.moments.stand(time);
  }

  picture() {
    const group = document.querySelector(".drawing [data-penetration]");
    if (group && this.moving?.picture !== group) this.moving = new MovingPicture(group);
    return group ? this.moving : null;
  }

  // Null: as the page was written.
  show(time) {
    const { moments } = this;
    const at = (name) => (time === null ? null : moments.siValue(name, time));
    const penetration = at("Penetration");
    // On a rigid support there are no curves of these.
    const motion = at("Displacement") ?? penetration;
    const deflection = at("Deflection of the support") ?? 0;
    const moment = penetration === null ? null : { penetration, deflection, body: motion - penetration - deflection };
    const words = time === null ? "" : `At ${moments.timeText(time)}`;
    this.picture()?.show(moment, words);
    this.slider.value = time ?? moments.timeOfSi(this.moving?.time) ?? moments.end;
    const values = ["Force", "Deceleration", "Penetration", "Displacement"].map((name) => [name, moments.text(name, time)]);
    this.output.textContent =
      time === null
        ? "The whole impact, moment by moment"
        : `${words}: ${values.filter(([, text]) => text).map(([name, text]) => `${name.toLowerCase()} ${text}`).join(", ")}`;
    this.slider.setAttribute("aria-valuetext", this.output.textContent);
  }
}
