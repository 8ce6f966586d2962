"use strict";
// The sections of the report. `data` is study.json with `page` beside it: the values over the grid,
// packed as integers of two bytes.

const data = JSON.parse(document.getElementById("data").textContent);
const study = data.study, page = data.page;
const names = study.models.map(m => m.model);
// A model that is wrong by more would leave all others flat; the legend switches it on.
const kHiddenAbove = 10;
const hidden = study.ranking.filter(r => r.delta_e_mean > kHiddenAbove).map(r => r.model);
const state = { shown: new Set(names.filter(n => !hidden.includes(n))), material: 0, pol: "u", metric: "delta_e_mean" };
const redraws = [];
const redraw = () => redraws.forEach(f => f());

// --- Models: colour, dash, legend.
const palette = ["#0b62a4", "#d9480f", "#2b8a3e", "#9c36b5", "#c2255c", "#0c8599", "#a5720b", "#5f3dc4", "#7a4a2b"];
const dashes = [null, "7 4", "2 3"];
const approximations = names.filter(n => n !== "exact");
const styleOf = name => {
  if (name === "exact") return { colour: "#111418", dash: null, width: 2.4 };
  const i = approximations.indexOf(name);
  return { colour: palette[i % palette.length], dash: dashes[Math.floor(i / palette.length) % 3], width: 1.7 };
};
const shownNames = () => names.filter(n => state.shown.has(n));

function legend() {
  const root = d3.select("#legend");
  const buttons = root.selectAll("button.model").data(names).enter().append("button").attr("class", "model")
    .attr("title", n => study.models[names.indexOf(n)].description + "\nClick: switch. Double click: this one and exact alone.");
  buttons.append("svg").attr("width", 26).attr("height", 10).append("line").attr("x2", 26).attr("y1", 5).attr("y2", 5)
    .each((n, i, nodes) => {
      const s = styleOf(n);
      d3.select(nodes[i]).attr("stroke", s.colour).attr("stroke-width", s.width + 0.6).attr("stroke-dasharray", s.dash);
    });
  buttons.append("span").text(n => n);
  const refresh = () => { buttons.attr("aria-pressed", n => state.shown.has(n)); redraw(); };
  buttons.each((n, i, nodes) => {
    nodes[i].addEventListener("click", () => { state.shown.has(n) ? state.shown.delete(n) : state.shown.add(n); refresh(); });
    nodes[i].addEventListener("dblclick", () => { state.shown = new Set(["exact", n]); refresh(); });
  });
  for (const [text, set] of [["all", () => names], ["none", () => ["exact"]]]) {
    root.append("button").attr("class", "plain").text(text).on("click", () => { state.shown = new Set(set()); refresh(); });
  }
  buttons.attr("aria-pressed", n => state.shown.has(n));
}

// --- Values over the grid.
const columns = page.wavelengths_nm.length, rows = page.angles_deg.length;
function words(text, type) {
  const binary = atob(text), bytes = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; ++i) bytes[i] = binary.charCodeAt(i);
  return new type(bytes.buffer);
}
const cache = new Map();
function once(key, make) {
  if (!cache.has(key)) cache.set(key, make());
  return cache.get(key);
}
const exactValues = (m, pol) => once(`x${m}${pol}`, () =>
  Float32Array.from(words(page.materials[m].exact[pol], Uint16Array), v => v / 65535));
// Model minus exact; null where the model does not know the polarisation.
const errorValues = (m, name, pol) => once(`e${m}${name}${pol}`, () => {
  const packed = page.materials[m].models[names.indexOf(name)][pol];
  return packed ? Float32Array.from(words(packed.values, Int16Array), v => v * packed.step) : null;
});

// --- Controls.
function choose(parent, label, options, value, change) {
  const select = d3.select(parent).append("label").text(label).append("select");
  select.selectAll("option").data(options).enter().append("option").attr("value", o => o[0]).text(o => o[1])
    .property("selected", o => o[0] === value);
  select.node().addEventListener("change", e => change(e.target.value));
  return select;
}
const materialSelects = [];
function chooseMaterial(parent) {
  const options = study.materials.map((m, i) => [String(i), `${m.name} (${m.table})`]);
  materialSelects.push(choose(parent, "material", options, "0", value => {
    state.material = +value;
    materialSelects.forEach(s => s.property("value", value));
    redraw();
  }));
}
function slide(parent, label, values, unit, start, change) {
  const root = d3.select(parent).append("label").text(label);
  const input = root.append("input").attr("type", "range").attr("min", 0).attr("max", values.length - 1)
    .attr("value", start).attr("aria-label", label);
  const output = root.append("output");
  const update = () => { const i = +input.property("value"); output.text(`${number(values[i])} ${unit}`); change(i); };
  input.node().addEventListener("input", () => { update(); redraw(); });
  update();
}
const nearestIndex = (values, wanted) => d3.scan(values, (a, b) => Math.abs(a - wanted) - Math.abs(b - wanted));
const result = (m, name) => study.results[m * names.length + names.indexOf(name)];

// --- Sections.
const count = (n, what) => `${n} ${what}${n === 1 ? "" : "s"}`;
function summary() {
  d3.select("#about").text(`${count(names.length, "model")} on ${count(study.materials.length, "material")}; ` +
    `${count(study.grid.wavelengths_nm.length, "wavelength")} and ${count(study.grid.angles_deg.length, "angle")}, unweighted; colours under ` +
    `${study.illuminant} (${study.observer}); costs on ${study.machine.processor}, ${study.machine.compiler}. ` +
    "Double click on a chart zooms in, Ctrl and the wheel zoom both ways, dragging moves, the legend switches models everywhere" + (hidden.length ? `; off at first, since far from exact: ${hidden.join(", ")}.` : "."));
  d3.select("#findings").selectAll("li").data(study.summary).enter().append("li").text(s => s);
  table("#ranking", [
    { title: "model", text: true, value: r => r.model },
    { title: "cost,<br>exact = 1", value: r => r.cost_relative, format: d3.format(".2f") },
    { title: "ΔE<sub>00</sub><br>mean", value: r => r.delta_e_mean }, { title: "ΔE<sub>00</sub><br>max", value: r => r.delta_e_max },
    { title: "on", text: true, value: r => r.delta_e_max_material }, { title: "ΔE<sub>00</sub> of<br>albedo, max", value: r => r.delta_e_albedo },
    { title: "error<br>RMS", value: r => r.rms_error }, { title: "error<br>max", value: r => r.max_abs_error },
  ], study.ranking, r => r.efficient ? "efficient" : null);
  d3.select("#ranking").append("p").style("color", "var(--quiet)").style("font-size", "13px")
    .text(`All materials together. Bold: no other model is cheaper and as near in colour, or nearer and as cheap (costs within ${d3.format(".0%")(page.same.cost)} count as equal).`);
}

function reflectance() {
  const at = { angle: 0, nm: 0 }, controls = "#reflectance-controls";
  chooseMaterial(controls);
  choose(controls, "light", [["u", "unpolarised"], ["s", "s"], ["p", "p"]], "u", v => { state.pol = v; redraw(); });
  slide(controls, "wavelength", page.wavelengths_nm, "nm", nearestIndex(page.wavelengths_nm, 550), i => { at.nm = i; });
  slide(controls, "angle", page.angles_deg, "deg", nearestIndex(page.angles_deg, 75), i => { at.angle = i; });
  const angle = { xLabel: "angle (degrees)", xName: "angle", xUnit: "deg", height: 320 };
  const nm = { xLabel: "wavelength (nm)", xName: "wavelength", xUnit: "nm", height: 320 };
  const charts = [
    new LineChart("#over-angle", Object.assign({ yLabel: "reflectance" }, angle)),
    new LineChart("#over-wavelength", Object.assign({ yLabel: "reflectance" }, nm)),
    new LineChart("#error-over-angle", Object.assign({ yLabel: "model − exact" }, angle)),
    new LineChart("#error-over-wavelength", Object.assign({ yLabel: "model − exact" }, nm))];
  const alongAngle = pick => page.angles_deg.map((a, i) => [a, pick(i * columns + at.nm)]);
  const alongNm = pick => page.wavelengths_nm.map((w, j) => [w, pick(at.angle * columns + j)]);
  redraws.push(() => {
    const m = state.material, exact = exactValues(m, state.pol);
    const models = shownNames().map(name => [name, errorValues(m, name, state.pol)]).filter(([, e]) => e);
    const series = (along, absolute) => models.filter(([name]) => absolute ? name !== "exact" : true)
      .map(([name, e]) => Object.assign({ name, points: along(i => absolute ? exact[i] + e[i] : e[i]) }, styleOf(name)));
    const reference = along => state.shown.has("exact") || !names.includes("exact")
      ? [Object.assign({ name: "exact", points: along(i => exact[i]) }, styleOf("exact"))] : [];
    charts[0].set(series(alongAngle, true).concat(reference(alongAngle)));
    charts[1].set(series(alongNm, true).concat(reference(alongNm)));
    charts[2].set(series(alongAngle, false));
    charts[3].set(series(alongNm, false));
    const light = { u: "unpolarised", s: "s polarised", p: "p polarised" }[state.pol];
    charts[0].title.text(`${study.materials[m].name} at ${number(page.wavelengths_nm[at.nm])} nm, ${light}`);
    charts[1].title.text(`${study.materials[m].name} at ${number(page.angles_deg[at.angle])} degrees, ${light}`);
    charts[2].title.text("the same, model minus exact");
    charts[3].title.text("the same, model minus exact");
  });
}

function errors() {
  chooseMaterial("#map-controls");
  let scale = "material";
  choose("#map-controls", "scale", [["material", "one for all maps"], ["model", "each map its own"]], scale, v => { scale = v; redraw(); });
  const bar = d3.select("#map-bar").append("svg").attr("width", 420).attr("height", 40);
  const signedRoot = v => Math.sign(v) * Math.sqrt(Math.abs(v));
  const colour = (value, limit) => d3.interpolateRdBu(0.5 - 0.5 * Math.max(-1, Math.min(1, signedRoot(value / limit))));
  function drawBar(limit) {
    bar.html("");
    const steps = d3.range(0, 101).map(i => (i / 50 - 1));
    bar.selectAll("rect").data(steps).enter().append("rect").attr("x", (d, i) => 10 + 4 * i).attr("width", 4.5).attr("height", 14)
      .attr("fill", t => colour(Math.sign(t) * t * t * limit, limit));
    bar.selectAll("text").data([-1, -0.5, 0, 0.5, 1]).enter().append("text").attr("x", t => 10 + 200 * (t + 1)).attr("y", 30)
      .attr("text-anchor", t => t === -1 ? "start" : t === 1 ? "end" : "middle").attr("font-size", 12).attr("fill", "#5b6570")
      .text(t => number(Math.sign(t) * t * t * limit));
  }
  redraws.push(() => {
    const m = state.material;
    const limits = new Map(names.map(n => [n, d3.max(errorValues(m, n, "u"), Math.abs) || 1e-9]));
    const common = d3.max(approximations.length ? approximations : names, n => limits.get(n));
    bar.style("display", scale === "material" ? null : "none");
    drawBar(common);
    const maps = d3.select("#maps").html("").selectAll("div").data(shownNames().filter(n => n !== "exact" || names.length === 1))
      .enter().append("div");
    maps.append("h3").text(n => n);
    maps.append("canvas").attr("width", columns).attr("height", rows).each((n, i, nodes) => {
      const values = errorValues(m, n, "u"), context = nodes[i].getContext("2d");
      const limit = scale === "material" ? common : limits.get(n), image = context.createImageData(columns, rows);
      for (let a = 0; a < rows; ++a) for (let w = 0; w < columns; ++w) {
        const c = d3.rgb(colour(values[a * columns + w], limit)), at = 4 * ((rows - 1 - a) * columns + w);
        image.data[at] = c.r; image.data[at + 1] = c.g; image.data[at + 2] = c.b; image.data[at + 3] = 255;
      }
      context.putImageData(image, 0, 0);
      nodes[i].addEventListener("mousemove", e => {
        const box = nodes[i].getBoundingClientRect();
        const w = Math.min(columns - 1, Math.floor((e.clientX - box.left) / box.width * columns));
        const a = Math.min(rows - 1, rows - 1 - Math.floor((e.clientY - box.top) / box.height * rows));
        if (w < 0 || a < 0) return;
        showTip(e, `${n}: ${number(page.wavelengths_nm[w])} nm, ${number(page.angles_deg[a])} deg\n` +
          `error ${number(values[a * columns + w])}, exact ${number(exactValues(m, "u")[a * columns + w])}`);
      });
      nodes[i].addEventListener("mouseleave", hideTip);
    });
    const range = maps.append("div").attr("class", "range");
    const ends = page.wavelengths_nm;
    range.append("span").text(`${number(ends[0])} to ${number(ends[ends.length - 1])} nm`);
    range.append("span").text(n => `max ${number(result(m, n).max_abs_error)}`);
    table("#statistics", [
      { title: "model", text: true, value: n => n },
      { title: "max |error|", value: n => result(m, n).max_abs_error },
      { title: "at nm", value: n => result(m, n).max_abs_error_nm, format: d3.format("~g") },
      { title: "at deg", value: n => result(m, n).max_abs_error_deg, format: d3.format("~g") },
      { title: "mean |error|", value: n => result(m, n).mean_abs_error },
      { title: "RMS", value: n => result(m, n).rms_error },
      { title: "bias", value: n => result(m, n).mean_signed_error },
      { title: "ΔE<sub>00</sub> mean", value: n => result(m, n).delta_e_mean },
      { title: "ΔE<sub>00</sub> max", value: n => result(m, n).delta_e_max },
      { title: "at deg", value: n => result(m, n).delta_e_max_deg, format: d3.format("~g") },
      { title: "ΔE<sub>00</sub> albedo", value: n => result(m, n).delta_e_albedo },
    ], shownNames());
  });
}

function colour() {
  d3.select("#colour-text").text(`CIEDE2000 between the colour of the model's reflectance and that of exact, under ${study.illuminant}, ` +
    `observer ${study.observer}, against a perfect white reflector. Differences below 1 can hardly be seen side by side. ` +
    "The albedo is what a rough surface or a room full of light averages to: reflectance weighted by the cosine over the hemisphere.");
  chooseMaterial("#colour-controls");
  const delta = new LineChart("#delta-e", { xLabel: "angle (degrees)", yLabel: "ΔE00 against exact", xName: "angle", xUnit: "deg" });
  const albedo = new LineChart("#albedo", { xLabel: "wavelength (nm)", yLabel: "albedo, model − exact", xName: "wavelength", xUnit: "nm" });
  redraws.push(() => {
    const m = state.material, p = page.materials[m];
    delta.title.text(`${study.materials[m].name}: colour difference over angle`);
    albedo.title.text(`${study.materials[m].name}: error of the hemispherical albedo`);
    const make = pick => shownNames().map(n => Object.assign({ name: n, points: pick(p.models[names.indexOf(n)]) }, styleOf(n)));
    delta.set(make(model => page.angles_deg.map((a, i) => [a, model.delta_e[i]])));
    albedo.set(make(model => study.grid.wavelengths_nm.map((w, i) => [w, model.albedo[i] - p.exact.albedo[i]])));
    const head = ["model"].concat(page.swatch_angles_deg.map(a => `${number(a)} deg`), "albedo");
    const rowsOf = [["reference", p.exact.swatches]].concat(shownNames().map(n => [n, p.models[names.indexOf(n)].swatches]));
    const root = d3.select("#swatches").html("").append("table");
    root.append("thead").append("tr").selectAll("th").data(head).enter().append("th").attr("class", "text").text(h => h);
    const tr = root.append("tbody").selectAll("tr").data(rowsOf).enter().append("tr");
    tr.append("td").attr("class", "text").text(r => r[0]);
    tr.selectAll("td.swatch").data(r => r[1]).enter().append("td").attr("class", "swatch")
      .append("div").style("background", c => c).text(c => c).style("color", c => d3.lab(c).l > 55 ? "#0008" : "#fff9");
  });
}

function cost() {
  const m = study.machine, published = study.published_2005;
  d3.select("#cost-text").text(`One call evaluates ${study.wavelengths_per_call} wavelengths at one angle, as rendering does; ` +
    `medians with quartiles over interleaved rounds, in processor time. A call that computes nothing takes ${number(study.call_overhead_ns)} ns of each. ` +
    `${m.processor}; ${m.compiler}, ${m.flags}; vectors: ${m.vector_instructions}. ` +
    "A single wavelength is computed in double precision straight from n and k, with nothing prepared but fitted numbers: a table computes the two values that it needs. " +
    "Hollow marks: the figures of Lazányi and Szirmay-Kalos, 2005, on a graphics processor of that time.");
  const sorted = study.models.slice().sort((a, b) => a.cost_relative.median - b.cost_relative.median);
  const height = 26 * sorted.length + 50, width = 900, left = 210;
  const root = d3.select("#costs").append("div").attr("class", "chart");
  const svg = root.append("svg").attr("viewBox", `0 0 ${width} ${height}`).style("max-width", width + "px");
  const most = d3.max(sorted, s => Math.max(s.cost_relative.upper, 1));
  const x = d3.scaleLinear().domain([0, most * 1.05]).range([left, width - 90]);
  svg.append("g").attr("class", "grid").attr("transform", `translate(0,${height - 36})`).call(d3.axisBottom(x).ticks(8).tickSize(-height + 40).tickFormat(""));
  svg.append("g").attr("class", "axis").attr("transform", `translate(0,${height - 36})`).call(d3.axisBottom(x).ticks(8, "~g"));
  svg.append("text").attr("class", "label").attr("x", (left + width - 90) / 2).attr("y", height - 4).attr("text-anchor", "middle").text("cost relative to exact");
  const row = svg.selectAll("g.row").data(sorted).enter().append("g").attr("transform", (d, i) => `translate(0,${6 + 26 * i})`);
  row.append("text").attr("x", left - 10).attr("y", 15).attr("text-anchor", "end").attr("font-size", 13).text(d => d.model);
  row.append("rect").attr("x", x(0)).attr("y", 4).attr("height", 14).attr("width", d => x(d.cost_relative.median) - x(0)).attr("fill", d => styleOf(d.model).colour).attr("fill-opacity", 0.75);
  row.append("line").attr("x1", d => x(d.cost_relative.lower)).attr("x2", d => x(d.cost_relative.upper)).attr("y1", 11).attr("y2", 11).attr("stroke", "#000").attr("stroke-width", 2);
  row.filter(d => published[d.model]).append("circle").attr("cx", d => x(published[d.model])).attr("cy", 11).attr("r", 6).attr("fill", "none").attr("stroke", "#000").attr("stroke-width", 1.6)
    .append("title").text(d => `2005: ${published[d.model]}`);
  row.append("text").attr("x", d => x(Math.max(d.cost_relative.upper, published[d.model] || 0)) + 12).attr("y", 15).attr("font-size", 12).attr("fill", "#5b6570").text(d => `${number(d.ns_per_call.median)} ns`);
  const cells = [
    { title: "model", text: true, value: d => d.model },
    { title: `ns per ${study.wavelengths_per_call}<br>wavelengths`, value: d => d.ns_per_call.median },
    { title: "quartiles", text: true, value: d => `${number(d.ns_per_call.lower)} to ${number(d.ns_per_call.upper)}` },
    { title: "ns per<br>wavelength of these", value: d => d.ns_per_wavelength },
    { title: "relative", value: d => d.cost_relative.median, format: d3.format(".3f") },
    { title: "without<br>the call", value: d => d.cost_relative_net, format: d3.format(".2f") },
    { title: "relative,<br>2005", value: d => published[d.model] || null }];
  if (study.models.some(d => d.ns_single)) {
    cells.splice(7, 0, { title: "ns per single<br>wavelength", value: d => d.ns_single.median }, { title: "relative,<br>single", value: d => d.cost_relative_single.median, format: d3.format(".3f") });
  }
  table("#cost-table", cells, sorted);
}

function render() {
  const r = study.render;
  if (!r) { d3.select("#render").remove(); return; }
  d3.select("#render-text").text(`Copper, silver and aluminium rings, ${r.width} x ${r.height} pixels, ${r.spp} samples per pixel, the same random numbers for ` +
    `every model. Left the picture, right CIEDE2000 per pixel against exact, from 0 (dark) to ${number(r.delta_e_scale)} (bright). Two exact renders with different random ` +
    `numbers differ by ${number(r.noise_delta_e_mean)} on average: that is noise. Fresnel takes ${d3.format(".2%")(r.fresnel_share.median)} of the whole render's time ` +
    `(exact; quartiles ${d3.format(".2%")(r.fresnel_share.lower)} to ${d3.format(".2%")(r.fresnel_share.upper)}), ${number(r.evaluations_per_sample)} evaluations per camera sample. ` +
    `The second exact render took ${d3.format(".3f")(r.noise_relative_time.median)} of the first one's time: times that differ by no more do not differ.`);
  const bar = d3.select("#pictures").append("div").style("grid-column", "1 / -1").append("svg").attr("width", 440).attr("height", 38);
  bar.append("image").attr("href", r.colour_bar).attr("x", 10).attr("width", 400).attr("height", 14).attr("preserveAspectRatio", "none");
  bar.selectAll("text").data([0, 0.25, 0.5, 0.75, 1]).enter().append("text").attr("x", t => 10 + 400 * t).attr("y", 30).attr("font-size", 12)
    .attr("text-anchor", t => t === 0 ? "start" : t === 1 ? "end" : "middle").text(t => number(t * r.delta_e_scale) + (t === 1 ? " ΔE00" : ""));
  const cards = d3.select("#pictures").selectAll("div.card").data(r.models).enter().append("div").attr("class", "card");
  cards.append("h3").text(d => d.model);
  const both = cards.append("div").attr("class", "both");
  both.append("img").attr("src", d => d.picture).attr("alt", d => `rings, ${d.model}`);
  both.append("img").attr("src", d => d.difference).attr("alt", d => `difference of ${d.model} from exact`);
  cards.append("p").text(d => `ΔE00 mean ${number(d.delta_e_mean)}, 95 % ${number(d.delta_e_p95)}; time ${d3.format(".3f")(d.relative_time.median)} of exact`);
  redraws.push(() => cards.style("display", d => state.shown.has(d.model) ? null : "none"));
  table("#render-table", [
    { title: "model", text: true, value: d => d.model }, { title: "ΔE<sub>00</sub> mean", value: d => d.delta_e_mean },
    { title: "ΔE<sub>00</sub> 95 %", value: d => d.delta_e_p95 }, { title: "ΔE<sub>00</sub> max", value: d => d.delta_e_max },
    { title: "time of the render,<br>exact = 1", value: d => d.relative_time.median, format: d3.format(".3f") },
    { title: "quartiles", text: true, value: d => `${d3.format(".3f")(d.relative_time.lower)} to ${d3.format(".3f")(d.relative_time.upper)}` },
    { title: "processor seconds", value: d => d.cpu_seconds }], r.models);
}

const metrics = [["delta_e_mean", "ΔE00, mean over angles"], ["delta_e_max", "ΔE00, largest over angles"], ["delta_e_albedo", "ΔE00 of the albedo"],
  ["rms_error", "reflectance error, RMS"], ["max_abs_error", "reflectance error, largest"]];
// Better in one, as good in the other; what is within the study's own repeatability is as good.
function beats(a, b, metric) {
  const { cost, error, floor } = page.same;
  const own = Math.max(a[metric], floor), other = Math.max(b[metric], floor);
  return a.cost_relative <= b.cost_relative * (1 + cost) && own <= other * (1 + error) &&
    (a.cost_relative < b.cost_relative * (1 - cost) || own < other * (1 - error));
}
function pareto() {
  choose("#pareto-controls", "error", metrics, state.metric, v => { state.metric = v; redraw(); });
  const chart = new PointChart("#front", { width: 1100, height: 520, left: 66, logX: true, logY: true, xLabel: "cost relative to exact", yLabel: "error" });
  redraws.push(() => {
    const metric = state.metric, ranks = study.ranking.filter(r => state.shown.has(r.model));
    const tiny = 1e-7, series = [];
    for (const rank of ranks) {
      const points = study.results.filter(r => r.model === rank.model)
        .map(r => [rank.cost_relative, Math.max(r[metric], tiny), `${r.model} on ${r.material}\n${metric} ${number(r[metric])}`]);
      series.push({ name: rank.model, colour: styleOf(rank.model).colour, opacity: 0.35, size: 3, points });
    }
    for (const rank of ranks) {
      const text = `${rank.model}, all materials\n${metric} ${number(rank[metric])}\ncost ${number(rank.cost_relative)}`;
      series.push({ name: rank.model + " all", label: rank.model, colour: styleOf(rank.model).colour, size: 7,
        points: [[rank.cost_relative, Math.max(rank[metric], tiny), text]] });
    }
    const front = ranks.filter(r => !ranks.some(o => beats(o, r, metric)))
      .sort((a, b) => a.cost_relative - b.cost_relative);
    series.push({ name: "front", line: true, colour: "#5b6570", points: front.map(r => [r.cost_relative, Math.max(r[metric], tiny)]) });
    chart.yLabel.text(metrics.find(m => m[0] === metric)[1]);
    // Room for the labels, which stand to the right of their marks.
    const costs = ranks.map(r => r.cost_relative);
    chart.set(series, ranks.length ? { x: [0.85 * d3.min(costs), 2 * d3.max(costs)] } : {});
  });
}

function tables() {
  chooseMaterial("#table-controls");
  redraws.push(() => {
    const m = state.material, others = study.materials[m].other_tables;
    const root = d3.select("#table-chart").html("");
    if (!others.length) { root.append("p").text("The library has no other table of this material over these wavelengths."); }
    const bars = others.map(o => ({ name: o.table, value: o.delta_e_mean, colour: "#98a1aa" }))
      .concat(shownNames().filter(n => n !== "exact").map(n => ({ name: n, value: result(m, n).delta_e_mean, colour: styleOf(n).colour })))
      .sort((a, b) => b.value - a.value);
    const height = 22 * bars.length + 46, width = 900, left = 260;
    const svg = root.append("div").attr("class", "chart").append("svg").attr("viewBox", `0 0 ${width} ${height}`).style("max-width", width + "px");
    const x = d3.scaleLinear().domain([0, (d3.max(bars, b => b.value) || 1) * 1.05]).range([left, width - 60]);
    svg.append("g").attr("class", "axis").attr("transform", `translate(0,${height - 34})`).call(d3.axisBottom(x).ticks(8, "~g"));
    svg.append("text").attr("class", "label").attr("x", (left + width - 60) / 2).attr("y", height - 3).attr("text-anchor", "middle")
      .text(`ΔE00, mean over angles, against ${study.materials[m].table}: other measurements (grey) and models`);
    const row = svg.selectAll("g.row").data(bars).enter().append("g").attr("transform", (d, i) => `translate(0,${4 + 22 * i})`);
    row.append("text").attr("x", left - 10).attr("y", 13).attr("text-anchor", "end").attr("font-size", 12.5).text(b => b.name);
    row.append("rect").attr("x", left).attr("y", 3).attr("height", 13).attr("width", b => x(b.value) - left).attr("fill", b => b.colour);
    row.append("text").attr("x", b => x(b.value) + 6).attr("y", 13).attr("font-size", 12).attr("fill", "#5b6570").text(b => number(b.value));
    table("#table-list", [
      { title: "table", text: true, value: o => o.table }, { title: "max |ΔR|", value: o => o.max_abs_difference },
      { title: "mean |ΔR|", value: o => o.mean_abs_difference }, { title: "RMS", value: o => o.rms_difference },
      { title: "ΔE<sub>00</sub> mean", value: o => o.delta_e_mean }, { title: "ΔE<sub>00</sub> max", value: o => o.delta_e_max },
      { title: "ΔE<sub>00</sub> albedo", value: o => o.delta_e_albedo }], others);
  });
}

function method() {
  const grid = study.grid, list = d3.select("#method-text").append("dl");
  const span = v => v.length > 1 ? `${number(v[0])} to ${number(v[v.length - 1])} in ${v.length - 1} steps of ${number(v[1] - v[0])}` : number(v[0]);
  const facts = [
    ["command", study.command], ["program", `karat ${study.karat} ${study.commit}`], ["wavelengths (nm)", span(grid.wavelengths_nm)],
    ["angles (degrees)", span(grid.angles_deg)], ["weighting", "none: every point of the grid counts the same"],
    ["reference", "the exact equations in double precision; models run by the renderer's kernel in single precision"],
    ["this page's charts", `the grid at every ${page.stride === 1 ? "wavelength" : page.stride + ". wavelength"}, to 1/65535; the files csv/*.csv beside it hold every number`],
    ["processor", study.machine.processor], ["compiler", `${study.machine.compiler}: ${study.machine.flags}`]];
  for (const [name, text] of facts) { list.append("dt").text(name); list.append("dd").text(text); }
  const models = d3.select("#method-text").append("div").attr("class", "scroll");
  table(models.node(), [{ title: "model", text: true, value: m => m.model }, { title: "what it computes", text: true, value: m => m.description },
    { title: "source", text: true, value: m => m.source }], study.models);
  const sources = d3.select("#method-text").append("div").attr("class", "scroll");
  table(sources.node(), [{ title: "table", text: true, value: m => m.table }, { title: "reference", text: true, value: m => m.reference }], study.materials);
}

legend();
[summary, reflectance, errors, colour, cost, render, pareto, tables, method].forEach(section => section());
d3.select("#contents").selectAll("a").data(Array.from(document.querySelectorAll("section"))).enter().append("a")
  .attr("href", s => "#" + s.id).text(s => s.dataset.title);
redraw();
document.body.dataset.ready = "yes";
