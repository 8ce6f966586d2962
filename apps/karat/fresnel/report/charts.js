"use strict";
// Charts on D3 (5 or newer) that every section uses: lines and points that zoom, show values under
// the pointer, and are redrawn when models are switched.

const tip = d3.select("#tip");
function showTip(event, text) {
  tip.style("display", "block").text(text);
  const box = tip.node().getBoundingClientRect();
  const x = event.clientX + 16 + box.width > innerWidth ? event.clientX - 16 - box.width : event.clientX + 16;
  const y = Math.min(event.clientY + 12, innerHeight - box.height - 4);
  tip.style("left", Math.max(0, x) + "px").style("top", Math.max(0, y) + "px");
}
const hideTip = () => tip.style("display", "none");

const significant = d3.format(".3~g");
function number(value) {
  if (value === null || value === undefined || !isFinite(value)) return "-";
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size < 1e-3 || size >= 1e5) return d3.format(".2~e")(value).replace("−", "-");
  return significant(value).replace("−", "-");
}

// Whether D3's fixed decimals would run out of room.
const small = scale => d3.max(scale.domain(), Math.abs) < 1e-3;

// A chart's frame: axes, grid, clip, zoom with the wheel and by dragging, back by a double click.
class Frame {
  constructor(parent, options) {
    this.options = Object.assign({ width: 640, height: 340, left: 72, right: 22, top: 8, bottom: 42 }, options);
    const o = this.options;
    this.root = d3.select(parent).append("div").attr("class", "chart");
    this.title = this.root.append("h3");
    this.svg = this.root.append("svg").attr("viewBox", `0 0 ${o.width} ${o.height}`).attr("role", "img");
    const clip = "clip" + Frame.count++;
    const w = o.width - o.left - o.right, h = o.height - o.top - o.bottom;
    this.inner = { w, h };
    this.svg.append("clipPath").attr("id", clip).append("rect").attr("width", w).attr("height", h);
    const g = this.svg.append("g").attr("transform", `translate(${o.left},${o.top})`);
    this.gridX = g.append("g").attr("class", "grid").attr("transform", `translate(0,${h})`);
    this.gridY = g.append("g").attr("class", "grid");
    this.axisX = g.append("g").attr("class", "axis").attr("transform", `translate(0,${h})`);
    this.axisY = g.append("g").attr("class", "axis");
    this.plot = g.append("g").attr("clip-path", `url(#${clip})`);
    this.cursor = g.append("line").attr("stroke", "#8a939c").attr("y2", h).style("display", "none");
    this.svg.append("text").attr("class", "label").attr("text-anchor", "middle")
      .attr("x", o.left + w / 2).attr("y", o.height - 6).text(o.xLabel);
    this.yLabel = this.svg.append("text").attr("class", "label").attr("text-anchor", "middle")
      .attr("transform", `translate(13,${o.top + h / 2}) rotate(-90)`).text(o.yLabel);
    this.surface = g.append("rect").attr("width", w).attr("height", h).attr("fill", "transparent");
    this.reset = this.root.append("button").attr("class", "reset").style("display", "none").text("whole range")
      .on("click", () => this.surface.call(this.zoom.transform, d3.zoomIdentity));
    this.transform = d3.zoomIdentity;
    this.zoom = d3.zoom().duration(0).scaleExtent([1, 60]).extent([[0, 0], [w, h]]).translateExtent([[0, 0], [w, h]])
      .filter(() => { const e = window.event; return !e || e.type !== "wheel" || e.ctrlKey || e.shiftKey; })
      .on("zoom", event => {
        this.transform = (event && event.transform ? event : d3.event).transform;
        this.reset.style("display", this.transform.k === 1 ? "none" : "block");
        this.draw();
      });
    this.surface.call(this.zoom);
    this.surface.node().addEventListener("mousemove", e => this.hover(e));
    this.surface.node().addEventListener("mouseleave", () => { hideTip(); this.cursor.style("display", "none"); });
    this.series = [];
    this.x = this.x0 = o.logX ? d3.scaleLog() : d3.scaleLinear();
    this.y = this.y0 = o.logY ? d3.scaleLog() : d3.scaleLinear();
  }
  // `extent` may hold x and y domains; without them the visible series decide.
  set(series, extent = {}) {
    this.series = series;
    const points = [].concat(...series.map(s => s.points));
    const range = (values, log) => {
      let [low, high] = d3.extent(values.filter(v => isFinite(v) && (!log || v > 0)));
      if (low === undefined) return log ? [0.1, 1] : [0, 1];
      if (log) return [low / 1.3, high * 1.3];
      if (low === high) return [low - 0.5, high + 0.5];
      return [low, high];
    };
    this.x0.domain(extent.x || range(points.map(p => p[0]), this.options.logX)).range([0, this.inner.w]);
    this.y0.domain(extent.y || range(points.map(p => p[1]), this.options.logY)).range([this.inner.h, 0]);
    if (!extent.y && !this.options.logY) this.y0.nice();
    this.draw();
  }
  draw() {
    this.x = this.transform.rescaleX(this.x0);
    this.y = this.transform.rescaleY(this.y0);
    const { w, h } = this.inner;
    const ticks = (axis, scale, log, count) => log ? axis(scale).ticks(count, "~g") : axis(scale).ticks(count).tickFormat(small(scale) ? number : null);
    this.axisX.call(ticks(d3.axisBottom, this.x, this.options.logX, 8));
    this.axisY.call(ticks(d3.axisLeft, this.y, this.options.logY, 6));
    this.gridX.call(ticks(d3.axisBottom, this.x, this.options.logX, 8).tickSize(-h).tickFormat(""));
    this.gridY.call(ticks(d3.axisLeft, this.y, this.options.logY, 6).tickSize(-w).tickFormat(""));
    this.drawSeries();
  }
  at(event) {
    const point = this.svg.node().createSVGPoint();
    point.x = event.clientX; point.y = event.clientY;
    const p = point.matrixTransform(this.surface.node().getScreenCTM().inverse());
    return [p.x, p.y];
  }
}
Frame.count = 0;

class LineChart extends Frame {
  drawSeries() {
    const line = d3.line().defined(p => isFinite(p[1])).x(p => this.x(p[0])).y(p => this.y(p[1]));
    const paths = this.plot.selectAll("path.line").data(this.series, s => s.name);
    paths.exit().remove();
    paths.enter().append("path").attr("class", "line").attr("fill", "none").merge(paths)
      .attr("stroke", s => s.colour).attr("stroke-width", s => s.width || 1.6)
      .attr("stroke-dasharray", s => s.dash || null).attr("d", s => line(s.points));
    const single = this.series.filter(s => s.points.length === 1);
    const dots = this.plot.selectAll("circle.dot").data(single, s => s.name);
    dots.exit().remove();
    dots.enter().append("circle").attr("class", "dot").attr("r", 4).merge(dots).attr("fill", s => s.colour)
      .attr("cx", s => this.x(s.points[0][0])).attr("cy", s => this.y(s.points[0][1]));
  }
  hover(event) {
    const any = this.series.find(s => s.points.length);
    if (!any) return;
    const at = this.x.invert(this.at(event)[0]);
    const nearest = points => points.reduce((a, b) => Math.abs(b[0] - at) < Math.abs(a[0] - at) ? b : a);
    const x = nearest(any.points)[0];
    this.cursor.style("display", null).attr("x1", this.x(x)).attr("x2", this.x(x));
    const lines = this.series.map(s => [s.name, nearest(s.points)[1]]).sort((a, b) => b[1] - a[1]);
    showTip(event, `${this.options.xName || "x"} ${number(x)} ${this.options.xUnit || ""}\n` +
      lines.map(([name, y]) => `${number(y).padStart(9)}  ${name}`).join("\n"));
  }
}

// Series of points with text of their own: {name, colour, points: [[x, y, text], ...], size, shape}.
class PointChart extends Frame {
  drawSeries() {
    const all = [].concat(...this.series.filter(s => !s.line).map(s => s.points.map(p => ({ s, p }))));
    const lines = this.plot.selectAll("path.front").data(this.series.filter(s => s.line));
    lines.exit().remove();
    lines.enter().append("path").attr("class", "front").attr("fill", "none").merge(lines)
      .attr("stroke", s => s.colour).attr("stroke-width", 1.4).attr("stroke-dasharray", "5 4")
      .attr("d", s => d3.line().x(p => this.x(p[0])).y(p => this.y(p[1]))(s.points));
    const marks = this.plot.selectAll("circle").data(all);
    marks.exit().remove();
    marks.enter().append("circle").merge(marks).attr("r", d => d.s.size).attr("fill", d => d.s.colour)
      .attr("fill-opacity", d => d.s.opacity || 1).attr("stroke", d => d.s.size > 4 ? "#fff" : "none")
      .attr("cx", d => this.x(d.p[0])).attr("cy", d => this.y(d.p[1]));
    const named = all.filter(d => d.s.label);
    const texts = this.plot.selectAll("text").data(named);
    texts.exit().remove();
    texts.enter().append("text").attr("font-size", 12).merge(texts).text(d => d.s.label)
      .each((d, i, nodes) => this.place(d, d3.select(nodes[i])));
    this.spread(texts.enter().merge(texts));
  }
  place(d, text) {
    text.attr("x", this.x(d.p[0]) + 9).attr("y", this.y(d.p[1]) + 4);
  }
  // Moves labels apart upwards and downwards where they would cover each other.
  spread() {
    const nodes = this.plot.selectAll("text").nodes()
      .map(n => ({ n, box: n.getBBox(), y: +n.getAttribute("y") })).sort((a, b) => a.y - b.y);
    for (let round = 0; round < 30; ++round) {
      for (let i = 0; i < nodes.length; ++i) {
        for (let j = i + 1; j < nodes.length; ++j) {
          const a = nodes[i], b = nodes[j];
          const apart = a.box.x + a.box.width < b.box.x || b.box.x + b.box.width < a.box.x;
          const overlap = 13 - Math.abs(a.y - b.y);
          if (apart || overlap <= 0) continue;
          const up = a.y <= b.y ? -1 : 1;
          a.y += up * overlap / 2; b.y -= up * overlap / 2;
        }
      }
    }
    for (const { n, y } of nodes) n.setAttribute("y", Math.max(11, Math.min(this.inner.h - 3, y)));
  }
  hover(event) {
    const [px, py] = this.at(event);
    let best = null, distance = 18;
    for (const s of this.series) {
      if (s.line) continue;
      for (const p of s.points) {
        const d = Math.hypot(this.x(p[0]) - px, this.y(p[1]) - py);
        if (d < distance) { best = p; distance = d; }
      }
    }
    if (best) showTip(event, best[2]); else hideTip();
  }
}

// A table whose columns sort: columns are {title, value, text, format}.
function table(parent, columns, rows, rowClass) {
  const root = d3.select(parent).html("").append("table");
  const heads = root.append("thead").append("tr").selectAll("th").data(columns).enter().append("th")
    .attr("class", c => c.text ? "text" : null).attr("title", "sort").html(c => c.title);
  const body = root.append("tbody");
  let order = null;
  function fill(sorted) {
    const tr = body.html("").selectAll("tr").data(sorted).enter().append("tr").attr("class", rowClass || null);
    tr.selectAll("td").data(row => columns.map(c => [c, row])).enter().append("td")
      .attr("class", ([c]) => c.text ? "text" : null)
      .text(([c, row]) => c.text ? c.value(row) : (c.format || number)(c.value(row)));
  }
  heads.each((c, i, nodes) => nodes[i].addEventListener("click", () => {
    order = order && order.c === c ? { c, sign: -order.sign } : { c, sign: 1 };
    fill(rows.slice().sort((a, b) => order.sign * d3.ascending(c.value(a), c.value(b))));
  }));
  fill(rows);
}
