"use strict";
// Values of curves under the pointer or, with the arrow keys, at the next point; and frames over time.
// Everything is there without it: figures are whole, of frames the last is shown, tables are links.

(() => {
  const SVG = "http://www.w3.org/2000/svg";
  const short = (value) => String(Number(value.toPrecision(4)));

  const element = (name, attributes, parent) => {
    const made = document.createElementNS(SVG, name);
    for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
    parent.append(made);
    return made;
  };

  const scale = (limits, ends, logarithmic) => {
    const turned = logarithmic ? Math.log10 : (value) => value;
    const [low, high] = limits.map(turned);
    return (value) => ends[0] + ((turned(value) - low) / (high - low)) * (ends[1] - ends[0]);
  };

  const nearest = (places, at) => places.reduce((best, place, k) => (Math.abs(place - at) < Math.abs(places[best] - at) ? k : best), 0);

  function hover(svg) {
    const data = JSON.parse(svg.dataset.curves);
    const [left, top, right, bottom] = data.box;
    const toX = scale(data.x, [left, right], data.log[0]);
    const toY = scale(data.y, [bottom, top], data.log[1]);
    const curves = data.curves.map((curve) => ({ ...curve, px: curve.x.map(toX), py: curve.y.map(toY) }));
    const marks = element("g", { "pointer-events": "none" }, svg);
    const values = document.createElement("div");
    values.className = "values";
    values.setAttribute("role", "status");
    svg.parentNode.append(values);
    svg.tabIndex = 0;
    let at = null;

    const clear = () => {
      marks.replaceChildren();
      values.replaceChildren();
      at = null;
    };

    const row = (label, value, colour) => {
      const line = document.createElement("div");
      const name = document.createElement(colour ? "i" : "b");
      name.textContent = label + " ";
      if (colour) name.style.color = colour;
      line.append(name, value);
      values.append(line);
    };

    const show = (points) => {
      marks.replaceChildren();
      values.replaceChildren();
      const x = points[0].curve.px[points[0].k];
      if (data.together) element("line", { x1: x, x2: x, y1: top, y2: bottom, stroke: "var(--faint)", "stroke-width": 0.7 }, marks);
      row(data.labels[0], short(points[0].curve.x[points[0].k]));
      for (const { curve, k } of points) {
        if (curve.py[k] >= top - 1 && curve.py[k] <= bottom + 1) element("circle", { cx: curve.px[k], cy: curve.py[k], r: 2.6, fill: curve.colour }, marks);
        row(curve.name, short(curve.y[k]), curve.colour);
      }
      const box = svg.viewBox.baseVal, size = svg.getBoundingClientRect();
      const place = (x / box.width) * size.width;
      const room = svg.parentNode.clientWidth - values.offsetWidth;
      const beside = place + 14 <= room ? place + 14 : place - values.offsetWidth - 14;
      values.style.left = `${Math.max(0, Math.min(beside, room))}px`;
      values.style.top = `${((data.together ? top : points[0].curve.py[points[0].k]) / box.height) * size.height + 8}px`;
      at = { curve: curves.indexOf(points[0].curve), k: points[0].k };
    };

    const showAt = (curve, k) => {
      const x = curve.px[k];
      show(data.together ? [{ curve, k }, ...curves.filter((other) => other !== curve).map((other) => ({ curve: other, k: nearest(other.px, x) }))] : [{ curve, k }]);
    };

    const point = (event) => {
      const box = svg.viewBox.baseVal, size = svg.getBoundingClientRect();
      const x = ((event.clientX - size.left) / size.width) * box.width;
      const y = ((event.clientY - size.top) / size.height) * box.height;
      if (x < left - 6 || x > right + 6 || y < top - 6 || y > bottom + 6) return clear();
      if (data.together) return showAt(curves[0], nearest(curves[0].px, x));
      let best = { far: Infinity };
      for (const curve of curves)
        curve.px.forEach((px, k) => {
          const far = Math.hypot(px - x, curve.py[k] - y);
          if (far < best.far) best = { far, curve, k };
        });
      showAt(best.curve, best.k);
    };
    svg.addEventListener("pointermove", point);
    svg.addEventListener("pointerdown", point);
    // A finger leaves when it is lifted: what it has asked for stays until the next tap elsewhere.
    svg.addEventListener("pointerleave", (event) => event.pointerType === "touch" || clear());
    svg.addEventListener("blur", clear);
    svg.addEventListener("keydown", (event) => {
      if (event.key === "Escape") return clear();
      const along = { ArrowLeft: -1, ArrowRight: 1 }[event.key], over = { ArrowUp: -1, ArrowDown: 1 }[event.key];
      if (!along && !over) return;
      event.preventDefault();
      const which = at ? (at.curve + (data.together ? 0 : over || 0) + curves.length) % curves.length : 0;
      const last = curves[which].x.length - 1;
      const step = data.together ? Math.max(1, Math.round(last / 100)) : 1;
      showAt(curves[which], at ? Math.min(Math.max(at.k + (along || 0) * step, 0), last) : 0);
    });
  }

  function play(player) {
    const { times, unit } = JSON.parse(player.dataset.times);
    const images = [...document.querySelectorAll(`.frames[data-player="${player.id}"] img`)].map((image) => ({
      image,
      sources: [...JSON.parse(image.nextElementSibling.textContent), image.src],
    }));
    const [button, slider, output] = ["button", "input", "output"].map((name) => player.querySelector(name));
    let timer = null;

    const show = (k) => {
      for (const { image, sources } of images) image.src = sources[k];
      slider.value = k;
      output.textContent = `${times[k].toFixed(1)} ${unit}`;
      slider.setAttribute("aria-valuetext", output.textContent);
    };
    const stop = () => {
      clearInterval(timer);
      timer = null;
      button.textContent = "▶";
      button.setAttribute("aria-label", "Play");
    };
    const start = () => {
      let k = Number(slider.value) >= times.length - 1 ? 0 : Number(slider.value);
      button.textContent = "⏸";
      button.setAttribute("aria-label", "Pause");
      show(k);
      timer = setInterval(() => (k + 1 < times.length ? show(++k) : stop()), 160);
    };
    slider.max = times.length - 1;
    slider.addEventListener("input", () => {
      stop();
      show(Number(slider.value));
    });
    button.addEventListener("click", () => (timer === null ? start() : stop()));
    stop();
    show(times.length - 1);
    player.hidden = false;
  }

  document.querySelectorAll("svg[data-curves]").forEach(hover);
  document.querySelectorAll(".player").forEach(play);
})();
